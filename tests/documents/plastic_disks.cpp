// Example of reference/guide/rule.md: another rule for pairs, through the engine's policy.
#include <cstdio>

#include "gpf/event/engine.hpp"
#include "gpf/measure/measurement.hpp"
#include "gpf/measure/quantities.hpp"
#include "gpf/scene/scene_file.hpp"
#include "gpf/scene/start.hpp"

using namespace gpf;

/// Disks that deform plastically: above the speed v_0 = velocity_scale() the restitution falls as e_n (v/v_0)^(-1/4)
/// (K. L. Johnson, Contact Mechanics (1985), sec. 11.5), v the normal speed of approach.
class PlasticDisks {
 public:
  explicit PlasticDisks(const Scene& scene)
      : restitution_(scene.normal_restitution), v_0_(scene.velocity_scale()), memory_(scene.tc_time) {}

  PairOutcome operator()(Vec2 r_12, Vec2 u_12, double time_since_last_contact) const {
    const double approach = dot(u_12, r_12), r2 = dot(r_12, r_12), speed = approach / std::sqrt(r2);
    const double plastic = speed > v_0_ ? restitution_ / std::sqrt(std::sqrt(speed / v_0_)) : restitution_;
    const double e = memory_.restitution(plastic, time_since_last_contact);
    return {(0.5 * (1 + e) * approach / r2) * r_12, 0.25 * (1 - e * e) * approach * approach / r2};
  }

 private:
  double restitution_, v_0_;
  ContactMemory memory_;
};

/// The physics of a scene, as GranularPhysics has it but for the pairs.
struct PlasticPhysics {
  explicit PlasticPhysics(const Scene& scene) : pair(scene), wall(scene) {}
  PlasticDisks pair;
  FlatWalls wall;
};

/// Runs the scene and prints where the work of gravity goes.
template <class Physics>
void run(const char* name, const SceneFile& file) {
  const Run& run = file.run;
  Engine<CalendarQueue, Physics> engine(file.scene, start_state(file.scene));
  Measurement measurement(file.scene, run);
  engine.advance(run.start_up, measurement);
  measurement.begin(run.start_up, engine.state());
  std::vector<double> totals(measurement.layout().size());
  for (double time = run.start_up; time < run.start_up + run.duration;) {
    time += run.sample_interval;
    engine.advance(time, measurement);
    measurement.sample(time, engine.state());
  }
  const auto sums = measurement.series().sums();
  for (std::size_t k = 0; k < sums.size(); ++k) totals[k % totals.size()] += sums[k];
  std::printf("%s:", name);
  for (const Quantity& q : derive_quantities(file.scene, measurement.layout(), totals))
    if (q.name == "mean_flow" || q.name == "pair_loss" || q.name == "energy_residual")
      std::printf(" %s %.4g", q.name.c_str(), std::abs(q.values.front()) < 1e-10 ? 0 : q.values.front());
  std::printf("\n");
}

int main(int, char** arguments) {
  const SceneFile file = load_scene(arguments[1]);
  run<GranularPhysics>("smooth disks", file);
  run<PlasticPhysics>("plastic disks", file);
}
