// A process that is forked to do one thing, and tells its parent through a pipe.
#pragma once

#include <sys/types.h>

#include <functional>
#include <string>

#include "gpf/base/error.hpp"

namespace gpf {

struct ForkedProcess {
  pid_t process;
  int pipe;  ///< what the child writes is read here
};

/// Forks, so the caller must have no other thread. The child calls `work` with the descriptor to write to; `work` must
/// end the process (with _exit: what this process has buffered is its own to write). When this process ends, however,
/// the child gets `signal`. Throws StorageError when there is no more process or pipe to be had.
ForkedProcess fork_process(int signal, const std::function<void(int pipe)>& work);

/// Waits until it has ended, and gives its status as waitpid() does.
int wait_for(pid_t process);

/// What it means that a signal ended a process.
struct SignalEnd {
  std::string what;
  ExitStatus status;  ///< storage when the signal came from outside (want of memory, somebody's kill), else physics
};
SignalEnd ended_by(int signal);

}  // namespace gpf
