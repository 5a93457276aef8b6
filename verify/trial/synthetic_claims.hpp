// Claims whose truth is known: replicas drawn from stated distributions, for each kind of relation.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "gpf/base/random.hpp"
#include "verify/evidence.hpp"

namespace gpf {

/// Random numbers of one synthetic claim, a function of its key.
class Draws {
 public:
  explicit Draws(std::uint64_t key) : key_(key) {}
  double normal() { return gaussian_pair(key_, index_++).x; }
  /// Uniform on (0, 1).
  double uniform();

 private:
  std::uint64_t key_, index_ = 0;
};

/// What one replica yields.
using ReplicaValues = std::vector<double>;

struct SyntheticClaim {
  std::string kind, truth;                                                      ///< "value", "centre"
  double most_pass = 1, most_fail = 1;                                          ///< what judge.hpp states; 1: nothing
  std::function<ReplicaValues(Draws&)> replica;                                 ///< draws the next one
  std::function<std::vector<Check>(const std::vector<ReplicaValues>&)> checks;  ///< of all so far
  int most_replicas = 16;
  bool large = false;  ///< of many checks: judged less often, to save time
};

/// Unit of all: the tolerance, half the width of the band; the replicas' deviation is half of it (verdicts with well
/// chosen runs) unless the kind says otherwise.
inline constexpr double synthetic_deviation = 0.5;

/// One check of a value within +-1, or above 0 when `one_sided`, of true value `truth`.
SyntheticClaim value_claim(double truth, bool one_sided);

/// Every kind with its truth at the centre of the band (or well inside it), on an edge, and a tolerance outside.
std::vector<SyntheticClaim> synthetic_claims();

}  // namespace gpf
