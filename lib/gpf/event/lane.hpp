// Four doubles that are worked on at once; every operation gives each of them the bits that a double would get.
#pragma once

#ifdef __AVX__
#include <immintrin.h>
#endif

namespace gpf {

using Lane = double __attribute__((vector_size(32)));
inline constexpr int lane_width = 4;

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
