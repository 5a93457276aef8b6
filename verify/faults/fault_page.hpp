// The page of the faults: who catches what, and how little of it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "verify/faults/fault_trial.hpp"

namespace gpf {

/// What was tried, in tier quick.
struct FaultMatrix {
  std::vector<FaultTrial> trials;
  std::vector<SmallestDose> smallest;
  std::vector<Claim> claims;        ///< that read records
  std::vector<std::string> others;  ///< ids of those that do not

  /// Faults that no claim catches.
  [[nodiscard]] std::vector<std::string> missed() const;
};

/// The matrix as an SVG document: a row for each claim, a column for each fault.
std::string matrix_svg(const FaultMatrix& matrix);

/// claim,fault,tier,dose,caught
std::string matrix_csv(const FaultMatrix& matrix);

/// Writes faults.md, faults.svg and faults.csv into the folder. Throws StorageError.
void write_fault_page(const FaultMatrix& matrix, const std::filesystem::path& folder);

}  // namespace gpf
