// A part of a test in a process of its own, which may be limited, killed or crash without harm to the test.
#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <iostream>
#include <string>
#include <system_error>

namespace gpf::test {

class ChildProcess {
 public:
  /// Starts `work` in a child that leaves by std::exit, so that exit handlers of libraries run: with status 0 if
  /// work returns an empty text, else 1, the text (or what an exception says) going to standard error.
  explicit ChildProcess(const std::function<std::string()>& work) {
    std::fflush(nullptr);  // or the child's exit would write the parent's pending output a second time
    std::cout.flush();
    pid_ = ::fork();
    if (pid_ < 0) throw std::system_error(errno, std::generic_category(), "fork");
    if (pid_ > 0) return;
    std::string complaint;
    try {
      complaint = work();
    } catch (const std::exception& error) {
      complaint = std::string("exception: ") + error.what();
    }
    if (!complaint.empty()) complaint += '\n';
    const bool told = ::write(STDERR_FILENO, complaint.data(), complaint.size()) >= 0;
    std::exit(complaint.empty() && told ? 0 : 1);
  }
  ~ChildProcess() {
    if (pid_ > 0) {
      ::kill(pid_, SIGKILL);
      wait();
    }
  }
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  void kill(int signal) const { ::kill(pid_, signal); }

  /// Waits for the end. Exit status, or 128 + n when signal n ended it.
  int wait() {
    int status = 0;
    while (::waitpid(pid_, &status, 0) < 0) {
      if (errno != EINTR) throw std::system_error(errno, std::generic_category(), "waitpid");
    }
    pid_ = 0;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }

 private:
  pid_t pid_;
};

}  // namespace gpf::test
