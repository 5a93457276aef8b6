// Which program made a record (BuildProvenance), and where, when and how it was called (SessionProvenance).
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace gpf {

/// Facts fixed when the library was built: the same for every run of one build, so records that hold only these are
/// byte-identical for the same scene and seed.
struct BuildProvenance {
  std::string version;                           ///< of gpf
  std::string commit;                            ///< git commit of the source, or "unknown"
  std::optional<bool> dirty;                     ///< whether the built source differs from the commit; empty: unknown
  std::string compiler;                          ///< name and version
  std::string flags;                             ///< compile flags without warnings
  std::map<std::string, std::string> libraries;  ///< name -> version compiled against
};

/// Facts that differ between two runs of the same scene with the same program. Store them as a dataset of their own
/// that comparisons leave out, or not at all where equal runs must give equal files.
struct SessionProvenance {
  std::string cpu;                   ///< model name, or "unknown"
  std::string system;                ///< operating system, its release and architecture
  std::vector<std::string> command;  ///< the command line, one entry per argument
  std::string utc_time;              ///< ISO 8601, for example 2024-05-06T07:08:09Z
};

BuildProvenance build_provenance();

/// The facts of this process, now. command: argv as main received it.
SessionProvenance session_provenance(std::vector<std::string> command);

/// JSON object, keys as the members' names, two spaces of indentation; an unknown `dirty` is null. Invalid UTF-8 (a
/// command line may hold any bytes) becomes U+FFFD.
std::string to_json(const BuildProvenance& provenance);
std::string to_json(const SessionProvenance& provenance);

}  // namespace gpf
