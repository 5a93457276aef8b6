#include "verify/audit/child.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "gpf/base/error.hpp"
#include "gpf/io/file_descriptor.hpp"

namespace gpf {
namespace {

double seconds(const timeval& t) { return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec); }

}  // namespace

ChildResult run_child(const std::vector<std::string>& arguments, const std::filesystem::path& log,
                      const volatile std::sig_atomic_t* stop, const std::filesystem::path& output) {
  std::vector<std::string> storage = arguments;  // spawn takes pointers to non-const
  std::vector<char*> argv;
  for (std::string& argument : storage) argv.push_back(argument.data());
  argv.push_back(nullptr);
  const FileDescriptor errors(log, O_WRONLY | O_CREAT | O_APPEND),
      told(output.empty() ? log : output, O_WRONLY | O_CREAT | O_APPEND);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, told.get(), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, errors.get(), STDERR_FILENO);
  pid_t child = 0;
  const int failure = ::posix_spawnp(&child, argv.front(), &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failure != 0)
    throw StorageError(fmt::format("cannot start {}", arguments.front()), std::generic_category().message(failure),
                       "install it, or add its folder to the PATH");
  int status = 0;
  rusage usage{};
  // A signal between a look at the flag and a wait would be slept through, so the flag is looked at now and then.
  bool asked = false;
  for (pid_t ended = 0; ended != child;) {
    if (!asked && stop != nullptr && *stop != 0) asked = ::kill(child, SIGTERM) == 0;
    ended = ::wait4(child, &status, WNOHANG, &usage);
    if (ended == 0) ::usleep(20'000);
    if (ended < 0 && errno != EINTR)
      throw StorageError(fmt::format("lost {}", arguments.front()), std::generic_category().message(errno),
                         "try again");
  }
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
          seconds(usage.ru_utime) + seconds(usage.ru_stime), 1024 * static_cast<double>(usage.ru_maxrss)};
}

}  // namespace gpf
