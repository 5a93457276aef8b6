// With what two versions made their records: compiler, flags, libraries, CPU.
#pragma once

#include <string>
#include <vector>

#include "verify/audit/evidence_set.hpp"

namespace gpf {

/// One fact of the provenance. Where the records of a side disagree, all that they say, separated by "; ".
struct EnvironmentFact {
  std::string name;  ///< "compiler", "library HDF5", "cpu"
  std::string before, after;
};

/// All facts of the records on both sides, except those that tell any two runs apart (time, command line).
std::vector<EnvironmentFact> environment_of(const EvidenceSet& before, const EvidenceSet& after);

}  // namespace gpf
