#include "verify/methods/chart_pages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>

#include "gpf/base/error.hpp"
#include "gpf/io/atomic_file.hpp"
#include "gpf/io/markdown.hpp"
#include "gpf/io/plot.hpp"
#include "verify/plot_files.hpp"

namespace gpf {
namespace {

/// What is drawn; the tables hold all observables.
constexpr std::array<std::string_view, 2> drawn{"mean_velocity", "granular_temperature"};
constexpr std::array<std::string_view, 5> methods{"hydrodynamics", "monte_carlo", "event_driven", "all_pairs",
                                                  "soft_disks"};

using Points = std::vector<const ChartPoint*>;

Points of_scene(const std::vector<ChartPoint>& points, const std::string& scene) {
  Points found;
  for (const ChartPoint& p : points)
    if (p.scene == scene) found.push_back(&p);
  return found;
}

std::optional<Misfit> misfit_in(const ChartPoint& p, std::string_view observable) {
  const auto found = p.misfits.find(observable);
  if (found == p.misfits.end() || !std::isfinite(found->second.bias)) return {};
  return found->second;
}

/// The number after `key` in a series' text; NaN when it is not there.
double number_after(const std::string& text, const std::string& key) {
  const auto at = text.find(key);
  return at == std::string::npos ? NAN : std::stod(text.substr(at + key.size()));
}

Plot cost_plot(const Points& points, const Observable& observable, const std::string& scene) {
  Plot plot{fmt::format("{}: {}", scene, observable.title), "CPU seconds of a run",
            observable.absolute ? "error" : "relative error", true, true};
  for (const std::string_view method : methods) {
    Series series{std::string(method)};
    for (const ChartPoint* p : points)
      if (const auto m = misfit_in(*p, observable.name); m && p->series.starts_with(method)) {
        series.x.push_back(p->cpu_seconds);
        series.y.push_back(std::hypot(m->total(), m->resolution));
      }
    if (!series.x.empty()) plot.series.push_back(std::move(series));
  }
  const std::vector<bool> best = pareto_front(points, observable.name);
  std::vector<std::pair<double, double>> front;
  for (std::size_t k = 0; k < points.size(); ++k)
    if (best[k]) {
      const Misfit m = *misfit_in(*points[k], observable.name);
      front.emplace_back(points[k]->cpu_seconds, std::hypot(m.total(), m.resolution));
    }
  std::sort(front.begin(), front.end());
  Series line{"Pareto front", SeriesStyle::line};
  for (const auto& [x, y] : front) line.x.push_back(x), line.y.push_back(y);
  if (line.x.size() > 1) plot.series.push_back(std::move(line));
  return plot;
}

std::string share(double x) { return std::isfinite(x) ? fmt::format("{:.2g}", 100 * x) : ""; }

std::string scene_table(const Points& points) {
  std::vector<std::string> header{"method", "CPU s"};
  for (const Observable& o : observables()) header.emplace_back(o.title);
  const std::vector<bool> best = pareto_front(points, drawn[0]);
  std::vector<std::vector<std::string>> rows;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const ChartPoint& p = *points[k];
    std::vector<std::string> row{p.series + (best[k] ? " *" : ""), fmt::format("{:.3g}", p.cpu_seconds)};
    if (!p.failure.empty()) row.push_back("gave up: " + p.failure);
    for (const Observable& o : observables())
      if (p.failure.empty()) {
        const auto m = misfit_in(p, o.name);
        row.push_back(m ? fmt::format("{} ({}), {}", share(m->bias), share(m->resolution), share(m->noise)) : "");
      }
    rows.push_back(std::move(row));
  }
  return markdown_table(header, rows);
}

bool varies_the_scene(const ChartPoint& p) {
  return p.series.find(" t_c x") != std::string::npos || p.series.find(" N x") != std::string::npos;
}

/// Which point is the cheapest within each tolerance, its bias at most and twice its noise taken together.
std::string cheapest_table(const ChartPlan& plan, const std::vector<ChartPoint>& points, std::string_view observable) {
  constexpr std::array tolerances{0.2, 0.1, 0.05, 0.02, 0.01};
  std::vector<std::string> header{"scene"};
  for (const double t : tolerances) header.push_back(fmt::format("{} %", 100 * t));
  std::vector<std::vector<std::string>> rows;
  for (const std::string& scene : plan.chart) {
    std::vector<std::string> row{scene};
    for (const double tolerance : tolerances) {
      const ChartPoint* cheapest = nullptr;
      for (const ChartPoint* p : of_scene(points, scene))
        if (const auto m = misfit_in(*p, observable); m && std::hypot(m->total(), m->resolution) <= tolerance &&
                                                      (cheapest == nullptr || p->cpu_seconds < cheapest->cpu_seconds))
          cheapest = p;
      row.push_back(cheapest == nullptr ? "none"
                                        : fmt::format("{}: {:.2g} s", cheapest->series, cheapest->cpu_seconds));
    }
    rows.push_back(std::move(row));
  }
  return markdown_table(header, rows);
}

/// A scan: for each chart scene the points that `x` gives an abscissa.
struct Scan {
  std::string file, title, xlabel, text;
  std::string_view observable;
  bool noise;  ///< draw the noise instead of the bias
  std::function<double(const ChartPoint&)> x;
};

std::vector<Scan> scans() {
  const auto plain = [](const ChartPoint& p) { return !varies_the_scene(p); };
  const auto when = [](bool yes, double x) { return yes ? x : NAN; };
  return {
      {"engine-length", "Engine: noise of U(y) against run length", "measured time",
       "The engine's noise falls with the square root of the measured time, or less where structures move slowly (e_n "
       ".80).",
       "mean_velocity", true,
       [=](const ChartPoint& p) {
         return when(p.series.starts_with("event_driven") && plain(p), p.run_length * (1 - p.start_share));
       }},
      {"engine-tc", "Engine: T(y) against t_c", "t_c over the scene's", "A longer t_c changes the flow: see limits.tc.",
       "granular_temperature", false, [](const ChartPoint& p) { return number_after(p.series, " t_c x"); }},
      {"engine-n", "Engine: T(y) against N", "N over the scene's",
       "Shorter channels: fewer disks, at the same nu and W.", "granular_temperature", false,
       [](const ChartPoint& p) { return number_after(p.series, " N x"); }},
      {"soft-contact", "Soft disks: T(y) against stiffness", "contact in mean free times of the start",
       "Contacts that last shorter are nearer to hard disks; 25 steps in each.", "granular_temperature", false,
       [=](const ChartPoint& p) {
         return when(p.series.starts_with("soft_disks") && number_after(p.series, "steps=") == 25,
                     number_after(p.series, "contact="));
       }},
      {"soft-steps", "Soft disks: T(y) against the time step", "steps in a contact of 0.02 mean free times",
       "Few steps in a contact give it another restitution.", "granular_temperature", false,
       [=](const ChartPoint& p) {
         return when(p.series.starts_with("soft_disks") && number_after(p.series, "contact=") == 0.02,
                     number_after(p.series, "steps="));
       }},
      {"monte-carlo-cells", "Enskog Monte Carlo: U(y) against the cells", "cells across the channel",
       "25 particles in each cell.", "mean_velocity", false,
       [=](const ChartPoint& p) {
         return when(p.series.starts_with("monte_carlo") && number_after(p.series, "particles=") == 25 &&
                         number_after(p.series, "step=") == 0.25,
                     number_after(p.series, "cells="));
       }},
      {"monte-carlo-particles", "Enskog Monte Carlo: U(y) against particles", "particles in a cell", "36 cells.",
       "mean_velocity", false,
       [=](const ChartPoint& p) {
         return when(p.series.starts_with("monte_carlo") && number_after(p.series, "cells=") == 36 &&
                         number_after(p.series, "step=") == 0.25,
                     number_after(p.series, "particles="));
       }},
      {"hydrodynamics-cells", "Hydrodynamics: U(y) against the grid", "cells across the channel",
       "Beyond some fifty cells all that is left is what the theory leaves out.", "mean_velocity", false,
       [=](const ChartPoint& p) {
         return when(p.series.starts_with("hydrodynamics") && p.series.find("garzo_dufty") == std::string::npos,
                     number_after(p.series, "cells="));
       }},
  };
}

Plot scan_plot(const Scan& scan, const ChartPlan& plan, const std::vector<ChartPoint>& points) {
  Plot plot{scan.title, scan.xlabel, scan.noise ? "noise, relative" : "bias, relative", true, true};
  double lowest = INFINITY, highest = 0, level = 0;
  for (const std::string& scene : plan.chart) {
    Series series{scene};
    for (const ChartPoint* p : of_scene(points, scene)) {
      const double x = scan.x(*p);
      const auto m = misfit_in(*p, scan.observable);
      if (!std::isfinite(x) || !m) continue;
      series.x.push_back(x);
      // A bias that is not seen is drawn where it would begin to be.
      series.y.push_back(scan.noise ? m->noise : std::max(m->bias, m->resolution));
      series.yerr.push_back(scan.noise ? 0 : std::min(m->resolution, 0.9 * series.y.back()));
      lowest = std::min(lowest, x), highest = std::max(highest, x);
      level = std::max(level, scan.noise ? m->noise * std::sqrt(x) : 0);
    }
    if (!series.x.empty()) plot.series.push_back(std::move(series));
  }
  if (scan.noise && highest > lowest)
    plot.series.push_back(
        {"slope -1/2", SeriesStyle::line, {lowest, highest}, {level / std::sqrt(lowest), level / std::sqrt(highest)}});
  return plot;
}

}  // namespace

