#include "verify/trial/trial_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "gpf/measure/quantities.hpp"
#include "verify/estimators/parallel.hpp"
#include "verify/estimators/scene_values.hpp"
#include "verify/simulate.hpp"
#include "verify/store.hpp"

namespace gpf {
namespace {

constexpr std::array<std::string_view, 10> of_channel{
    "mean_flow",           "centre_velocity",     "slip_velocity",    "collision_rate",   "mean_free_path",
    "wall_pressure_lower", "wall_pressure_upper", "wall_shear_lower", "wall_shear_upper", "granular_temperature"};
constexpr std::array<std::string_view, 5> of_gas{"compressibility", "collision_rate", "mean_free_path", "pair_loss",
                                                 "granular_temperature"};

SceneFile channel(const char* name, double nu, double width, double restitution, const char* walls) {
  return parse_scene(fmt::format("[scene]\ngeometry = \"channel\"\nparticles = 60\narea_fraction = {}\n"
                                 "width_over_diameter = {}\nnormal_restitution = {}\n"
                                 "wall_normal_restitution = 0.95\nwall_tangential_restitution = {}\nseed = 1\n"
                                 "[run]\nstart_up = 4\nduration = 12\nsample_interval = 0.25\nbins = 4\n",
                                 nu, width, restitution, walls),
                     name);
}

bool wanted(const Scene& scene, std::string_view name) {
  if (scene.geometry == Geometry::channel)
    return std::find(of_channel.begin(), of_channel.end(), name) != of_channel.end();
  return std::find(of_gas.begin(), of_gas.end(), name) != of_gas.end();
}

std::vector<Quantity> measured(const Record& record) {
  std::vector<Quantity> quantities = derive_quantities(record.scene, TallyLayout(record.run), totals_of(record));
  std::erase_if(quantities, [&](const Quantity& q) { return !wanted(record.scene, q.name); });
  return quantities;
}

std::vector<std::string> labels_of(const std::vector<Quantity>& quantities) {
  std::vector<std::string> labels;
  for (const Quantity& q : quantities)
    for (std::size_t k = 0; k < q.values.size(); ++k)
      labels.push_back(q.several ? fmt::format("{}, bin {}", q.name, k + 1) : q.name);
  return labels;
}

}  // namespace

std::vector<SceneFile> trial_scenes() {
  return {channel("channel nu .3, e_n .90", 0.3, 9, 0.9, "0.9"), channel("channel nu .3, e_n .91", 0.3, 9, 0.91, "0.9"),
          channel("channel nu .1, e_n .80, walls that differ", 0.1, 15, 0.8, "[0.9, 0.3]"),
          parse_scene("[scene]\ngeometry = \"periodic\"\nparticles = 64\narea_fraction = 0.4\nlength_over_width = 1\n"
                      "normal_restitution = 0.98\nseed = 1\n[run]\nstart_up = 0.5\nduration = 4\n"
                      "sample_interval = 0.125\nbins = 4\n",
                      "periodic gas nu .4, e_n .98")};
}

TrialRuns run_trial_scenes(int replicas) {
  const std::vector<SceneFile> scenes = trial_scenes();
  const auto count = static_cast<std::size_t>(replicas);
  TrialRuns result{std::vector<std::vector<std::string>>(scenes.size()),
                   std::vector<std::vector<TrialRun>>(scenes.size(), std::vector<TrialRun>(count))};
  for_each_in_parallel(scenes.size() * count, [&](std::size_t k) {
    const std::size_t scene = k % scenes.size(), replica = k / scenes.size();
    const Record record = *simulate(replica_of(scenes[scene], static_cast<int>(replica), 0));
    const std::vector<Quantity> quantities = measured(record);
    TrialRun& run = result.runs[scene][replica];
    run.trace_hash = record.trace_hash;
    for (const Quantity& q : quantities) run.values.insert(run.values.end(), q.values.begin(), q.values.end());
    if (replica == 0) result.labels[scene] = labels_of(quantities);
  });
  return result;
}

}  // namespace gpf
