// A length of time as a person says it.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>

namespace gpf {

/// "42 s", "3 min 07 s", "2 h 05 min"; "-" for what is not finite, or negative.
inline std::string duration_text(double seconds) {
  if (!(std::isfinite(seconds) && seconds >= 0)) return "-";
  const long s = std::lround(seconds);
  if (s < 60) return fmt::format("{} s", s);
  if (s < 3600) return fmt::format("{} min {:02} s", s / 60, s % 60);
  return fmt::format("{} h {:02} min", s / 3600, s / 60 % 60);
}

}  // namespace gpf
