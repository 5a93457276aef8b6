// What each release found: one number for each claim, kept as text, so that a page shows how it went on.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "verify/judge.hpp"

namespace gpf {

/// A claim in a release: its verdict and one of its checks.
struct ReleaseEntry {
  std::string release;  ///< version of gpf, "0.1.0"
  std::string outcome;  ///< name_of(Outcome)
  bool green = false;
  int replicas = 0, physics_version = 0;
  std::string check;            ///< its label
  double value = 0, error = 0;  ///< mean over the replicas, and its standard error (NaN for one value)
};

/// By claim, oldest release first.
using ReleaseHistory = std::map<std::string, std::vector<ReleaseEntry>>;

/// All files <folder>/<release>.csv; none when there is no such folder. Throws InputError for a damaged line.
ReleaseHistory load_release_history(const std::filesystem::path& folder);

/// Writes <folder>/<release>.csv, a line for each verdict that has a check: that which the newest earlier release kept,
/// or the deciding one. Throws StorageError.
void write_release(const std::vector<const Verdict*>& verdicts, const std::string& release,
                   const std::filesystem::path& folder);

/// A table of the releases; empty without entries.
std::string history_table(const std::vector<ReleaseEntry>& entries);

}  // namespace gpf
