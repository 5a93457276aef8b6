#include "verify/faults/faulty_simulation.hpp"

#include "gpf/base/error.hpp"
#include "verify/simulation.hpp"
#include "verify/store.hpp"

namespace gpf {
namespace {

/// The fault at work in this thread: the engine makes its rules from a scene alone.
struct Injection {
  const FaultPoints* points = nullptr;
  FaultState state;
};
thread_local Injection injection;

/// Stands in for GranularPhysics.
struct FaultyPhysics {
  explicit FaultyPhysics(const Scene& scene) : right(scene) {}

  [[nodiscard]] PairOutcome pair(Vec2 r_12, Vec2 u_12, double quiet) const {
    const auto fault = injection.points->pair;
    return fault ? fault({right.pair, r_12, u_12, quiet}, injection.state) : right.pair(r_12, u_12, quiet);
  }
  [[nodiscard]] Vec2 wall(Vec2 velocity, Wall wall, double quiet) const {
    const auto fault = injection.points->wall;
    return fault ? fault({right.wall, velocity, wall, quiet}, injection.state) : right.wall(velocity, wall, quiet);
  }

  GranularPhysics right;
};

/// Stands before a Measurement.
class FaultyMeasurement : public Measurement {
 public:
  using Measurement::Measurement;

  void begin(double time, State state) {
    energy_at_begin_ = energy(state);
    if (const auto fault = injection.points->sampled) fault(state, injection.state);
    Measurement::begin(time, state);
  }
  void on_pair(PairContact contact) {
    const auto fault = injection.points->seen_pair;
    for (int times = fault ? fault(contact, injection.state) : 1; times > 0; --times) Measurement::on_pair(contact);
  }
  void on_wall(WallContact contact) {
    const auto fault = injection.points->seen_wall;
    for (int times = fault ? fault(contact, injection.state) : 1; times > 0; --times) Measurement::on_wall(contact);
  }
  /// A gas that nothing drives and a fault cools comes to rest: a run that is to last for so many collisions never
  /// ends.
  void sample(double time, State state) {
    if (energy(state) < 1e-6 * energy_at_begin_)
      throw PhysicsError("the disks have come to rest", "the fault takes their energy", "try a smaller dose");
    if (const auto fault = injection.points->sampled) fault(state, injection.state);
    Measurement::sample(time, state);
  }

 private:
  static double energy(const State& state) {
    double sum = 0;
    for (const Vec2 c : state.velocity) sum += dot(c, c);
    return sum;
  }
  double energy_at_begin_ = 0;
};

}  // namespace

RunFunction simulate_with(const Fault& fault, double dose, std::filesystem::path right) {
  return [points = fault.points, dose, right = std::move(right)](
             const SceneFile& file, const SimulationOptions& options) -> std::optional<Record> {
    std::optional<Record> record;
    if (points.only_recorded()) record = RecordStore(right, Trust::same_sources).load(file);
    if (!record) {
      SceneFile played = file;
      if (points.scene) points.scene(played.scene, played.run, dose);
      injection = {&points, {.dose = dose, .scene = played.scene, .last_u_12 = {}, .last_sampled = {}}};
      SimulationOptions without_checkpoint = options;
      without_checkpoint.checkpoint.reset();
      record = Simulation<FaultyPhysics, FaultyMeasurement>(played, without_checkpoint).run();
      injection.points = nullptr;
    }
    if (!record) return record;
    record->scene_text = file.text;
    record->scene = file.scene;
    record->run = file.run;
    if (points.recorded) points.recorded(*record, dose);
    return record;
  };
}

}  // namespace gpf
