// What fuzz targets share: a check that aborts, and what an error about a text must look like.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "gpf/base/error.hpp"

namespace gpf::fuzz {

inline void require(bool holds, std::string_view what) {
  if (holds) return;
  std::fprintf(stderr, "fuzz: %.*s\n", static_cast<int>(what.size()), what.data());
  std::abort();
}

/// The message names the file and says why and what to do.
inline void require_usable(const Error& error, std::string_view file) {
  require(std::string_view(error.what()).find(file) != std::string_view::npos, error.what());
  require(!error.why().empty() && !error.remedy().empty(), "an error without reason or remedy");
}

}  // namespace gpf::fuzz
