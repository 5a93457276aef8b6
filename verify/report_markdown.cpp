#include "verify/report_markdown.hpp"

#include <cctype>

namespace gpf {
namespace {

bool is_alphanumeric(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; }

/// What stands for `c` between the characters `before` and `after` (0 at the ends).
std::string escaped(char before, char c, char after) {
  switch (c) {
    case '\\':
      return "&#92;";  // a second backslash would meet the rules for pipes in tables
    case '`':
    case '*':
    case '~':
    case '$':  // GitHub typesets formulas between two of them
      return {'\\', c};
    case '_':  // within a word, as in u_x, it means nothing
      return is_alphanumeric(before) && is_alphanumeric(after) ? "_" : "\\_";
    case ']':  // only before these does it end the text of a link; "[0.1, 0.2]" stays
      return after == '(' || after == '[' || after == ':' ? "\\]" : "]";
    case '[':
      return after == '^' ? "\\[" : "[";  // a footnote
    case '<':
      return is_alphanumeric(after) || after == '/' || after == '!' || after == '?' ? "&lt;" : "<";
    case '&':
      return is_alphanumeric(after) || after == '#' ? "&amp;" : "&";
    default:
      return std::isspace(static_cast<unsigned char>(c)) != 0 || static_cast<unsigned char>(c) < 0x20
                 ? std::string(1, ' ')
                 : std::string(1, c);
  }
}

/// Length of what would start a list item, heading or quotation at the beginning of a line, without its last character;
/// npos when nothing would.
std::size_t block_mark(std::string_view text) {
  if (text.empty()) return std::string_view::npos;
  if (std::string_view("#>+-=").find(text.front()) != std::string_view::npos) return 0;
  std::size_t digits = 0;
  while (digits < text.size() && std::isdigit(static_cast<unsigned char>(text[digits])) != 0) ++digits;
  const bool numbered = digits > 0 && digits < text.size() && (text[digits] == '.' || text[digits] == ')') &&
                        (digits + 1 == text.size() || text[digits + 1] == ' ');
  return numbered ? digits : std::string_view::npos;
}

}  // namespace

std::string markdown_text(std::string_view text) {
  const std::size_t start = text.find_first_not_of(" \t\r\n");
  if (start == std::string_view::npos) return {};
  text = text.substr(start, text.find_last_not_of(" \t\r\n") + 1 - start);
  const std::size_t mark = block_mark(text);
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char before = i > 0 ? text[i - 1] : '\0', after = i + 1 < text.size() ? text[i + 1] : '\0';
    if (i == mark) result += '\\';
    result += escaped(before, text[i], after);
  }
  return result;
}

}  // namespace gpf
