#include "verify/run_pool.hpp"

#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>

#include "verify/forked_process.hpp"
#include "verify/pool_progress.hpp"
#include "verify/pool_worker.hpp"

namespace gpf {
namespace {

/// A child and the pipe that it reports through.
struct Worker {
  pid_t process;
  int pipe;
  std::size_t job;
  std::string unread;  // the beginning of a line
  std::string last;    // the last line other than progress
};

Worker start(const RecordStore& store, const std::vector<RunJob>& jobs, std::size_t job, const PoolOptions& options) {
  const auto [process, pipe] = fork_process(SIGTERM, [&](int report) { work(store, jobs[job], options, report); });
  return {process, pipe, job, {}, {}};
}

/// Reads what a worker has written; false at the end of its reports.
bool read_reports(Worker& worker, PoolProgress& progress) {
  std::array<char, 4096> chunk{};
  const ssize_t got = ::read(worker.pipe, chunk.data(), chunk.size());
  if (got < 0) return errno == EINTR || errno == EAGAIN;
  if (got == 0) return false;
  worker.unread.append(chunk.data(), static_cast<std::size_t>(got));
  for (std::size_t end = 0; (end = worker.unread.find('\n')) != std::string::npos; worker.unread.erase(0, end + 1)) {
    const std::string line = worker.unread.substr(0, end);
    if (line.starts_with("progress "))
      progress.advance(worker.job, std::strtod(line.c_str() + 9, nullptr));
    else
      worker.last = line;
  }
  return true;
}

/// How a process ended, if not well; a run that was stopped leaves `stopped` set.
std::optional<RunFailure> failure_of(const Worker& worker, const std::string& label, bool asked, bool& stopped) {
  const int status = wait_for(worker.process);
  if (WIFSIGNALED(status)) {
    if (asked && WTERMSIG(status) == SIGTERM) {
      stopped = true;
      return std::nullopt;
    }
    const SignalEnd end = ended_by(WTERMSIG(status));
    return RunFailure{label, end.what, end.status};
  }
  const auto exit = static_cast<ExitStatus>(WEXITSTATUS(status));
  if (exit == ExitStatus::interrupted) stopped = true;
  if (exit == ExitStatus::success || exit == ExitStatus::interrupted) return std::nullopt;
  const bool told = worker.last.starts_with("failed ");
  return RunFailure{label, told ? worker.last.substr(7) : "ended without a word", exit};
}

class Pool {
 public:
  Pool(const RecordStore& store, const std::vector<RunJob>& jobs, const PoolOptions& options)
      : store_(store), jobs_(jobs), options_(options), progress_(jobs) {}

  PoolResult run() {
    try {
      while (!workers_.empty() || (next_ < jobs_.size() && !stopping())) {
        while (!stopping() && next_ < jobs_.size() && workers_.size() < static_cast<std::size_t>(options_.jobs))
          workers_.push_back(start(store_, jobs_, next_++, options_));
        if (stopping()) ask_to_stop();
        listen();
        progress_.show();
      }
    } catch (...) {
      ask_to_stop();
      for (const Worker& worker : workers_) ::waitpid(worker.process, nullptr, 0);
      throw;
    }
    if (next_ < jobs_.size()) result_.stopped = true;
    return std::move(result_);
  }

 private:
  [[nodiscard]] bool stopping() const { return options_.stop != nullptr && *options_.stop != 0; }

  void ask_to_stop() {
    if (asked_) return;
    asked_ = true;
    for (const Worker& worker : workers_) ::kill(worker.process, SIGTERM);
  }

  void listen() {
    std::vector<pollfd> pipes;
    for (const Worker& worker : workers_) pipes.push_back({worker.pipe, POLLIN, 0});
    if (::poll(pipes.data(), pipes.size(), 200) <= 0) return;
    for (std::size_t k = workers_.size(); k-- > 0;) {
      if (pipes[k].revents == 0 || read_reports(workers_[k], progress_)) continue;
      finish(workers_[k]);
      workers_.erase(workers_.begin() + static_cast<std::ptrdiff_t>(k));
    }
  }

  void finish(const Worker& worker) {
    ::close(worker.pipe);
    auto failure = failure_of(worker, jobs_[worker.job].label, asked_, result_.stopped);
    progress_.end(worker.job, failure ? "failed: " + failure->what : worker.last);
    if (failure) result_.failures.push_back(std::move(*failure));
  }

  const RecordStore& store_;
  const std::vector<RunJob>& jobs_;
  const PoolOptions& options_;
  PoolProgress progress_;
  std::vector<Worker> workers_;
  std::size_t next_ = 0;
  bool asked_ = false;
  PoolResult result_;
};

}  // namespace

PoolResult run_pool(const RecordStore& store, const std::vector<RunJob>& jobs, const PoolOptions& options) {
  return Pool(store, jobs, options).run();
}

double expected_collisions(const SceneFile& file) {
  const double rate = file.scene.reference_collision_rate();  // per disk
  const double measured = std::max(file.run.duration * rate, file.run.collisions_per_particle);
  return (file.run.start_up * rate + measured) * file.scene.particles / 2;
}

}  // namespace gpf
