#include "gpf/base/error.hpp"

#include <utility>

namespace gpf {

Error::Error(ExitStatus status, std::string problem, std::string why, std::string remedy)
    : std::runtime_error(problem + (why.empty() ? "" : " (" + why + ")") + (remedy.empty() ? "" : ": " + remedy)),
      status_(status),
      problem_(std::move(problem)),
      why_(std::move(why)),
      remedy_(std::move(remedy)) {}

InputError::InputError(std::string problem, std::string why, std::string remedy)
    : Error(ExitStatus::bad_input, std::move(problem), std::move(why), std::move(remedy)) {}

PhysicsError::PhysicsError(std::string problem, std::string why, std::string remedy)
    : Error(ExitStatus::physics, std::move(problem), std::move(why), std::move(remedy)) {}

StorageError::StorageError(std::string problem, std::string why, std::string remedy)
    : Error(ExitStatus::storage, std::move(problem), std::move(why), std::move(remedy)) {}

}  // namespace gpf
