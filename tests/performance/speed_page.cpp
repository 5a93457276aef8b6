#include "performance/speed_page.hpp"

#include <fmt/format.h>

#include <array>
#include <fstream>
#include <map>
#include <string>

#include "gpf/io/atomic_file.hpp"
#include "gpf/io/markdown.hpp"
#include "gpf/io/plot.hpp"
#include "gpf/io/provenance.hpp"
#include "gpf/scene/canonical_text.hpp"

namespace gpf::performance {
namespace {

using Cells = std::vector<std::string>;

/// Of N and area fraction in per cent: 10^6 pair collisions per second.
using Speeds = std::map<std::pair<std::int32_t, int>, double>;

int percent(const Scene& scene) { return static_cast<int>(100 * scene.area_fraction() + 0.5); }

/// Of the fastest of other public codes, reference/data/Smallenburg_2022/speed.csv.
Speeds others() {
  Speeds speeds;
  std::ifstream file(GPF_REFERENCE_DATA "/Smallenburg_2022/speed.csv");
  std::string line;
  std::getline(file, line);  // names of the columns
  char comma = 0;
  double fraction = 0, speed = 0;
  for (std::int32_t particles = 0; file >> particles >> comma >> fraction >> comma >> speed;)
    speeds[{particles, static_cast<int>(100 * fraction + 0.5)}] = speed;
  return speeds;
}

std::string csv(const std::vector<SpeedRow>& rows) {
  std::string text =
      "geometry,particles,area_fraction,normal_restitution,best_ns,median_ns,heap_best_ns,crossings_per_collision,"
      "bytes_per_disk,calibration_ns\n";
  for (const SpeedRow& r : rows)
    text += fmt::format("{},{},{:.2f},{:.2f},{:.1f},{:.1f},{:.1f},{:.3f},{:.0f},{:.3f}\n", name_of(r.scene.geometry),
                        r.scene.particles, r.scene.area_fraction(), r.scene.normal_restitution, r.best, r.median,
                        r.heap_best, r.crossings, r.bytes, r.calibration);
  return text;
}

Plot plot(const std::vector<SpeedRow>& rows, const Speeds& peers) {
  Plot plot{.title = "Elastic periodic disks: pair collisions per second of one core",
            .xlabel = "number of disks",
            .ylabel = "10^6 pair collisions per second",
            .logx = true,
            .logy = true};
  std::map<int, Series> ours, theirs;
  for (const SpeedRow& r : rows) {
    if (r.scene.geometry != Geometry::periodic) continue;
    const int nu = percent(r.scene);
    ours[nu].x.push_back(r.scene.particles);
    ours[nu].y.push_back(1e3 / r.best);
    if (const auto peer = peers.find({r.scene.particles, nu}); peer != peers.end()) {
      theirs[nu].x.push_back(r.scene.particles);
      theirs[nu].y.push_back(peer->second);
    }
  }
  for (auto& [nu, series] : ours) {
    series.label = fmt::format("gpf, nu .{:02d}", nu);
    series.style = SeriesStyle::line;
    plot.series.push_back(series);
  }
  for (auto& [nu, series] : theirs) {
    series.label = fmt::format("fastest other, nu .{:02d}", nu);
    plot.series.push_back(series);
  }
  return plot;
}

std::string table(const std::vector<SpeedRow>& rows, const Speeds& peers, Geometry geometry) {
  std::vector<Cells> cells;
  for (const SpeedRow& r : rows) {
    if (r.scene.geometry != geometry) continue;
    const auto peer = peers.find({r.scene.particles, percent(r.scene)});
    cells.push_back({std::to_string(r.scene.particles), fmt::format("{:.2f}", r.scene.area_fraction()),
                     fmt::format("{:.2f}", r.scene.normal_restitution), fmt::format("{:.0f}", r.best),
                     fmt::format("{:.0f}", r.median), fmt::format("{:.2f}", 1e3 / r.best),
                     fmt::format("{:.0f}", r.heap_best), fmt::format("{:.2f}", r.crossings),
                     fmt::format("{:.0f}", r.bytes)});
    if (geometry == Geometry::periodic)
      cells.back().push_back(
          peer == peers.end() ? "-" : fmt::format("{:.2f} ({:.1f} times)", peer->second, 1e3 / r.best / peer->second));
  }
  Cells head{"N", "nu", "e_n", "best, ns", "median, ns", "10^6/s", "heap, ns", "crossings", "bytes per disk"};
  if (geometry == Geometry::periodic) head.push_back("fastest other, 10^6/s");
  return markdown_table(head, cells);
}

}  // namespace

void write_speed_page(const std::vector<SpeedRow>& rows, int repeats, const std::filesystem::path& folder) {
  const Speeds peers = others();
  const BuildProvenance build = build_provenance();
  const SessionProvenance session = session_provenance({});
  write_svg(plot(rows, peers), folder / "speed.svg");
  write_text_atomically(folder / "speed.csv", csv(rows));
  write_text_atomically(
      folder / "speed.md",
      fmt::format(
          "<!-- Written by bench_engine --page: do not edit. -->\n"
          "# How fast the event loop is\n\n"
          "CPU time of one core per pair collision, best and median of {} repeats, in equilibrium; with the calendar "
          "queue, and\nwith the heap in turn. Made by gpf {} ({}, {}) on {}, {}. The clock of a shared machine "
          "scatters by a fifth;\nthe gate of continuous integration counts instructions instead. All numbers: "
          "[speed.csv](speed.csv).\n\n"
          "![Speed against the number of disks](speed.svg)\n\n"
          "## Elastic disks in a periodic box\n\n{}\n"
          "The fastest other is the best of the public codes built and timed on another machine, on another "
          "day:\n[its origin](../reference/data/Smallenburg_2022/ORIGIN.md).\n\n"
          "## The thesis' channel\n\n{}\n"
          "What was tried to make it faster, won or lost: "
          "[DECISIONS.md](../lib/gpf/event/DECISIONS.md).\n",
          repeats, build.version, build.commit.substr(0, 12), build.compiler, session.cpu,
          session.utc_time.substr(0, 10), table(rows, peers, Geometry::periodic),
          table(rows, peers, Geometry::channel)));
}

}  // namespace gpf::performance
