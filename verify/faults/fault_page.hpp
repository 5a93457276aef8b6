// The page of the faults: who catches what, and how little of it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "verify/faults/fault_trial.hpp"

namespace gpf {

/// What was tried. `standard` may hold fewer faults and claims than `quick`.
struct FaultMatrix {
  std::vector<FaultTrial> quick, standard;
  std::vector<SmallestDose> smallest;
  std::vector<Claim> claims;        ///< of tier quick, that read records
  std::vector<std::string> others;  ///< ids of those of tier quick that do not

  /// How many of the faults at least one claim of tier quick catches.
  [[nodiscard]] std::size_t caught_by_quick() const;
  /// Those that neither tier catches.
  [[nodiscard]] std::vector<std::string> missed() const;
};

/// The matrix of tier quick as an SVG document: a row for each claim, a column for each fault.
std::string matrix_svg(const FaultMatrix& matrix);

/// claim,fault,tier,dose,caught
std::string matrix_csv(const FaultMatrix& matrix);

/// Writes faults.md, faults.svg and faults.csv into the folder. Throws StorageError.
void write_fault_page(const FaultMatrix& matrix, const std::filesystem::path& folder);

}  // namespace gpf
