// gpf advise and gpf flow: no more model than a scene needs, and any method by hand.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>
#include <string>

#include "gpf/base/error.hpp"
#include "gpf/flow/range.hpp"
#include "gpf/io/markdown.hpp"
#include "verify/commands.hpp"
#include "verify/methods/advice.hpp"
#include "verify/methods/advice_table.hpp"

namespace gpf {
namespace {

/// "5%" or "0.05".
double tolerance_in(const std::string& text) {
  std::size_t used = 0;
  double value = NAN;
  try {
    value = std::stod(text, &used);
  } catch (const std::logic_error&) {
    used = 0;
  }
  const bool percent = text.ends_with('%');
  if (used == 0 || used + (percent ? 1 : 0) != text.size())
    throw InputError(fmt::format("--tolerance {}", text), "it is no number", "write 5% or 0.05");
  return percent ? value / 100 : value;
}

void warn(const SteadyFlow& flow) {
  for (const std::string& warning : flow.warnings) fmt::print(stderr, "gpf: warning: {}\n", warning);
}

/// Those of a table that there are: some hold for channels only.
void print_profiles(const std::vector<Quantity>& quantities) {
  const auto there = [&](const char* name) {
    return std::any_of(quantities.begin(), quantities.end(), [&](const Quantity& q) { return q.name == name; });
  };
  std::vector<std::pair<const char*, const char*>> columns{
      {"area_fraction", "nu"}, {"mean_velocity", "U"},  {"granular_temperature", "T"}, {"pressure_xx", "P_xx"},
      {"pressure_yy", "P_yy"}, {"pressure_xy", "P_xy"}, {"kurtosis_x", "kurt_x"},
  };
  std::erase_if(columns, [&](const auto& column) { return !there(column.first); });
  std::string text = fmt::format("{:>8}", "y");
  for (const auto& [name, title] : columns) text += fmt::format(" {:>11}", title);
  const std::size_t bins = values_of(quantities, "area_fraction").size();
  for (std::size_t b = 0; b < bins; ++b) {
    text += fmt::format("\n{:8.4f}", (static_cast<double>(b) + 0.5) / static_cast<double>(bins));
    for (const auto& [name, title] : columns) text += fmt::format(" {:>11.5g}", values_of(quantities, name)[b]);
  }
  text += "\n";
  for (const char* name : {"mean_flow", "slip_velocity", "wall_temperature", "wall_pressure_lower", "wall_shear_lower",
                           "wall_shear_upper"})
    if (there(name)) text += fmt::format("{:20} {:.5g}\n", name, values_of(quantities, name).front());
  fmt::print("{}", text);
}

void print_json(const std::string& method, const SteadyFlow& flow) {
  std::string text = fmt::format("{{\"method\": \"{}\", \"cpu_seconds\": {:.6g}", method, flow.cpu_seconds);
  for (const Quantity& q : flow.quantities) {
    std::vector<std::string> values;
    for (const double v : q.values) values.push_back(std::isfinite(v) ? fmt::format("{}", v) : "null");
    text += q.several ? fmt::format(", \"{}\": [{}]", q.name, fmt::join(values, ", "))
                      : fmt::format(", \"{}\": {}", q.name, values.front());
  }
  fmt::print("{}}}\n", text);
}

void print_advice(const Scene& scene, const Advice& advice, const Observable& observable, double tolerance) {
  const Candidate& best = advice.best();
  for (const std::string& warning : range_warnings(scene, parse_method(best.method)))
    fmt::print(stderr, "gpf: warning: {}\n", warning);
  fmt::print("{} within {:.3g}: {}\n", observable.title, tolerance, best.method);
  if (best.method == "event_driven")
    fmt::print("Nothing but the engine will do, or nothing is cheaper.\n");
  else
    fmt::print("bias at most {:.2g}, noise {:.2g} (one standard deviation)\n", best.bias_at_most, best.noise);
  if (best.duration > 0) fmt::print("measured for {:.4g} after the scene's start-up\n", best.duration);
  fmt::print("{}\n\n", std::isfinite(best.cpu_seconds) ? fmt::format("about {:.2g} CPU s", best.cpu_seconds)
                                                       : "cost unknown: no like scene was tried");
  std::vector<std::vector<std::string>> rows;
  for (const Candidate& c : advice.candidates)
    rows.push_back({c.method, c.usable() && std::isfinite(c.cpu_seconds) ? fmt::format("{:.2g}", c.cpu_seconds) : "",
                    c.usable() ? fmt::format("{:.2g}", c.error_at_most()) : "", c.usable() ? "yes" : c.why_not});
  fmt::print("{}", markdown_table({"method", "CPU s", "error at most", "will it do?"}, rows));
  if (!best.evidence.empty()) fmt::print("\nmeasured on\n");
  for (const std::string& line : best.evidence) fmt::print("- {}\n", line);
}

/// Runs the advised method, and the engine for a while; does the second contradict the first?
ExitStatus run_and_check(const SceneFile& file, const Advice& advice, const Observable& observable, double tolerance) {
  const Candidate& best = advice.best();
  Run run = file.run;
  if (best.duration > 0) run.duration = std::max(best.duration, run.sample_interval);
  const SteadyFlow flow = steady_flow(file.scene, run, parse_method(best.method));
  fmt::print("\n{}: {:.3g} CPU s\n", best.method, flow.cpu_seconds);
  print_profiles(flow.quantities);
  if (best.method == "event_driven") return ExitStatus::success;
  const auto engine = std::find_if(advice.candidates.begin(), advice.candidates.end(),
                                   [](const Candidate& c) { return c.method == "event_driven"; });
  // Short: its noise is a quarter of the tolerance.
  Run check = file.run;
  const double factor = engine->noise > 0 ? std::pow(4 * engine->noise / tolerance, 2) : 1;
  check.duration = std::max(engine->duration * factor, file.run.sample_interval);
  const double noise = engine->noise / std::sqrt(factor);
  const SteadyFlow truth = steady_flow(file.scene, check, parse_method("event_driven"));
  const Misfit m =
      misfit_of({observed(observable, flow.quantities)}, {observed(observable, truth.quantities)}, observable.absolute);
  const double allowed = tolerance + 2 * noise;
  fmt::print(
      "\nagainst {:.3g} of the engine ({:.3g} CPU s): {} differs by {:.3g}; tolerance and twice the engine's "
      "noise allow {:.3g}\n",
      check.duration, truth.cpu_seconds, observable.title, m.bias, allowed);
  if (m.bias <= allowed) return ExitStatus::success;
  fmt::print(
      "The engine contradicts the advice: use the engine for this scene, and add it to reference/methods.toml,\nrun "
      "gpf chart and build again.\n");
  return ExitStatus::red;
}

}  // namespace

void add_advise_command(CLI::App& app, int& status) {
  struct Options {
    std::filesystem::path scene;
    std::string observable = "mean_velocity", tolerance = "5%";
    bool run = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand(
      "advise", "Name the cheapest method that is accurate enough, by what gpf chart measured (reference/methods.csv)");
  command->add_option("scene", options->scene, "The scene file")->required();
  std::vector<std::string_view> names;
  for (const Observable& o : observables()) names.push_back(o.name);
  command->add_option("--observable", options->observable, "What is to be accurate")
      ->type_name(fmt::format("{{{}}}", fmt::join(names, ",")))
      ->capture_default_str();
  command->add_option("--tolerance", options->tolerance, "Of the value, bias and twice the noise: 5% or 0.05")
      ->capture_default_str();
  command->add_flag("--run", options->run, "Do it, and check it against a short run of the engine");
  command->footer(
      "Exit status: 0; with --run 1 when the engine contradicts the method.\n"
      "Examples:\n"
      "  gpf advise reference/scenes/channel-rough-nu10-e99.toml --observable slip_velocity --tolerance 5%\n"
      "  gpf advise my-scene.toml --run\n");
  command->callback([options, &status] {
    const SceneFile file = load_scene(options->scene);
    const Observable& observable = observable_named(options->observable);
    const double tolerance = tolerance_in(options->tolerance);
    const Advice advice = advise(advice_table(), file.scene, file.run, observable, tolerance);
    print_advice(file.scene, advice, observable, tolerance);
    status = static_cast<int>(options->run ? run_and_check(file, advice, observable, tolerance) : ExitStatus::success);
  });
}

void add_flow_command(CLI::App& app, int& status) {
  struct Options {
    std::filesystem::path scene;
    std::string method = "hydrodynamics";
    bool json = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("flow", "The steady flow of a scene by any of the methods");
  command->add_option("scene", options->scene, "The scene file; [run] says for how long")->required();
  command
      ->add_option("--method", options->method,
                   "event_driven, all_pairs, soft_disks, monte_carlo or hydrodynamics, and its numbers")
      ->capture_default_str();
  command->add_flag("--json", options->json, "Print one JSON object instead of tables");
  command->footer(
      "Examples:\n"
      "  gpf flow reference/scenes/channel-smooth-nu15-e99.toml\n"
      "  gpf flow my-scene.toml --method \"monte_carlo cells=36 particles=50\" --json\n");
  command->callback([options, &status] {
    const SceneFile file = load_scene(options->scene);
    const MethodSetting setting = parse_method(options->method);
    const SteadyFlow flow = steady_flow(file.scene, file.run, setting);
    warn(flow);
    if (options->json) {
      print_json(text_of(setting), flow);
    } else {
      fmt::print("{}: {:.3g} CPU s\n", text_of(setting), flow.cpu_seconds);
      print_profiles(flow.quantities);
    }
    status = static_cast<int>(ExitStatus::success);
  });
}

}  // namespace gpf
