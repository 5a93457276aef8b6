// Two hashes: of a text (names of scenes and records) and of a trajectory (the trace hash).
#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>

namespace gpf {

/// Mixes 64 bits so that every input bit moves every output bit (the finaliser of SplitMix64,
/// Steele, Lea & Flood, OOPSLA 2014).
constexpr std::uint64_t mix(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

/// FNV-1a of a text, mixed.
constexpr std::uint64_t hash_text(std::string_view text) {
  std::uint64_t h = 0xcbf29ce484222325u;
  for (const char c : text) h = (h ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  return mix(h);
}

/// Sixteen hexadecimal digits.
std::string hexadecimal(std::uint64_t value);

/// Hash of the set of collisions of a run. Events enter by addition, so that the hash depends on which
/// collisions happened and when, to the last bit, but not on the order in which independent ones were executed.
class TraceHash {
 public:
  constexpr TraceHash() = default;
  constexpr explicit TraceHash(std::uint64_t value) : value_(value) {}

  /// Adds the collision of disks a and b (b negative: a wall) at `time` after the start of epoch `epoch`.
  constexpr void add(std::int64_t epoch, double time, std::int32_t a, std::int32_t b) {
    const auto lo = static_cast<std::uint32_t>(a < b ? a : b), hi = static_cast<std::uint32_t>(a < b ? b : a);
    const std::uint64_t pair = (std::uint64_t{hi} << 32) | lo;
    value_ += mix(mix(std::bit_cast<std::uint64_t>(time) + 0x9e3779b97f4a7c15u * static_cast<std::uint64_t>(epoch)) ^ pair);
  }

  [[nodiscard]] constexpr std::uint64_t value() const { return value_; }
  friend constexpr bool operator==(TraceHash, TraceHash) = default;

 private:
  std::uint64_t value_ = 0;
};

}  // namespace gpf
