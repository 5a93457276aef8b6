#include "verify/view/piped_program.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <system_error>
#include <utility>

#include "gpf/base/error.hpp"
#include "gpf/io/file_descriptor.hpp"

namespace gpf {

PipedProgram::PipedProgram(const std::vector<std::string>& arguments)
    : name_(arguments.front()), errors_(std::tmpfile()) {
  if (errors_ == nullptr) throw_system_error("cannot create a temporary file", errno);
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
    const int reason = errno;
    std::fclose(errors_);
    throw_system_error("cannot create a pipe", reason);
  }
  std::vector<std::string> storage = arguments;  // spawn takes pointers to non-const
  std::vector<char*> argv;
  for (std::string& argument : storage) argv.push_back(argument.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[0], STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, ::fileno(errors_), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, ::fileno(errors_), STDERR_FILENO);
  const int failure = ::posix_spawnp(&process_, argv.front(), &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  ::close(ends[0]);
  if (failure != 0) {
    ::close(ends[1]);
    std::fclose(errors_);
    throw StorageError("cannot start " + name_, std::generic_category().message(failure),
                       "install it, or add its folder to the PATH");
  }
  pipe_ = ends[1];
}

PipedProgram::~PipedProgram() {
  if (pipe_ >= 0) ::close(pipe_);
  if (process_ > 0) {
    ::kill(process_, SIGKILL);
    wait();
  }
  std::fclose(errors_);
}

void PipedProgram::write(std::string_view bytes) {
  // A reader that has gone is an error of this call, not the end of this program.
  struct NoSignal {
    void (*before)(int) = ::signal(SIGPIPE, SIG_IGN);
    NoSignal() = default;
    ~NoSignal() { ::signal(SIGPIPE, before); }
    NoSignal(const NoSignal&) = delete;
    NoSignal& operator=(const NoSignal&) = delete;
  } const no_signal;
  while (!bytes.empty()) {
    const ssize_t written = ::write(pipe_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail();
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

void PipedProgram::finish() {
  ::close(std::exchange(pipe_, -1));
  if (wait() != 0) fail();
}

int PipedProgram::wait() {
  int status = 0;
  while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) continue;
  process_ = -1;
  return status;
}

void PipedProgram::fail() {
  if (pipe_ >= 0) ::close(std::exchange(pipe_, -1));
  if (process_ > 0) wait();
  std::rewind(errors_);
  std::array<char, 400> words{};
  const std::size_t length = std::fread(words.data(), 1, words.size(), errors_);
  throw StorageError(name_ + " failed", length == 0 ? "it does not say why" : std::string(words.data(), length),
                     "see what it says, and make room for the file");
}

}  // namespace gpf
