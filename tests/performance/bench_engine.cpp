// Nanoseconds of CPU time per pair collision, calendar and heap side by side: elastic periodic disks against N and area
// fraction, then the thesis' channel. One core; see --help.
#include <malloc.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

#include "gpf/event/engine.hpp"
#include "gpf/event/heap_queue.hpp"
#include "gpf/scene/start.hpp"
#include "performance/bench_scenes.hpp"
#include "performance/machine_state.hpp"
#include "performance/speed_page.hpp"

using namespace gpf;
using performance::calibration_step;
using performance::cpu_nanoseconds;
using performance::SpeedRow;

namespace {

struct Options {
  std::vector<std::int32_t> sizes{1000, 10'000, 100'000};
  std::vector<double> fractions{0.05, 0.30, 0.70};
  std::vector<double> channel_fractions{0.05, 0.30, 0.56, 0.85};
  double equilibration = 20;  ///< collisions per disk
  double collisions = 1e6;    ///< per repeat
  int repeats = 5;
  bool full = false, no_channel = false;
  std::string page;  ///< folder
};

/// What is allocated now, in bytes.
double allocated() {
  const auto info = mallinfo2();
  return static_cast<double>(info.uordblks + info.hblkhd);
}

/// One engine, advanced a stretch at a time.
template <class Queue>
class Runner {
 public:
  explicit Runner(const Scene& scene) : engine_(scene, start_state(scene)) {}

  /// Until at least so many more pair collisions have happened.
  void run(double collisions) {
    const double goal = static_cast<double>(engine_.counts().pair_contacts) + collisions;
    while (static_cast<double>(engine_.counts().pair_contacts) < goal) {
      // A sixteenth of an epoch is two collisions per disk or fewer.
      time_ += engine_.epoch_length() / 16;
      engine_.advance(time_);
    }
  }

  /// One repeat: keeps the time per collision.
  void measure(double collisions) {
    const EventCounts before = engine_.counts();
    const double began = cpu_nanoseconds();
    run(collisions);
    const double lasted = cpu_nanoseconds() - began;
    const EventCounts& now = engine_.counts();
    const auto done = static_cast<double>(now.pair_contacts - before.pair_contacts);
    nanoseconds_.push_back(lasted / done);
    collisions_ += done;
    crossings_ += static_cast<double>(now.crossings - before.crossings);
    stale_ += static_cast<double>(now.stale - before.stale);
    walls_ += static_cast<double>(now.wall_contacts - before.wall_contacts);
  }

  [[nodiscard]] double best() const { return *std::min_element(nanoseconds_.begin(), nanoseconds_.end()); }
  [[nodiscard]] double median() const {
    std::vector<double> sorted = nanoseconds_;
    std::sort(sorted.begin(), sorted.end());
    return (sorted[(sorted.size() - 1) / 2] + sorted[sorted.size() / 2]) / 2;
  }
  [[nodiscard]] double crossings() const { return crossings_ / collisions_; }
  [[nodiscard]] double stale() const { return stale_ / collisions_; }
  [[nodiscard]] double walls() const { return walls_ / collisions_; }
  [[nodiscard]] TraceHash trace_hash() const { return engine_.trace_hash(); }

 private:
  Engine<Queue> engine_;
  double time_ = 0;
  std::vector<double> nanoseconds_;
  double collisions_ = 0, crossings_ = 0, stale_ = 0, walls_ = 0;
};

void print_head() {
  std::printf("%8s %5s %5s | %9s %9s %9s | %9s %9s | %6s %6s %6s | %5s | %s\n", "N", "nu", "e_n", "calendar", "median",
              "10^6/s", "heap", "median", "cross", "stale", "walls", "bytes", "calibration");
}

/// Both queues in turn, so that a slow spell of the machine meets both. Exits with 1 if they differ in a bit.
SpeedRow bench(const Scene& scene, const Options& options) {
  const double before = allocated();
  Runner<CalendarQueue> calendar(scene);
  calendar.run(options.equilibration * scene.particles / 2);
  const double bytes = (allocated() - before) / scene.particles;
  Runner<HeapQueue> heap(scene);
  heap.run(options.equilibration * scene.particles / 2);
  double calibration = std::numeric_limits<double>::infinity();
  for (int k = 0; k < options.repeats; ++k) {
    calibration = std::min(calibration, calibration_step());
    calendar.measure(options.collisions);
    heap.measure(options.collisions);
  }
  std::printf("%8d %5.2f %5.2f | %9.1f %9.1f %9.2f | %9.1f %9.1f | %6.2f %6.2f %6.3f | %5.0f | %.2f\n", scene.particles,
              scene.area_fraction(), scene.normal_restitution, calendar.best(), calendar.median(),
              1e3 / calendar.best(), heap.best(), heap.median(), calendar.crossings(), calendar.stale(),
              calendar.walls(), bytes, calibration);
  std::fflush(stdout);
  if (calendar.trace_hash() != heap.trace_hash()) {
    std::printf("calendar and heap went different ways\n");
    std::exit(1);
  }
  return {scene, calendar.best(), calendar.median(), heap.best(), calendar.crossings(), bytes, calibration};
}

Options parse(int count, char** arguments) {
  Options options;
  CLI::App app("Nanoseconds of CPU time per pair collision of the event-driven engine");
  app.add_option("--sizes", options.sizes, "Numbers of disks")->capture_default_str();
  app.add_option("--fractions", options.fractions, "Area fractions of the periodic scenes")->capture_default_str();
  app.add_option("--channel-fractions", options.channel_fractions, "Area fractions of the channel")
      ->capture_default_str();
  app.add_option("--equilibration", options.equilibration, "Collisions per disk before the first measurement")
      ->capture_default_str();
  app.add_option("--collisions", options.collisions, "Pair collisions per repeat")->capture_default_str();
  app.add_option("--repeats", options.repeats, "Repeats; the best and the median are printed")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  app.add_flag("--full", options.full, "Add N = 10^6");
  app.add_flag("--no-channel", options.no_channel, "Leave the channel out");
  app.add_option("--page", options.page, "Folder for the page speed.md with its picture and data")
      ->check(CLI::ExistingDirectory);
  try {
    app.parse(count, arguments);
  } catch (const CLI::ParseError& error) {
    std::exit(app.exit(error));
  }
  if (options.full) options.sizes.push_back(1'000'000);
  return options;
}

}  // namespace

int main(int count, char** arguments) {
  const Options options = parse(count, arguments);
  std::printf(
      "nanoseconds of CPU time per pair collision, best and median of %d; events per collision; bytes per disk; "
      "calibration: nanoseconds per step of a fixed loop\n",
      options.repeats);
  print_head();
  std::vector<SpeedRow> rows;
  for (const std::int32_t particles : options.sizes)
    for (const double fraction : options.fractions)
      rows.push_back(bench(performance::periodic(particles, fraction), options));
  if (!options.no_channel)
    for (const double normal_restitution : {0.99, 0.80})
      for (const double fraction : options.channel_fractions)
        rows.push_back(bench(performance::channel(fraction, normal_restitution), options));
  if (!options.page.empty()) performance::write_speed_page(rows, options.repeats, options.page);
}
