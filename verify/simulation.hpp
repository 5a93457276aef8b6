// One run under way: the engine, watched, with checkpoints on the way.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

#include "gpf/base/cpu_time.hpp"
#include "gpf/event/engine.hpp"
#include "gpf/event/physics_version.hpp"
#include "gpf/io/checkpoint.hpp"
#include "gpf/io/provenance.hpp"
#include "gpf/measure/measurement.hpp"
#include "gpf/scene/start.hpp"
#include "verify/simulate.hpp"

namespace gpf {

/// `Physics` is the rules' type of Engine, `Watcher` a Measurement or what stands before one.
template <class Physics = GranularPhysics, class Watcher = Measurement>
class Simulation {
  using Clock = std::chrono::steady_clock;

 public:
  Simulation(const SceneFile& file, const SimulationOptions& options)
      : file_(file), options_(options), measurement_(file.scene, file.run), engine_(begin()) {}

  std::optional<Record> run() {
    while (!finished()) {
      const double next_sample = static_cast<double>(samples_ + 1) * file_.run.sample_interval;
      engine_.advance(std::min(next_sample, engine_.epoch_end()), measurement_);
      if (engine_.time() == next_sample) take_sample(next_sample);
      if (engine_.at_epoch_start() && stop_or_save()) return std::nullopt;
      report_progress();
    }
    return record();
  }

 private:
  Engine<CalendarQueue, Physics> begin() {
    const auto& path = options_.checkpoint;
    if (!options_.resume || !path || !std::filesystem::exists(*path)) {
      const State start = start_state(file_.scene);
      if (first_measured_ == 0) measurement_.begin(0, start);
      return {file_.scene, start};
    }
    const Checkpoint c = read_checkpoint(file_.scene, file_.run, *path);
    measurement_.restore(c.measurement);
    history_ = c.history;
    snapshots_ = c.snapshots;
    samples_ = c.samples;
    contacts_at_begin_ = c.contacts_at_begin;
    overlap_before_ = c.deepest_overlap;
    wall_before_ = c.wall_seconds;
    cpu_before_ = c.cpu_seconds;
    contacts_at_start_ = c.engine.counts.pair_contacts;
    return {file_.scene, c.engine};
  }

  void take_sample(double time) {
    ++samples_;
    const State state = engine_.state();
    history_.offer(time, state, file_.run.bins);
    const std::vector<double>& wanted = file_.run.snapshots;
    while (snapshots_.size() < wanted.size() && wanted[snapshots_.size()] < time + file_.run.sample_interval / 2)
      snapshots_.push_back({time, state});
    if (measurement_.begun()) {
      measurement_.sample(time, state);
    } else if (samples_ == first_measured_) {
      measurement_.begin(time, state);
      contacts_at_begin_ = engine_.counts().pair_contacts;
    }
  }

  static double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  }
  [[nodiscard]] double measured_time() const {
    return static_cast<double>(samples_ - first_measured_) * file_.run.sample_interval;
  }
  [[nodiscard]] double collisions_per_particle() const {
    return 2 * static_cast<double>(engine_.counts().pair_contacts - contacts_at_begin_) / file_.scene.particles;
  }

  /// Every target that is given has been reached.
  [[nodiscard]] bool finished() const {
    return measurement_.begun() && measured_time() >= file_.run.duration &&
           collisions_per_particle() >= file_.run.collisions_per_particle && measurement_.series().blocks() > 0;
  }

  /// True when the run must stop here.
  bool stop_or_save() {
    const bool stop = options_.stop != nullptr && *options_.stop != 0;
    if (options_.checkpoint && (stop || seconds_since(saved_) > options_.checkpoint_period)) {
      write_checkpoint(file_.scene, file_.run,
                       {engine_.checkpoint(), measurement_.memory(), history_, snapshots_, samples_, contacts_at_begin_,
                        std::max(overlap_before_, engine_.deepest_overlap()), wall_seconds(), cpu_seconds()},
                       *options_.checkpoint);
      saved_ = Clock::now();
    }
    return stop;
  }

  void report_progress() {
    if (!options_.progress || seconds_since(reported_) < 0.2) return;
    reported_ = Clock::now();
    const Run& run = file_.run;
    const double time = engine_.time();
    // Of the targets the one furthest away counts; collisions to come are extrapolated from those since measurement
    // began.
    double fraction = run.duration > 0 ? time / (run.start_up + run.duration) : 1;
    if (run.collisions_per_particle > 0) {
      const double done = measurement_.begun() ? collisions_per_particle() / run.collisions_per_particle : 0;
      fraction = std::min(fraction, done);
    }
    const double elapsed = seconds_since(started_);
    const auto contacts = engine_.counts().pair_contacts;
    if (!first_fraction_) first_fraction_ = fraction;
    const double gained = fraction - *first_fraction_;
    options_.progress({std::min(fraction, 1.0), time, contacts,
                       static_cast<double>(contacts - contacts_at_start_) / elapsed,
                       gained > 0 ? elapsed * (1 - fraction) / gained : never});
  }

  [[nodiscard]] double wall_seconds() const { return wall_before_ + seconds_since(started_); }
  [[nodiscard]] double cpu_seconds() const { return cpu_before_ + thread_cpu_seconds() - cpu_at_start_; }

  [[nodiscard]] Record record() const {
    Record r;
    r.scene_text = file_.text;
    r.scene = file_.scene;
    r.run = file_.run;
    r.physics_version = physics_version;
    r.trace_hash = engine_.trace_hash().value();
    r.time = engine_.time();
    r.epoch_length = engine_.epoch_length();
    r.deepest_overlap = std::max(overlap_before_, engine_.deepest_overlap());
    r.counts = engine_.counts();
    r.blocks = measurement_.series().blocks();
    r.sums.assign(measurement_.series().sums().begin(), measurement_.series().sums().end());
    r.arrays = measurement_.arrays();
    r.history = history_;
    r.snapshots = snapshots_;
    r.final_state = engine_.state();
    r.build = to_json(build_provenance());
    r.session = to_json(session_provenance(options_.command));
    r.wall_seconds = wall_seconds();
    r.cpu_seconds = cpu_seconds();
    return r;
  }

  const SceneFile& file_;
  const SimulationOptions& options_;
  Clock::time_point started_ = Clock::now(), saved_ = started_, reported_ = started_;
  double cpu_at_start_ = thread_cpu_seconds();
  double wall_before_ = 0, cpu_before_ = 0, overlap_before_ = 0;
  std::uint64_t contacts_at_start_ = 0, contacts_at_begin_ = 0, samples_ = 0;
  const std::uint64_t first_measured_ =
      static_cast<std::uint64_t>(std::ceil(file_.run.start_up / file_.run.sample_interval));
  std::optional<double> first_fraction_;
  Watcher measurement_;
  History history_;
  std::vector<Snapshot> snapshots_;
  Engine<CalendarQueue, Physics> engine_;
};

}  // namespace gpf
