// Watches a run and fills its tallies.
#pragma once

#include <optional>
#include <vector>

#include "gpf/event/observer.hpp"
#include "gpf/measure/bins.hpp"
#include "gpf/measure/block_series.hpp"
#include "gpf/measure/correlations.hpp"
#include "gpf/measure/distributions.hpp"
#include "gpf/measure/tallies.hpp"
#include "gpf/scene/scene.hpp"
#include "gpf/scene/state.hpp"

namespace gpf {

/// An observer of contacts that is also shown the state at the end of every sample interval.
class Measurement {
 public:
  Measurement(const Scene& scene, int bins, Detail detail = Detail::profiles, int density_modes = 0);
  Measurement(const Scene& scene, const Run& run) : Measurement(scene, run.bins, run.detail, run.density_modes) {}

  /// Measurement starts here; contacts seen before are forgotten.
  void begin(double time, const State& state);
  void on_pair(const PairContact& contact);
  void on_wall(const WallContact& contact);
  /// Ends a sample interval: adds the fields of this state and puts the interval into the series.
  void sample(double time, const State& state);

  [[nodiscard]] bool begun() const { return begun_; }
  [[nodiscard]] const TallyLayout& layout() const { return layout_; }
  [[nodiscard]] const BlockSeries& series() const { return series_; }
  /// Sums of the whole run that `detail` asks for; see Distributions and Correlations.
  [[nodiscard]] NamedArrays arrays() const;

  /// A disk between contacts, in the laboratory: what its free path needs.
  struct Travel {
    double time = 0;     ///< of its last contact with anything
    Vec2 velocity;       ///< after it
    Vec2 displacement;   ///< from its last pair contact to that contact
    double started = 0;  ///< 1 once it has had a pair contact
  };
  /// All of it, for a checkpoint.
  struct Memory {
    bool begun;
    double last_time, momentum_time, momentum, energy;
    std::vector<double> open;
    std::vector<Travel> travels;
    BlockSeries::Memory series;
    NamedArrays arrays;
  };
  [[nodiscard]] Memory memory() const;
  /// Throws InputError when the memory belongs to another scene or other bins.
  void restore(const Memory& memory);

 private:
  double& sum(Tally tally, int k = 0) { return open_[layout_.at(tally, k)]; }
  void travel(std::int32_t disk, double time, Vec2 velocity_after, const PairContact* pair);
  void gravity_until(double time);
  void add_fields(const State& state);
  void add_density_modes(const State& state);
  void add_stress(Vec2 impulse, Vec2 r, double from, double to);

  bool channel_;
  double disks_, gravity_, radius_, length_;
  Bins bins_;
  TallyLayout layout_;
  BlockSeries series_;
  std::optional<Distributions> distributions_;
  std::optional<Correlations> correlations_;
  bool begun_ = false;
  double last_time_ = 0;                     // end of the last interval
  double momentum_time_ = 0, momentum_ = 0;  // total x momentum at that time
  double energy_ = 0;                        // total kinetic energy at last_time_
  std::vector<double> open_;                 // the interval under way
  std::vector<Travel> travels_;
};

}  // namespace gpf
