// Colours from slow to fast.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace gpf {

using Rgb = std::array<std::uint8_t, 3>;

/// Viridis (S. van der Walt & N. Smith, matplotlib, CC0) at nine equal steps: it reads alike for the colour-blind and
/// in grey.
inline constexpr std::array<Rgb, 9> palette{{{68, 1, 84},
                                             {71, 44, 122},
                                             {59, 81, 139},
                                             {44, 113, 142},
                                             {33, 144, 141},
                                             {39, 173, 129},
                                             {92, 200, 99},
                                             {170, 220, 50},
                                             {253, 231, 37}}};

/// The colour at a level between 0 and 1; what lies outside has the colour of the end.
inline Rgb colour_at(double level) {
  const double place = std::clamp(level, 0.0, 1.0) * (palette.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), palette.size() - 2);
  Rgb colour{};
  for (std::size_t c = 0; c < colour.size(); ++c)
    colour[c] = static_cast<std::uint8_t>(
        std::lround(std::lerp(palette[below][c], palette[below + 1][c], place - static_cast<double>(below))));
  return colour;
}

}  // namespace gpf
