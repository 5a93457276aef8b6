// Random numbers that are a pure function of (key, stream, index): no state to save, no lagged streams.
#pragma once

#include <array>
#include <cstdint>

#include "gpf/base/vec2.hpp"

namespace gpf {

/// Philox 4x32-10 (Salmon et al., SC 2011): four independent 32-bit words for each (key, stream, index).
std::array<std::uint32_t, 4> random_words(std::uint64_t key, std::uint64_t stream, std::uint64_t index);

/// Seed of replica `replica` of a scene: independent of every other (scene hash, replica).
std::uint64_t replica_seed(std::uint64_t scene_hash, std::uint64_t replica);

/// Natural logarithm from + - * / only, for x > 0 and finite; the same bits on every machine,
/// within 3.4e-16 relative of the true value (largest seen 3.3e-16, near x = 0.776).
double portable_log(double x);

/// Two independent standard normal numbers for (key, index), by Marsaglia's polar method with portable_log.
Vec2 gaussian_pair(std::uint64_t key, std::uint64_t index);

}  // namespace gpf
