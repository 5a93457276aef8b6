// Four doubles that are worked on at once; every operation gives each of them the bits that a double would get.
#pragma once

#include <cmath>

#ifdef __AVX__
#include <immintrin.h>
#endif

#include "gpf/event/disk.hpp"

namespace gpf {

using Lane = double __attribute__((vector_size(32)));
inline constexpr unsigned lane_width = 4;

inline double positive_part(double a) { return a > 0 ? a : 0; }
inline Lane positive_part(Lane a) { return a > 0 ? a : Lane{}; }

inline double later(double a, double b) { return a > b ? a : b; }
inline Lane later(double a, Lane b) { return a > b ? Lane{a, a, a, a} : b; }

inline double square_root(double a) { return std::sqrt(a); }
inline Lane square_root(Lane a) {
#ifdef __AVX__
  return reinterpret_cast<Lane>(_mm256_sqrt_pd(reinterpret_cast<__m256d>(a)));
#else
  return Lane{std::sqrt(a[0]), std::sqrt(a[1]), std::sqrt(a[2]), std::sqrt(a[3])};
#endif
}

/// Bit k is set when a comparison of lanes holds in place k.
template <class Mask>
unsigned bits(Mask mask) {
#ifdef __AVX__
  return static_cast<unsigned>(_mm256_movemask_pd(reinterpret_cast<__m256d>(mask)));
#else
  unsigned set = 0;
  for (unsigned k = 0; k < lane_width; ++k) set |= (mask[k] != 0 ? 1u : 0u) << k;
  return set;
#endif
}

/// Four flights side by side.
inline FlightOf<Lane> abreast(const Flight& a, const Flight& b, const Flight& c, const Flight& d) {
  const Lane ra{a.x, a.y, a.vx, a.vy}, rb{b.x, b.y, b.vx, b.vy}, rc{c.x, c.y, c.vx, c.vy}, rd{d.x, d.y, d.vx, d.vy};
  const Lane even_ab = __builtin_shufflevector(ra, rb, 0, 4, 2, 6),
             odd_ab = __builtin_shufflevector(ra, rb, 1, 5, 3, 7);
  const Lane even_cd = __builtin_shufflevector(rc, rd, 0, 4, 2, 6),
             odd_cd = __builtin_shufflevector(rc, rd, 1, 5, 3, 7);
  return {__builtin_shufflevector(even_ab, even_cd, 0, 1, 4, 5), __builtin_shufflevector(odd_ab, odd_cd, 0, 1, 4, 5),
          __builtin_shufflevector(even_ab, even_cd, 2, 3, 6, 7), __builtin_shufflevector(odd_ab, odd_cd, 2, 3, 6, 7),
          Lane{a.time, b.time, c.time, d.time}};
}

}  // namespace gpf
