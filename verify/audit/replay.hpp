// One run by two programs, to the first event that differs.
#pragma once

#include <csignal>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "verify/audit/first_difference.hpp"

namespace gpf {

/// What is run, by which programs.
struct ReplayTask {
  std::string scene;        ///< text of a scene file
  std::int64_t epochs = 0;  ///< of the whole run
  double epoch_length = 0;
  std::filesystem::path before, after;               ///< programs with the command trace
  std::filesystem::path folder;                      ///< for the scene file and what the programs say of it
  std::function<void()> between;                     ///< called after each program's run: throws to stop
  const volatile std::sig_atomic_t* stop = nullptr;  ///< set: the program that is running is asked to end
};

/// The first event that differs; nothing when the programs agree up to the end. Throws InputError when a program cannot
/// trace the scene, StorageError.
std::optional<EventDifference> replay(const ReplayTask& task);

}  // namespace gpf
