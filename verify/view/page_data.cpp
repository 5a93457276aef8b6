#include "verify/view/page_data.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "gpf/measure/bins.hpp"
#include "verify/view/base64.hpp"
#include "verify/view/page_table.hpp"
#include "verify/view/palette.hpp"

namespace gpf {
namespace {

using Json = nlohmann::ordered_json;

Json means_of(const Measured& measured) {
  Json mean = Json::array(), error = Json::array();
  for (const Estimate& e : measured.values) mean.push_back(e.mean), error.push_back(e.error);
  return {{"mean", std::move(mean)}, {"error", std::move(error)}};
}

/// The record's own results: profiles with standard errors, its history, its mean density modes over their noise.
Json measured(const Record& record) {
  const MeasuredQuantities quantities = quantities_of(record);
  Json json{{"history",
             {{"time", record.history.time},
              {"energy", record.history.energy},
              {"temperature", record.history.temperature}}}};
  for (const char* name : {"mean_velocity", "granular_temperature", "area_fraction"})
    if (const auto found = quantities.find(name); found != quantities.end()) json[name] = means_of(found->second);
  for (const char* shape : {"even", "odd", "varicose"}) {
    const auto power = quantities.find(fmt::format("density_power_{}", shape)),
               noise = quantities.find(fmt::format("density_noise_{}", shape));
    if (power == quantities.end() || noise == quantities.end()) continue;
    Json ratios = Json::array();
    for (const Estimate& e : power->second.values)  // of which the noise has been taken
      ratios.push_back(1 + e.mean / noise->second.values.front().mean);
    json["density_modes"].push_back(std::move(ratios));
  }
  return json;
}

Json tables_of(const std::vector<PageTable>& tables) {
  Json json = Json::array();
  for (const PageTable& table : tables) {
    Json rows = Json::array();
    for (const auto& [name, text] : table.rows) rows.push_back(Json::array({name, text}));
    json.push_back({{"heading", table.heading}, {"rows", std::move(rows)}});
  }
  return json;
}

std::string without_tags(const std::string& json) {
  std::string text;
  text.reserve(json.size());
  for (const char c : json)
    if (c == '<')
      text += "\\u003c";  // JSON has this character in strings only
    else
      text += c;
  return text;
}

}  // namespace

std::string page_data(const ViewSource& source, const PackedFrames& frames, double interval,
                      std::uint64_t frames_hash) {
  const Scene& scene = source.scene;
  Json y = Json::array();
  for (int b = 0; b < source.run.bins; ++b) y.push_back(Bins(source.run.bins).centre(b));
  Json colours = Json::array();
  for (const Rgb& colour : palette) colours.push_back(colour);
  Json json{{"name", source.name},
            {"channel", scene.geometry == Geometry::channel},
            {"particles", scene.particles},
            {"length", scene.length()},
            {"diameter", scene.diameter()},
            {"gravity", scene.gravity},
            {"frames", frames.energy.size()},
            {"start", source.start.time},
            {"interval", interval},
            {"palette", std::move(colours)},
            {"y", std::move(y)},
            {"positions", base64(frames.positions)},
            {"velocities", base64(frames.velocities)},
            {"velocity_ranges", base64(frames.velocity_ranges)},
            {"profiles", base64(frames.profiles)},
            {"spectra", base64(frames.spectra)},
            {"spectrum",
             {{"most_kx", PackedFrames::most_kx},
              {"most_ky", PackedFrames::most_ky},
              {"decades", PackedFrames::spectrum_decades}}},
            {"density_modes", base64(frames.density_modes)},
            {"modes", source.run.density_modes},
            {"energy", frames.energy},
            {"temperature", frames.temperature},
            {"tables", tables_of(page_tables(source, frames_hash))}};
  if (source.record) json["record"] = measured(*source.record);
  return without_tags(json.dump(-1, ' ', false, Json::error_handler_t::replace));
}

}  // namespace gpf
