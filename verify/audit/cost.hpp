// What two versions cost beside each other: CPU time per collision, and memory.
#pragma once

#include <csignal>
#include <filesystem>
#include <optional>
#include <vector>

#include "verify/audit/evidence_set.hpp"

namespace gpf {

struct CostComparison {
  bool interleaved = false;                    ///< measured now, in turn; else taken from records made whenever
  std::vector<double> before, after;           ///< CPU seconds per pair contact, one per round
  double ratio = 0;                            ///< after over before: of the medians
  double least = 0, most = 0;                  ///< of the rounds' own ratios
  double memory_before = 0, memory_after = 0;  ///< largest resident sets, bytes; 0: not measured
};

/// Ratio and its spread from the rounds. Throws InputError unless both have as many, and at least one.
CostComparison cost_of_rounds(std::vector<double> before, std::vector<double> after);

/// Runs a fixed scene of about a second with both programs in turn, `rounds` times. Throws InputError when a program
/// fails or is stopped, StorageError.
CostComparison measure_cost(const std::filesystem::path& before, const std::filesystem::path& after,
                            const std::filesystem::path& folder, int rounds = 5,
                            const volatile std::sig_atomic_t* stop = nullptr);

/// From the records that both sides have; nothing when there is none.
std::optional<CostComparison> cost_of_records(const EvidenceSet& before, const EvidenceSet& after);

}  // namespace gpf
