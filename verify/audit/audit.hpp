// Two versions compared: the ladder from equal bits to statistics.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "verify/audit/page.hpp"
#include "verify/audit/side.hpp"

namespace gpf {

struct AuditOptions {
  std::string before, after;  ///< stores, revisions, or . for the working tree
  std::optional<PhysicsChange> declared;
  std::filesystem::path reference = "reference";  ///< from which runs of stores get their names
  SideOptions sides;
};

/// 1. Revisions whose sources do not differ (unless sides.rebuild): bitwise, and nothing is run. 2. Makes what is
/// missing and compares hashes, sums and values. 3. Where both sides are programs: replays the shortest run that
/// differs to the first event that does. 4. Statistics over the numbers of all claims. 5. Cost: runs interleaved if
/// both are programs. Progress on standard error. Throws InputError, StorageError, and Error with
/// ExitStatus::interrupted after a signal.
AuditReport audit(const AuditOptions& options);

}  // namespace gpf
