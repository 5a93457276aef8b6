// What a user sees of a pool of runs, on standard error.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <vector>

#include "verify/run_pool.hpp"

namespace gpf {

class PoolProgress {
 public:
  explicit PoolProgress(const std::vector<RunJob>& jobs);

  /// Job `job` has done this fraction of its run.
  void advance(std::size_t job, double fraction);
  /// Job `job` has come to its end: one line, on a terminal and in a pipe. `last` is its worker's last report.
  void end(std::size_t job, const std::string& last);
  /// On a terminal the line of what is running with the time left, at most five times a second.
  void show();

 private:
  using Clock = std::chrono::steady_clock;
  [[nodiscard]] double elapsed() const { return std::chrono::duration<double>(Clock::now() - started_).count(); }

  const std::vector<RunJob>& jobs_;
  std::vector<double> work_, fraction_;  // expected collisions; part of the run that is done
  double work_found_ = 0;                // of this, none was to be done: the records were there
  std::size_t ended_ = 0;
  bool terminal_;
  Clock::time_point started_ = Clock::now(), shown_{};
};

}  // namespace gpf
