#include "verify/forked_process.hpp"

#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <system_error>

namespace gpf {
namespace {

StorageError cannot_start(int error_number) {
  return {"cannot start a process", std::generic_category().message(error_number), "use fewer --jobs"};
}

}  // namespace

ForkedProcess fork_process(int signal, const std::function<void(int)>& work) {
  std::array<int, 2> ends{};
  if (::pipe(ends.data()) != 0) throw cannot_start(errno);
  std::fflush(nullptr);
  const pid_t parent = ::getpid(), child = ::fork();
  if (child < 0) {
    const int failure = errno;
    ::close(ends[0]);
    ::close(ends[1]);
    throw cannot_start(failure);
  }
  if (child == 0) {
    ::close(ends[0]);
    ::signal(SIGPIPE, SIG_IGN);
    ::prctl(PR_SET_PDEATHSIG, signal);
    if (::getppid() != parent) ::raise(signal);  // it died before it could be asked to tell
    work(ends[1]);
    ::_exit(static_cast<int>(ExitStatus::physics));  // not reached
  }
  ::close(ends[1]);
  return {child, ends[0]};
}

int wait_for(pid_t process) {
  int status = 0;
  while (::waitpid(process, &status, 0) < 0)
    if (errno != EINTR) throw cannot_start(errno);
  return status;
}

SignalEnd ended_by(int signal) {
  // A crash is what the process did; these are not.
  if (signal == SIGKILL || signal == SIGTERM || signal == SIGXCPU)
    return {fmt::format("ended by signal {}, from outside: is there memory enough?", signal), ExitStatus::storage};
  return {fmt::format("ended by signal {}", signal), ExitStatus::physics};
}

}  // namespace gpf
