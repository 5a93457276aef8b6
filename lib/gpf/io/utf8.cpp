#include "gpf/io/utf8.hpp"

#include <nlohmann/json.hpp>

namespace gpf {

std::string xml_characters(const std::string& text) {
  using nlohmann::json;  // its replacing dump is the shortest way to valid UTF-8
  std::string valid = json::parse(json(text).dump(-1, ' ', false, json::error_handler_t::replace)).get<std::string>();
  for (std::size_t i = 0; i < valid.size(); ++i) {
    const auto code = static_cast<unsigned char>(valid[i]);
    const std::string_view three = std::string_view(valid).substr(i, 3);
    if (three == "\xef\xbf\xbe" || three == "\xef\xbf\xbf") valid.replace(i, 3, "\xef\xbf\xbd");
    if (code < 0x20 || code == 0x7f) valid[i] = ' ';
  }
  return valid;
}

}  // namespace gpf
