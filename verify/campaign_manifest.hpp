// The manifest of a campaign: its runs, each by a number that never changes and the name of its record.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "verify/campaign.hpp"
#include "verify/run_pool.hpp"
#include "verify/store.hpp"

namespace gpf {

/// A folder that holds a campaign: campaign.toml, manifest.jsonl, job.slurm, records/, failed/.
struct CampaignFolder {
  std::filesystem::path folder;

  [[nodiscard]] std::filesystem::path file(const char* name) const { return folder / name; }
};

struct ManifestEntry {
  std::size_t index = 0;    ///< task number of a job array
  std::size_t replica = 0;  ///< from 0
  std::string record;       ///< name of the record, without ".h5"
  std::string label;        ///< the point's, and the replica counted from 1: "length_over_width = 2 #3"
  std::string scene;        ///< canonical text, seed included: all that is needed to run it
  bool wanted = true;       ///< false: the campaign no longer has it; its number stays taken
};

using Manifest = std::vector<ManifestEntry>;  ///< by index, without gaps

/// The runs of a campaign, `replicas` by point. Runs of `before` keep their numbers; those that the campaign has no
/// more are kept as not wanted; new ones get the numbers that follow.
Manifest plan(const Campaign& campaign, const std::vector<int>& replicas, const Manifest& before);

/// One JSON object a line, and their number in the last. Throws InputError when a line is not one of these, an index is
/// out of order, a scene is not that of its record, or lines are missing.
Manifest load_manifest(const CampaignFolder& folder);
/// Atomically. Throws StorageError.
void write_manifest(const Manifest& manifest, const CampaignFolder& folder);

/// The wanted runs without a usable record in the store, in the order of their numbers.
std::vector<ManifestEntry> missing(const Manifest& manifest, const RecordStore& store);

/// What a pool needs to know of a run.
RunJob job_of(const ManifestEntry& entry);

/// "0-3,7": numbers as an array of Slurm and of most other batch systems names them.
std::string index_ranges(const std::vector<ManifestEntry>& entries);

/// A batch script for a Slurm job array over the manifest: each task runs one entry, is requeued when USR1
/// stops it before it ends, and goes on from its checkpoint; when it is cancelled it writes one and stays out.
std::string slurm_script(const CampaignFolder& folder, const std::filesystem::path& program, const std::string& title);

}  // namespace gpf
