// Four doubles that are worked on at once; every operation gives each of them the bits that a double would get.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstring>

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

/// Four disks side by side: their flights, and the contacts that they have found.
struct Abreast {
  FlightOf<Lane> flight;
  Lane contact;
};

/// Two doubles that lie side by side at each of two places.
inline Lane pairs(const void* first, const void* second) {
  using Pair = double __attribute__((vector_size(16)));
  Pair low, high;
  std::memcpy(&low, first, sizeof low);
  std::memcpy(&high, second, sizeof high);
  return __builtin_shufflevector(low, high, 0, 1, 2, 3);
}
/// Of such pairs of a and c, b and d: the first numbers of a, b, c, d, and the second.
inline Lane firsts(Lane ac, Lane bd) { return __builtin_shufflevector(ac, bd, 0, 4, 2, 6); }
inline Lane seconds(Lane ac, Lane bd) { return __builtin_shufflevector(ac, bd, 1, 5, 3, 7); }

/// Numbers are read in pairs, as they lie in memory.
inline Abreast abreast(const Disk& a, const Disk& b, const Disk& c, const Disk& d) {
  const auto of = [](const Disk& first, const Disk& second, std::size_t number) {
    return pairs(reinterpret_cast<const std::byte*>(&first) + number * sizeof(double),
                 reinterpret_cast<const std::byte*>(&second) + number * sizeof(double));
  };
  const Lane r_ac = of(a, c, 0), r_bd = of(b, d, 0), v_ac = of(a, c, 2), v_bd = of(b, d, 2);
  const Lane t_ac = of(a, c, 4), t_bd = of(b, d, 4);
  return {{firsts(r_ac, r_bd), seconds(r_ac, r_bd), firsts(v_ac, v_bd), seconds(v_ac, v_bd), firsts(t_ac, t_bd)},
          seconds(t_ac, t_bd)};
}

}  // namespace gpf
