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

/// Numbers are read in pairs, as they lie in memory.
inline Abreast abreast(const Disk& a, const Disk& b, const Disk& c, const Disk& d) {
  static_assert(offsetof(Disk, flight) == 0 && offsetof(Disk, contact) == sizeof(Flight));
  using Pair = double __attribute__((vector_size(16)));
  const auto pairs = [](const Disk& first, const Disk& second, std::size_t k) {
    Pair low, high;
    std::memcpy(&low, reinterpret_cast<const std::byte*>(&first) + k * sizeof low, sizeof low);
    std::memcpy(&high, reinterpret_cast<const std::byte*>(&second) + k * sizeof high, sizeof high);
    return __builtin_shufflevector(low, high, 0, 1, 2, 3);
  };
  const auto even = [](Lane ac, Lane bd) { return __builtin_shufflevector(ac, bd, 0, 4, 2, 6); };
  const auto odd = [](Lane ac, Lane bd) { return __builtin_shufflevector(ac, bd, 1, 5, 3, 7); };
  const Lane r_ac = pairs(a, c, 0), r_bd = pairs(b, d, 0), v_ac = pairs(a, c, 1), v_bd = pairs(b, d, 1);
  const Lane t_ac = pairs(a, c, 2), t_bd = pairs(b, d, 2);
  return {{even(r_ac, r_bd), odd(r_ac, r_bd), even(v_ac, v_bd), odd(v_ac, v_bd), even(t_ac, t_bd)}, odd(t_ac, t_bd)};
}

}  // namespace gpf
