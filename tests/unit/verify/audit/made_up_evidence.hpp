// Evidence of two versions that never ran.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "verify/audit/evidence_set.hpp"

namespace gpf::test {

/// Two runs, and a claim with a number of 16 replicas scattered by 1 about 10 (band +-8) and an identity.
inline EvidenceSet made_up_evidence() {
  EvidenceSet set;
  for (const std::string name : {"alpha #1", "beta #1"}) {
    RunDigest& run = set.runs[name];
    run.name = name;
    run.trace_hash = name.size();
    run.measured = 1;
    run.contacts = 1000 + name.size();
    run.sums = run.sizes = {1, 2, 4};
    run.cpu_seconds = 2;
    run.build = R"({"compiler": "gcc 12", "flags": "-O2", "libraries": {"HDF5": "1.10"}})";
  }
  ClaimEstimate number{"claim", "a number", {}, {2, 18}, false, false};
  for (int k = 0; k < 16; ++k) number.values.push_back(10 + (k % 2 == 0 ? 1 : -1) * (0.5 + k / 16.0));
  set.numbers = {number, {"claim", "an identity", {1e-15}, {-1e-12, 1e-12}, true, false}};
  set.claims["claim"] = {Outcome::pass, true, 7, "a number lies in its band"};
  return set;
}

/// The same physics on other trajectories: the values in another order, which no permutation can tell apart.
inline EvidenceSet with_other_trajectories(EvidenceSet set) {
  for (auto& [key, run] : set.runs) run.trace_hash += 100, run.measured += 100;
  auto& values = set.numbers[0].values;
  std::rotate(values.begin(), values.begin() + 1, values.end());
  return set;
}

}  // namespace gpf::test
