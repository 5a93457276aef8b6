#include "verify/run_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "gpf/base/hash.hpp"
#include "gpf/measure/bins.hpp"

namespace gpf {

namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json scalar(const Estimate& e) { return {{"mean", number(e.mean)}, {"error", number(e.error)}}; }

Json profile(const Measured& m) {
  Json mean = Json::array(), error = Json::array();
  for (const Estimate& e : m.values) mean.push_back(number(e.mean)), error.push_back(number(e.error));
  return {{"mean", std::move(mean)}, {"error", std::move(error)}};
}

bool is_budget(const std::string& name) {
  return name == "gravity_power" || name == "pair_loss" || name.starts_with("wall_loss") || name.starts_with("energy_");
}

}  // namespace

std::string run_json(const Record& record) {
  const MeasuredQuantities quantities = quantities_of(record);
  const auto contacts = static_cast<double>(record.counts.pair_contacts);
  Json json{
      {"collisions", record.counts.pair_contacts},
      {"collisions_per_second", number(contacts / record.wall_seconds)},
      {"wall_seconds", record.wall_seconds},
      {"cpu_seconds", record.cpu_seconds},
      {"time", record.time},
      {"trace_hash", hexadecimal(record.trace_hash)},
      {"wall_contacts", record.counts.wall_contacts},
      {"cell_crossings", record.counts.crossings},
      {"stale_events", record.counts.stale},
      {"particles", record.scene.particles},
      {"area_fraction_mean", record.scene.area_fraction()},
      {"tc_time", record.scene.tc_time},
      {"blocks", record.blocks},
      {"units", "W = 1, m = 1; time in W/v with v = sqrt(g W), or the unit of the start velocities without gravity"}};
  Json y = Json::array();
  for (int b = 0; b < record.run.bins; ++b) y.push_back(Bins(record.run.bins).centre(b));
  json["y"] = std::move(y);
  Json budget = Json::object();
  for (const auto& [name, measured] : quantities) {
    if (is_budget(name))
      budget[name] = scalar(measured.values.front());
    else if (!measured.several)
      json[name] = scalar(measured.values.front());
    else
      json[name] = profile(measured);
  }
  if (!budget.empty()) json["energy_budget"] = std::move(budget);
  return json.dump();
}

}  // namespace gpf
