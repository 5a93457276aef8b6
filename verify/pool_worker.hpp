// One run of a pool, in a process of its own, and what it tells its parent.
#pragma once

#include "verify/run_pool.hpp"

namespace gpf {

/// Does the job and exits the process with the job's ExitStatus. Writes lines to the descriptor `report`:
/// "progress <fraction>" and one last "done <cpu seconds> <collisions>", "found" (the record was there), "stopped", or
/// "failed <what>".
[[noreturn]] void work(const RecordStore& store, const RunJob& job, const PoolOptions& options, int report);

}  // namespace gpf
