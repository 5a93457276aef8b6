// A few doubles that are worked on at once; every operation gives each of them the bits that a double would get.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>

#ifdef __SSE2__
#include <immintrin.h>
#endif

#include "gpf/event/disk.hpp"

namespace gpf {

/// As many as the widest register holds: compilers take what is wider apart number by number. What is made of lanes and
/// does not name them in its symbol bears GPF_LANES, which does: a program may be compiled for other registers than the
/// library that it uses.
#ifdef __AVX__
constexpr unsigned lane_width = 4;
#define GPF_LANES [[gnu::abi_tag("lanes4")]]
#else
constexpr unsigned lane_width = 2;
#define GPF_LANES [[gnu::abi_tag("lanes2")]]
#endif
using Lane = double __attribute__((vector_size(lane_width * sizeof(double))));

/// A lane of equal doubles. (Less zero, which changes no bit: plus zero would cost an addition.)
GPF_LANES inline Lane alike(double a) { return a - Lane{}; }

inline double positive_part(double a) { return a > 0 ? a : 0; }
inline Lane positive_part(Lane a) { return a > 0 ? a : Lane{}; }

inline double later(double a, double b) { return a > b ? a : b; }
inline Lane later(double a, Lane b) { return a > b ? alike(a) : b; }

inline double square_root(double a) { return std::sqrt(a); }
inline Lane square_root(Lane a) {
#if defined(__AVX__)
  return reinterpret_cast<Lane>(_mm256_sqrt_pd(reinterpret_cast<__m256d>(a)));
#elif defined(__SSE2__)
  return reinterpret_cast<Lane>(_mm_sqrt_pd(reinterpret_cast<__m128d>(a)));
#else
  return Lane{std::sqrt(a[0]), std::sqrt(a[1])};
#endif
}

/// Bit k is set when a comparison of vectors holds in place k.
template <class Mask>
GPF_LANES unsigned bits(Mask mask) {
#ifdef __AVX__
  if constexpr (sizeof mask == 32 && sizeof mask[0] == 8)
    return static_cast<unsigned>(_mm256_movemask_pd(reinterpret_cast<__m256d>(mask)));
  if constexpr (sizeof mask == 32 && sizeof mask[0] == 4)
    return static_cast<unsigned>(_mm256_movemask_ps(reinterpret_cast<__m256>(mask)));
#endif
#ifdef __SSE2__
  if constexpr (sizeof mask == 16 && sizeof mask[0] == 8)
    return static_cast<unsigned>(_mm_movemask_pd(reinterpret_cast<__m128d>(mask)));
#endif
  unsigned set = 0;
  for (unsigned k = 0; k < sizeof mask / sizeof mask[0]; ++k) set |= (mask[k] != 0 ? 1u : 0u) << k;
  return set;
}

/// Two doubles lie side by side at each of the addresses at(0), at(1), ...: all the first ones, all the second ones.
template <class At>
GPF_LANES [[gnu::always_inline]] inline std::array<Lane, 2> columns(At&& at) {
#ifdef __AVX__
  const auto halves = [&](unsigned low, unsigned high) {
    const void *first = at(low), *second = at(high);
    return reinterpret_cast<Lane>(
        _mm256_loadu2_m128d(static_cast<const double*>(second), static_cast<const double*>(first)));
  };
  const Lane ac = halves(0, 2), bd = halves(1, 3);
  return {__builtin_shufflevector(ac, bd, 0, 4, 2, 6), __builtin_shufflevector(ac, bd, 1, 5, 3, 7)};
#else
  Lane a, b;
  std::memcpy(&a, at(0), sizeof a);
  std::memcpy(&b, at(1), sizeof b);
  return {__builtin_shufflevector(a, b, 0, 2), __builtin_shufflevector(a, b, 1, 3)};
#endif
}

/// Disks side by side: their flights, and the contacts that they have found.
struct GPF_LANES Abreast {
  FlightOf<Lane> flight;
  Lane contact;
};

/// The disks disk(0), disk(1), ... Their numbers are read in pairs, as they lie in memory.
template <class DiskAt>
GPF_LANES [[gnu::always_inline]] inline Abreast abreast(DiskAt&& disk) {
  const auto numbers = [&](std::size_t first) {
    return columns([&](unsigned k) { return reinterpret_cast<const std::byte*>(&disk(k)) + first * sizeof(double); });
  };
  const auto [x, y] = numbers(0);
  const auto [vx, vy] = numbers(2);
  const auto [time, contact] = numbers(4);
  return {{x, y, vx, vy, time}, contact};
}

}  // namespace gpf
