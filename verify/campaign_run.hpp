// The work on a campaign's folder: what the sub-commands of gpf campaign do.
#pragma once

#include <optional>

#include "verify/campaign_manifest.hpp"

namespace gpf {

/// Copies the campaign into the folder and writes the manifest and the batch script; runs that are planned or done
/// already stay. Prints what there is to do.
void plan_campaign(const std::filesystem::path& file, const CampaignFolder& folder,
                   const std::filesystem::path& program);

struct CampaignRunOptions {
  int jobs = 1;
  std::optional<std::size_t> task;  ///< only this entry of the manifest
  bool adaptive = false;            ///< then more replicas where neighbouring points differ
  double checkpoint_period = 60;
  const volatile std::sig_atomic_t* stop = nullptr;
  std::vector<std::string> command;  ///< for the records' provenance
};

/// Does what is missing. Failed runs leave their reason in failed/<index>; it is removed when the run succeeds. Jobs
/// are fewer than asked for when the memory that is free does not hold as many. Returns the exit status: 0 nothing is
/// missing, that of the first failure, or 75.
int run_campaign(const CampaignFolder& folder, const CampaignRunOptions& options);

/// Prints the missing runs, one a line: index, label, and why the last attempt failed; or their ranges.
void print_missing(const CampaignFolder& folder, bool as_ranges);

/// Writes phase.md, phase.csv, snapshots.md with a picture of a state at each point, and, for one or two axes,
/// phase.svg. Returns the path of phase.md.
std::filesystem::path collect_campaign(const CampaignFolder& folder);

/// Bytes that a run needs at most: disks, sums, and what a process needs without any (measured, see the source).
std::uint64_t memory_of_run(const SceneFile& file);

}  // namespace gpf
