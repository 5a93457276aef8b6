#include "verify/pool_progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <numeric>

#include "verify/duration_text.hpp"

namespace gpf {
namespace {

/// "done 3.21 12345678" as a reader likes it.
std::string in_words(const std::string& last) {
  if (last == "found") return "done by another process";
  if (last == "stopped") return "stopped, its checkpoint is kept";
  if (!last.starts_with("done ")) return last;
  char* rest = nullptr;
  const double seconds = std::strtod(last.c_str() + 5, &rest);
  return fmt::format("done in {:.1f} s, {:.3g} collisions", seconds, std::strtod(rest, nullptr));
}

}  // namespace

PoolProgress::PoolProgress(const std::vector<RunJob>& jobs)
    : jobs_(jobs), fraction_(jobs.size(), 0.0), terminal_(::isatty(STDERR_FILENO) == 1) {
  for (const RunJob& job : jobs) work_.push_back(expected_collisions(job.file));
}

void PoolProgress::advance(std::size_t job, double fraction) { fraction_[job] = fraction; }

void PoolProgress::end(std::size_t job, const std::string& last) {
  fraction_[job] = 1;
  if (!last.starts_with("done ")) work_found_ += work_[job];
  ++ended_;
  fmt::print(stderr, "{}run {}/{} {}: {}\n", terminal_ ? "\r\033[K" : "", ended_, jobs_.size(), jobs_[job].label,
             in_words(last));
  std::fflush(stderr);
}

void PoolProgress::show() {
  if (!terminal_ || ended_ == jobs_.size() || Clock::now() - shown_ < std::chrono::milliseconds(200)) return;
  shown_ = Clock::now();
  const double done = std::inner_product(work_.begin(), work_.end(), fraction_.begin(), 0.0);
  const double all = std::accumulate(work_.begin(), work_.end(), 0.0), worked = done - work_found_;
  std::string running;
  for (std::size_t k = 0; k < jobs_.size(); ++k)
    if (fraction_[k] > 0 && fraction_[k] < 1)
      running += fmt::format("  {} {:.0f} %", jobs_[k].label, 100 * fraction_[k]);
  const std::string left =
      worked > 0 ? "about " + duration_text(elapsed() * (all - done) / worked) + " left" : "starting";
  constexpr std::size_t columns = 79;  // a longer line would wrap and could not be overwritten
  const std::string line = fmt::format("{} of {} runs done, {}{}", ended_, jobs_.size(), left, running);
  fmt::print(stderr, "\r\033[K{}", line.substr(0, columns));
  std::fflush(stderr);
}

}  // namespace gpf
