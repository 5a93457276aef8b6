// Runs of the methods, each done once and kept as a small JSON file.
#pragma once

#include <csignal>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "gpf/flow/steady_flow.hpp"
#include "gpf/scene/scene_file.hpp"

namespace gpf {

/// A method on a scene whose seed is that of a replica.
struct MethodRun {
  std::string label;  ///< in messages
  Scene scene;
  Run run;
  MethodSetting setting;
  /// Begin with this state instead of the lattice; `start_name`, not empty then, tells it from others.
  std::string start_name{};
  std::optional<State> start{};
};

/// What came out: quantities, or why the method gave up.
struct MethodResult {
  SteadyFlow flow;
  std::string failure;
};

/// A folder of results, found by scene, run, method and version. A file that cannot be read is made anew.
class MethodStore {
 public:
  /// Creates the folder. Throws StorageError.
  explicit MethodStore(std::filesystem::path folder);

  [[nodiscard]] std::filesystem::path path(const MethodRun& run) const;
  [[nodiscard]] std::optional<MethodResult> load(const MethodRun& run) const;
  /// Atomically. Throws StorageError.
  void save(const MethodRun& run, const MethodResult& result) const;

 private:
  std::filesystem::path folder_;
};

/// What the method says of the scene; its InputError and PhysicsError become `failure`.
MethodResult result_of(const MethodRun& run);

/// Does what the store does not hold, `jobs` at a time, with a line for each run on standard error. Returns false when
/// `stop` was set: what is done is kept, the same call goes on.
bool complete(const MethodStore& store, const std::vector<MethodRun>& runs, int jobs,
              const volatile std::sig_atomic_t* stop);

}  // namespace gpf
