#include "verify/command_text.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace gpf {
namespace {

bool is_plain(const std::string& text) {
  return std::all_of(text.begin(), text.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || std::string_view("/._-+").find(static_cast<char>(c)) != std::string_view::npos;
  });
}

std::string option(const std::string& name, const std::filesystem::path& folder, std::string_view usual) {
  if ((folder / "").parent_path().filename() == usual) return {};
  const std::string text = folder.string();
  return " " + name + " " + (is_plain(text) ? text : shell_word(text));
}

}  // namespace

std::string shell_word(const std::string& text) {
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

std::string folder_options(const std::filesystem::path& reference, const std::filesystem::path& store) {
  return option("--reference", reference, "reference") + option("--store", store, "records");
}

}  // namespace gpf
