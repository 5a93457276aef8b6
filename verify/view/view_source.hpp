// What is shown: a scene, the state to begin from, and the record of its run if there is one.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "gpf/io/record.hpp"

namespace gpf {

/// Where in the run the frames begin.
struct ViewStart {
  bool from_start = false;  ///< at time 0
  int snapshot = 0;         ///< at this snapshot of the record, counted from 1; 0: at the end of the run
};

struct ViewSource {
  std::string name;  ///< of the file
  Scene scene;
  Run run;
  Snapshot start;
  std::optional<Record> record;
};

/// Reads a scene file (*.toml: it begins at time 0) or a record. Throws InputError when it cannot be used or has no
/// such snapshot, StorageError when it cannot be read.
ViewSource load_view_source(const std::filesystem::path& path, const ViewStart& start);

}  // namespace gpf
