#include "verify/methods/method_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <future>
#include <limits>
#include <mutex>
#include <nlohmann/json.hpp>

#include "gpf/base/error.hpp"
#include "gpf/base/hash.hpp"
#include "gpf/event/physics_version.hpp"
#include "gpf/io/atomic_file.hpp"
#include "gpf/io/record.hpp"

namespace gpf {
namespace {

using Json = nlohmann::json;

/// Raise it when a method, or what is measured of it, gives other numbers than before.
constexpr int methods_version = 1;

std::string identity(const MethodRun& run) {
  const int version = run.setting.method == Method::event_driven ? physics_version : methods_version;
  return fmt::format("{}{}\nversion {}\nstart {}\n", canonical_text(run.scene, run.run), text_of(run.setting), version,
                     run.start_name);
}

Json number(double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); }

}  // namespace

MethodStore::MethodStore(std::filesystem::path folder) : folder_(std::move(folder)) {
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  if (error)
    throw StorageError(fmt::format("cannot create the folder {}", folder_.string()), error.message(),
                       "choose another --store");
}

std::filesystem::path MethodStore::path(const MethodRun& run) const {
  return folder_ / (hexadecimal(hash_text(identity(run))) + ".json");
}

std::optional<MethodResult> MethodStore::load(const MethodRun& run) const {
  const auto file = path(run);
  if (!std::filesystem::exists(file)) return {};
  const Json json = Json::parse(read_text(file), nullptr, false);
  try {
    if (json.at("identity") != identity(run)) return {};
    MethodResult result{{{}, json.at("cpu_seconds"), {}}, json.at("failure")};
    const auto bins = static_cast<std::size_t>(run.run.bins);
    std::size_t profiles = 0;
    for (const auto& [name, values] : json.at("quantities").items()) {
      Quantity q{name, values.size() > 1, {}};
      for (const Json& v : values)
        q.values.push_back(v.is_null() ? std::numeric_limits<double>::quiet_NaN() : v.get<double>());
      profiles += q.several ? 1 : 0;
      if (q.several && q.values.size() != bins) return {};
      result.flow.quantities.push_back(std::move(q));
    }
    // A damaged one is made anew.
    const bool complete =
        result.flow.quantities.size() == quantities_of_a_flow && (profiles == profiles_of_a_flow || bins == 1);
    if (result.failure.empty() && !complete) return {};
    return result;
  } catch (const Json::exception&) {
    return {};
  }
}

void MethodStore::save(const MethodRun& run, const MethodResult& result) const {
  Json quantities = Json::object();
  for (const Quantity& q : result.flow.quantities) {
    Json values = Json::array();
    for (const double v : q.values) values.push_back(number(v));
    quantities[q.name] = std::move(values);
  }
  const Json json{{"identity", identity(run)},
                  {"cpu_seconds", result.flow.cpu_seconds},
                  {"failure", result.failure},
                  {"quantities", std::move(quantities)}};
  write_text_atomically(path(run), json.dump(1) + "\n");
}

MethodResult result_of(const MethodRun& run) {
  try {
    return {steady_flow(run.scene, run.run, run.setting, run.start ? &*run.start : nullptr), ""};
  } catch (const StorageError&) {
    throw;
  } catch (const Error& error) {
    return {{}, error.what()};
  }
}

bool complete(const MethodStore& store, const std::vector<MethodRun>& runs, int jobs,
              const volatile std::sig_atomic_t* stop) {
  std::vector<const MethodRun*> missing;
  for (const MethodRun& run : runs)
    if (!store.load(run)) missing.push_back(&run);
  if (!missing.empty()) fmt::print(stderr, "{} method run(s) missing, {} at a time\n", missing.size(), jobs);
  std::atomic<std::size_t> next{0};
  std::mutex printing;
  std::size_t done = 0;
  const auto stopped = [stop] { return stop != nullptr && *stop != 0; };
  const auto work = [&] {
    for (std::size_t k = next++; k < missing.size() && !stopped(); k = next++) {
      const MethodResult result = result_of(*missing[k]);
      const std::lock_guard lock(printing);
      store.save(*missing[k], result);
      fmt::print(stderr, "method run {}/{} {}: {}\n", ++done, missing.size(), missing[k]->label,
                 result.failure.empty() ? fmt::format("done in {:.3g} CPU s", result.flow.cpu_seconds)
                                        : "gave up: " + result.failure);
    }
  };
  std::vector<std::future<void>> threads;
  for (int k = 0; k < jobs; ++k) threads.push_back(std::async(std::launch::async, work));
  for (std::future<void>& thread : threads) thread.wait();
  for (std::future<void>& thread : threads) thread.get();
  return !stopped() || done == missing.size();
}

}  // namespace gpf
