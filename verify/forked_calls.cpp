#include "verify/forked_calls.hpp"

#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <exception>
#include <new>
#include <string_view>
#include <utility>
#include <vector>

#include "verify/forked_process.hpp"
#include "verify/out_of_memory.hpp"

namespace gpf {
namespace {

ForkedAnswer call(const std::function<std::string(std::size_t)>& f, std::size_t k) {
  try {
    return {f(k)};
  } catch (const Error& error) {
    return {error.what(), error.status()};
  } catch (const std::bad_alloc&) {
    const StorageError error = out_of_memory();
    return {error.what(), error.status()};
  } catch (const std::exception& error) {
    return {error.what(), ExitStatus::physics};
  }
}

/// A process that makes one call, and the pipe that its text comes through.
struct Caller {
  pid_t process;
  int pipe;
  std::size_t call;
  std::string text;
};

[[noreturn]] void answer(const ForkedAnswer& answer, int pipe) {
  std::string_view left = answer.text;
  while (!left.empty()) {
    const ssize_t written = ::write(pipe, left.data(), left.size());
    if (written <= 0 && errno != EINTR) ::_exit(static_cast<int>(ExitStatus::storage));
    if (written > 0) left.remove_prefix(static_cast<std::size_t>(written));
  }
  ::_exit(static_cast<int>(answer.status));  // not exit(): what the parent has buffered is the parent's to write
}

Caller start(const std::function<std::string(std::size_t)>& f, std::size_t k) {
  // SIGKILL: nobody is left to answer.
  const auto [process, pipe] = fork_process(SIGKILL, [&](int told) { answer(call(f, k), told); });
  return {process, pipe, k, {}};
}

/// Appends what has come to the text; false at its end.
bool listen(Caller& caller) {
  std::array<char, 65536> chunk;
  const ssize_t got = ::read(caller.pipe, chunk.data(), chunk.size());
  if (got < 0) return errno == EINTR || errno == EAGAIN;
  caller.text.append(chunk.data(), static_cast<std::size_t>(got));
  return got > 0;
}

ForkedAnswer finish(const Caller& caller) {
  ::close(caller.pipe);
  const int status = wait_for(caller.process);
  if (WIFEXITED(status)) return {caller.text, static_cast<ExitStatus>(WEXITSTATUS(status))};
  const SignalEnd end = ended_by(WTERMSIG(status));
  return {end.what, end.status};
}

}  // namespace

bool forked_calls(std::size_t count, int jobs, const std::function<std::string(std::size_t)>& f,
                  const std::function<void(std::size_t, const ForkedAnswer&)>& done,
                  const volatile std::sig_atomic_t* stop) {
  struct Callers : std::vector<Caller> {
    ~Callers() {
      for (const Caller& caller : *this) ::kill(caller.process, SIGKILL);
      for (const Caller& caller : *this) finish(caller);
    }
  } callers;
  std::size_t next = 0;
  while (next < count || !callers.empty()) {
    if (stop != nullptr && *stop != 0) return false;
    if (jobs == 1) {
      done(next, call(f, next));
      ++next;
      continue;
    }
    while (next < count && callers.size() < static_cast<std::size_t>(jobs)) callers.push_back(start(f, next++));
    std::vector<pollfd> pipes;
    for (const Caller& caller : callers) pipes.push_back({caller.pipe, POLLIN, 0});
    if (::poll(pipes.data(), pipes.size(), 200) <= 0) continue;
    for (std::size_t k = callers.size(); k-- > 0;) {
      if (pipes[k].revents == 0 || listen(callers[k])) continue;
      const Caller ended = std::move(callers[k]);
      callers.erase(callers.begin() + static_cast<std::ptrdiff_t>(k));
      done(ended.call, finish(ended));
    }
  }
  return true;
}

}  // namespace gpf
