// A function called many times, each time in a process of its own.
#pragma once

#include <csignal>
#include <cstddef>
#include <functional>
#include <string>

#include "gpf/base/error.hpp"

namespace gpf {

/// What a call gave: the text that it returned or, with another status than success, what it threw.
struct ForkedAnswer {
  std::string text;
  ExitStatus status = ExitStatus::success;
};

/// Calls f(0) ... f(count - 1) in processes, `jobs` at a time (forked, so the caller must have no other thread; the
/// libraries that f uses need not bear threads), and hands on each answer, in this process, when it is there. What f
/// changes is lost but for its text. With one job nothing is forked. A call that a signal ends is a failed one. False
/// when *stop became set: the processes are ended then. Throws StorageError when no process can be started.
bool forked_calls(std::size_t count, int jobs, const std::function<std::string(std::size_t)>& f,
                  const std::function<void(std::size_t, const ForkedAnswer&)>& done,
                  const volatile std::sig_atomic_t* stop = nullptr);

}  // namespace gpf
