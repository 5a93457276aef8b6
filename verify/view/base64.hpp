// Bytes as text.
#pragma once

#include <string>
#include <string_view>

namespace gpf {

/// RFC 4648 with padding, without line breaks: what a browser's atob() reads.
std::string base64(std::string_view bytes);

}  // namespace gpf