std::vector<bool> pareto_front(const std::vector<const ChartPoint*>& points, std::string_view observable) {
  const auto error = [&](const ChartPoint& p) {
    const auto m = misfit_in(p, observable);
    return m ? std::hypot(m->total(), m->resolution) : INFINITY;
  };
  std::vector<bool> best;
  for (const ChartPoint* p : points) {
    const bool beaten = std::any_of(points.begin(), points.end(), [&](const ChartPoint* q) {
      return q->cpu_seconds <= p->cpu_seconds && error(*q) <= error(*p) &&
             (q->cpu_seconds < p->cpu_seconds || error(*q) < error(*p));
    });
    best.push_back(std::isfinite(error(*p)) && !beaten);
  }
  return best;
}

void write_chart_page(const ChartPlan& plan, const std::vector<ChartPoint>& points,
                      const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder / "methods", error);
  if (error)
    throw StorageError(fmt::format("cannot make the folder '{}'", folder.string()), error.message(),
                       "choose another --output");
  std::string page = fmt::format("# {}\n\n", plan.title);
  page += fmt::format(
      "Five methods on the same scenes: the event-driven engine, its oracle that examines all pairs, soft disks in "
      "time\n"
      "steps, Enskog's equation by Monte Carlo and channel hydrodynamics. Cost: CPU seconds of one run from the "
      "lattice,\n"
      "start-up included, on the machine of `gpf chart`. Error: against {} long runs of the engine, as root mean\n"
      "square over the bins, relative to that of the reference (normal stress difference: absolute), split into bias\n"
      "(of the mean over {} runs; with the standard error to which it is resolved) and noise (standard deviation of a\n"
      "single run). Plots show bias, its resolution and noise together. Measured by `gpf chart`; all points are in\n"
      "`reference/methods.csv`, from which `gpf chart --redraw` makes this page again.\n\n",
      plan.reference_replicas, plan.replicas);
  page +=
      "Runs of all pairs and soft disks begin in the engine's steady state, measure for a short window, and are "
      "charged\n"
      "with the time that a run from the lattice would have taken. What the advice of `gpf advise` rests on is the "
      "same\n"
      "table, with more scenes. Where each method fails: the claims `limits.*`.\n\n";
  for (const std::string_view name : drawn) {
    const Observable& o = observable_named(name);
    page += fmt::format("## The cheapest within a tolerance, {}\n\nBias at most, and twice the noise.\n\n{}\n", o.title,
                        cheapest_table(plan, points, name));
  }
  for (const std::string& scene : plan.chart) {
    const Points here = of_scene(points, scene);
    page += fmt::format("## {}\n\n", scene);
    for (const std::string_view name : drawn) {
      const std::string file = fmt::format("methods/{}-{}.svg", scene, name);
      write_plot(cost_plot(here, observable_named(name), scene), folder / file);
      page += plot_markdown(fmt::format("{} of {}", name, scene), file) + "\n";
    }
    page += fmt::format("Per cent: bias (resolution), noise. An asterisk: on the Pareto front of U(y).\n\n{}\n",
                        scene_table(here));
  }
  page += "## Against the settings of each method\n\n";
  for (const Scan& scan : scans()) {
    const Plot plot = scan_plot(scan, plan, points);
    if (plot.series.empty()) continue;
    const std::string file = fmt::format("methods/{}.svg", scan.file);
    write_plot(plot, folder / file);
    page += fmt::format("{}\n{}\n\n", plot_markdown(scan.title, file), scan.text);
  }
  write_text_atomically(folder / "methods.md", page);
}

}  // namespace gpf
