#include "gpf/io/subprocess.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

#include "gpf/base/error.hpp"

namespace gpf {
namespace {

/// A nameless file. Files and not pipes, so that neither side can block on the other or meet a broken pipe.
class Scratch {
 public:
  Scratch() : file_(std::tmpfile()) {
    if (!file_ || ::fcntl(descriptor(), F_SETFD, FD_CLOEXEC) != 0) fail("cannot create a temporary file");
  }

  [[nodiscard]] int descriptor() const { return ::fileno(file_.get()); }

  void fill(std::string_view text) {
    if (std::fwrite(text.data(), 1, text.size(), file_.get()) != text.size() || std::fflush(file_.get()) != 0) {
      fail("cannot write a temporary file");
    }
    std::rewind(file_.get());
  }

  std::string content() {
    std::rewind(file_.get());
    std::string text;
    std::array<char, 1 << 14> chunk{};
    while (const std::size_t got = std::fread(chunk.data(), 1, chunk.size(), file_.get()))
      text.append(chunk.data(), got);
    if (std::ferror(file_.get()) != 0) fail("cannot read a temporary file");
    return text;
  }

 private:
  [[noreturn]] static void fail(const std::string& problem) {
    throw StorageError(problem, std::generic_category().message(errno), "make room in the folder for temporary files");
  }

  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::unique_ptr<std::FILE, Close> file_;
};

int wait_for(pid_t child) {
  int status = 0;
  while (::waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) return -1;
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

ProcessResult run_program(const std::vector<std::string>& arguments, std::string_view input) {
  Scratch in, out, err;
  in.fill(input);
  std::vector<std::string> storage = arguments;  // spawn takes pointers to non-const
  std::vector<char*> argv;
  for (std::string& argument : storage) argv.push_back(argument.data());
  argv.push_back(nullptr);

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, in.descriptor(), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, out.descriptor(), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, err.descriptor(), STDERR_FILENO);
  pid_t child = 0;
  const int failure = ::posix_spawnp(&child, argv.front(), &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failure != 0) {
    throw StorageError("cannot start " + arguments.front(), std::generic_category().message(failure),
                       "install it, or add its folder to the PATH");
  }
  const int exit_status = wait_for(child);
  return {exit_status, out.content(), err.content()};
}

}  // namespace gpf
