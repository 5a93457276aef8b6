// Errors speak one grammar: the problem, (why it is one), what to do.
#pragma once

#include <stdexcept>
#include <string>

namespace gpf {

/// Exit statuses of the gpf program; every Error carries one.
enum class ExitStatus : int {
  success = 0,
  red = 1,           ///< a claim's outcome disagrees with its expectation
  bad_input = 2,     ///< a scene, claim, record or command line that cannot be used
  physics = 3,       ///< the engine met a state it must not continue from
  storage = 4,       ///< a file could not be read or written
  interrupted = 75,  ///< stopped by a signal after a checkpoint; --resume goes on
  inconclusive = 77  ///< a claim needs more data (ctest's skip code)
};

/// A failure that a user can act upon. what() reads "problem (why): remedy".
class Error : public std::runtime_error {
 public:
  Error(ExitStatus status, std::string problem, std::string why, std::string remedy);

  [[nodiscard]] ExitStatus status() const noexcept { return status_; }
  [[nodiscard]] const std::string& problem() const noexcept { return problem_; }
  [[nodiscard]] const std::string& why() const noexcept { return why_; }
  [[nodiscard]] const std::string& remedy() const noexcept { return remedy_; }

 private:
  ExitStatus status_;
  std::string problem_, why_, remedy_;
};

/// Input from outside (scene, claim, option, record) that cannot be used.
class InputError : public Error {
 public:
  InputError(std::string problem, std::string why, std::string remedy);
};

/// The engine met a state it must not continue from: overlap, inelastic collapse, time running backwards.
class PhysicsError : public Error {
 public:
  PhysicsError(std::string problem, std::string why, std::string remedy);
};

/// A file could not be read or written.
class StorageError : public Error {
 public:
  StorageError(std::string problem, std::string why, std::string remedy);
};

}  // namespace gpf
