// What it means to a user that memory could not be had.
#pragma once

#include "gpf/base/error.hpp"

namespace gpf {

/// For std::bad_alloc, and for threads that cannot be started.
inline StorageError out_of_memory() {
  return {"memory ran out", "the system, or a limit such as ulimit -v, gives no more",
          "free some, raise the limit, run fewer --jobs, or make the scene smaller"};
}

}  // namespace gpf
