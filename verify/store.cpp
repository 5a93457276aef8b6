#include "verify/store.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "gpf/base/error.hpp"
#include "gpf/base/hash.hpp"
#include "gpf/base/random.hpp"
#include "gpf/event/physics_version.hpp"
#include "gpf/scene/canonical_text.hpp"
#include "verify/simulation_sources.hpp"

namespace gpf {
namespace {

using Json = nlohmann::ordered_json;
constexpr std::string_view made_by_other_sources = "made by another version of the simulation's source text";

/// simulation_sources() of the program that made the record, as save() wrote it; empty when it does not say.
std::string sources_of(const Record& record) {
  const Json session = Json::parse(record.session, nullptr, false);
  return session.is_object() ? session.value("simulation_sources", std::string()) : std::string();
}

}  // namespace

SceneFile replica_of(const SceneFile& file, int replica, std::uint64_t release_seed) {
  SceneFile result = file;
  std::uint64_t hash = scene_hash(file.scene);
  if (release_seed != 0) hash = mix(hash ^ mix(release_seed));
  result.scene.seed = replica_seed(hash, static_cast<std::uint64_t>(replica)) >> 1;
  return result;
}

RecordStore::RecordStore(std::filesystem::path folder, Trust trust, std::function<void(const std::string&)> report)
    : folder_(std::move(folder)), trust_(trust), report_(std::move(report)) {
  std::error_code failure;
  std::filesystem::create_directories(folder_, failure);
  if (failure)
    throw StorageError(fmt::format("cannot create the store '{}'", folder_.string()), failure.message(),
                       "choose another folder with --store");
}

std::filesystem::path RecordStore::path(const SceneFile& file) const {
  return folder_ / (record_name(file.scene, file.run) + ".h5");
}

/// Empty when the record can be used.
std::string RecordStore::why_not(const Record& record, const SceneFile& file) const {
  if (record.physics_version != physics_version)
    return fmt::format("made with physics version {}, this is {}", record.physics_version, physics_version);
  if (canonical_text(record.scene, record.run) != canonical_text(file.scene, file.run))
    return "the record of another scene";
  if (trust_ == Trust::same_sources && sources_of(record) != hexadecimal(simulation_sources()))
    return std::string(made_by_other_sources);
  return {};
}

std::optional<Record> RecordStore::load(const SceneFile& file) const {
  const std::filesystem::path place = path(file);
  if (!std::filesystem::exists(place)) return std::nullopt;
  std::string why;
  try {
    Record record = read_record(place);
    why = why_not(record, file);
    if (why.empty()) return record;
  } catch (const Error& error) {
    why = error.what();
  }
  const bool repeated = why == made_by_other_sources && std::exchange(other_sources_reported_, true);
  if (report_ && !repeated) report_(fmt::format("'{}' is not used: {}", place.string(), why));
  return std::nullopt;
}

void RecordStore::save(const SceneFile& file, const Record& record) const {
  Record signed_record = record;
  Json session = Json::parse(record.session, nullptr, false);
  if (!session.is_object()) session = Json::object();
  session["simulation_sources"] = hexadecimal(simulation_sources());
  signed_record.session = session.dump(2, ' ', false, Json::error_handler_t::replace);
  write_record(signed_record, path(file));
}

}  // namespace gpf
