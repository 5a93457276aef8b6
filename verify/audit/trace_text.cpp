#include <fmt/format.h>

#include <sstream>

#include "gpf/base/error.hpp"
#include "gpf/base/hash.hpp"
#include "verify/audit/trace.hpp"

namespace gpf {
namespace {

/// One T from each line, by `read`, which must use up all of it.
template <class T, class Read>
std::vector<T> parse_lines(std::string_view text, Read read) {
  std::vector<T> result;
  std::istringstream lines{std::string(text)};
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    T item;
    std::string rest;
    if (!read(words, item) || words >> rest)
      throw InputError(fmt::format("'{}' is not a line of a trace", line), "gpf trace prints other lines",
                       "compare programs that have the command trace");
    result.push_back(item);
  }
  return result;
}

/// Through strtod: streams do not read every double that they print (denormals).
bool read_double(std::istream& words, double& value) {
  std::string word;
  if (!(words >> word)) return false;
  char* end = nullptr;
  value = std::strtod(word.c_str(), &end);
  return end == word.c_str() + word.size();
}

}  // namespace

std::string text_of(const EpochMark& mark) {
  return fmt::format("{} {} {} {}", mark.epoch, hexadecimal(mark.trace_hash), mark.contacts,
                     hexadecimal(mark.state_hash));
}

std::string text_of(const TracedContact& c) {
  return fmt::format("{:.17g} {} {} {:.17g} {:.17g} {:.17g} {:.17g}", c.time, c.first, c.second, c.velocity[0],
                     c.velocity[1], c.velocity[2], c.velocity[3]);
}

std::vector<EpochMark> parse_marks(std::string_view text) {
  return parse_lines<EpochMark>(text, [](std::istream& words, EpochMark& m) {
    return static_cast<bool>(words >> m.epoch >> std::hex >> m.trace_hash >> std::dec >> m.contacts >> std::hex >>
                             m.state_hash);
  });
}

std::vector<TracedContact> parse_contacts(std::string_view text) {
  return parse_lines<TracedContact>(text, [](std::istream& words, TracedContact& c) {
    if (!read_double(words, c.time) || !(words >> c.first >> c.second)) return false;
    for (double& v : c.velocity)
      if (!read_double(words, v)) return false;
    return true;
  });
}

}  // namespace gpf
