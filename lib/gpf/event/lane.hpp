// Four doubles that are worked on at once; every operation gives each of them the bits that a double would get.
#pragma once

#include <cstddef>
#include <limits>

#ifdef __AVX__
#include <immintrin.h>
#endif

namespace gpf {

using Lane = double __attribute__((vector_size(32)));
using HalfLane = double __attribute__((vector_size(16)));
inline constexpr int lane_width = 4;

/// A lane of that many doubles, and the one that is all NaN.
template <int width>
struct LaneOf;
template <>
struct LaneOf<2> {
  using Real = HalfLane;
  static constexpr std::size_t alignment = 32;  ///< of what holds a lane
  static constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  static constexpr Real nobody{nan, nan};
};
template <>
struct LaneOf<4> {
  using Real = Lane;
  static constexpr std::size_t alignment = 64;
  static constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  static constexpr Real nobody{nan, nan, nan, nan};
};

inline Lane join(HalfLane low, HalfLane high) { return __builtin_shufflevector(low, high, 0, 1, 2, 3); }

inline double positive_part(double a) { return a > 0 ? a : 0; }
inline Lane positive_part(Lane a) { return a > 0 ? a : Lane{}; }

/// Bit k is set when a comparison of lanes holds in place k.
template <class Mask>
unsigned bits(Mask mask) {
#ifdef __AVX__
  return static_cast<unsigned>(_mm256_movemask_pd(reinterpret_cast<__m256d>(mask)));
#else
  unsigned set = 0;
  for (int k = 0; k < lane_width; ++k) set |= (mask[k] != 0 ? 1u : 0u) << k;
  return set;
#endif
}

}  // namespace gpf
