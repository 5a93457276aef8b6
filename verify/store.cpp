#include "verify/store.hpp"

#include <fmt/format.h>

#include "gpf/base/error.hpp"
#include "gpf/base/hash.hpp"
#include "gpf/base/random.hpp"
#include "gpf/event/physics_version.hpp"
#include "gpf/scene/canonical_text.hpp"

namespace gpf {

SceneFile replica_of(const SceneFile& file, int replica, std::uint64_t release_seed) {
  SceneFile result = file;
  std::uint64_t hash = scene_hash(file.scene);
  if (release_seed != 0) hash = mix(hash ^ mix(release_seed));
  result.scene.seed = replica_seed(hash, static_cast<std::uint64_t>(replica)) >> 1;
  return result;
}

RecordStore::RecordStore(std::filesystem::path folder, std::function<void(const std::string&)> report)
    : folder_(std::move(folder)), report_(std::move(report)) {
  std::error_code failure;
  std::filesystem::create_directories(folder_, failure);
  if (failure)
    throw StorageError(fmt::format("cannot create the store '{}'", folder_.string()), failure.message(),
                       "choose another folder with --store");
}

std::filesystem::path RecordStore::path(const SceneFile& file) const {
  return folder_ / (record_name(file.scene, file.run) + ".h5");
}

std::optional<Record> RecordStore::load(const SceneFile& file) const {
  const std::filesystem::path place = path(file);
  if (!std::filesystem::exists(place)) return std::nullopt;
  std::string why;
  try {
    Record record = read_record(place);
    if (record.physics_version != physics_version)
      why = fmt::format("made with physics version {}, this is {}", record.physics_version, physics_version);
    else if (canonical_text(record.scene, record.run) != canonical_text(file.scene, file.run))
      why = "the record of another scene";
    else
      return record;
  } catch (const Error& error) {
    why = error.what();
  }
  if (report_) report_(fmt::format("'{}' is not used: {}", place.string(), why));
  return std::nullopt;
}

void RecordStore::save(const SceneFile& file, const Record& record) const { write_record(record, path(file)); }

}  // namespace gpf
