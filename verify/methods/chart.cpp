#include "verify/methods/chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>

#include "gpf/base/error.hpp"
#include "gpf/measure/block_series.hpp"
#include "gpf/scene/toml_reader.hpp"
#include "verify/planner.hpp"
#include "verify/run_pool.hpp"
#include "verify/validate.hpp"

namespace gpf {
namespace {

/// Replicas of the methods are none of the reference's.
constexpr int first_replica = 1000;

/// What is known of a scene before any method is tried.
struct Reference {
  SceneFile file;
  std::vector<std::vector<Quantity>> replicas;
  std::vector<State> last_states;
  std::vector<std::string> names;
  double cpu_seconds = 0;  ///< of a replica
};

std::vector<Quantity> quantities_in(const Record& record) {
  const TallyLayout layout(record.run);
  return derive_quantities(record.scene, layout, block_totals(record.sums, layout.size()));
}

std::map<std::string, Reference> references(const ChartPlan& plan, const std::filesystem::path& folder,
                                            const RecordStore& records, int jobs,
                                            const volatile std::sig_atomic_t* stop) {
  SceneLibrary library(folder);
  Demand demand;
  for (const std::string& scene : plan.scenes()) demand[scene] = plan.reference_replicas;
  const std::uint64_t seed = default_release_seed();
  PoolOptions pool;
  pool.jobs = jobs;
  pool.stop = stop;
  pool.command = {"gpf", "chart"};
  const PoolResult done = run_pool(records, missing_runs(demand, library, records, seed), pool);
  if (done.stopped) return {};
  if (!done.failures.empty())
    throw PhysicsError(fmt::format("the reference {} cannot be run", done.failures.front().label),
                       done.failures.front().what, "take the scene out of reference/methods.toml, or mend it");
  std::map<std::string, Reference> all;
  for (const std::string& name : plan.scenes()) {
    const NamedScene& scene = library.of(name).front();
    Reference& reference = all[name];
    reference.file = scene.file;
    for (int r = 0; r < plan.reference_replicas; ++r) {
      const SceneFile file = replica_of(scene, r, seed);
      std::optional<Record> record = records.load(file);
      if (!record)
        throw StorageError(fmt::format("the record of {} #{} is gone", name, r + 1), "it was there a moment ago",
                           "run gpf chart again");
      reference.replicas.push_back(quantities_in(*record));
      reference.cpu_seconds += record->cpu_seconds / plan.reference_replicas;
      reference.last_states.push_back(std::move(record->final_state));
      reference.names.push_back(record_name(file.scene, file.run));
    }
  }
  return all;
}

bool has_chance(const MethodSetting& setting) { return setting.method != Method::hydrodynamics; }

std::vector<MethodRun> runs_of(const ChartSeries& series, const std::string& name, const Reference& reference,
                               int replicas) {
  const SceneFile file = varied(reference.file, series);
  std::vector<MethodRun> runs;
  for (int r = 0; r < (has_chance(series.setting) ? replicas : 1); ++r) {
    const SceneFile replica = replica_of(file, first_replica + r, 0);
    MethodRun run{fmt::format("{}, {} #{}", name, series.text(), r + 1), replica.scene, replica.run, series.setting};
    if (series.steady_window > 0) {
      const auto k = static_cast<std::size_t>(r) % reference.last_states.size();
      run.start = reference.last_states[k];
      run.start_name = reference.names[k];
    }
    runs.push_back(std::move(run));
  }
  return runs;
}

std::vector<std::vector<double>> observed_in(const Observable& observable,
                                             const std::vector<std::vector<Quantity>>& replicas) {
  std::vector<std::vector<double>> values;
  for (const auto& quantities : replicas) values.push_back(observed(observable, quantities));
  return values;
}

ChartPoint point_of(const ChartSeries& series, const std::string& name, const Reference& reference,
                    const std::vector<MethodRun>& runs, const MethodStore& store) {
  ChartPoint point;
  point.scene = name, point.series = series.text(), point.parameters = reference.file.scene;
  const Run& run = reference.file.run;
  point.replicas = static_cast<int>(runs.size());
  const double measured = series.steady_window > 0 ? series.steady_window : run.duration * series.length;
  point.run_length = run.start_up + measured;
  point.start_share = run.start_up / point.run_length;
  std::vector<std::vector<Quantity>> found;
  for (const MethodRun& r : runs) {
    const MethodResult result = store.load(r).value();
    if (!result.failure.empty()) point.failure = result.failure;
    point.cpu_seconds += result.flow.cpu_seconds / static_cast<double>(runs.size());
    found.push_back(result.flow.quantities);
  }
  // A run that began in the steady state is charged with what one from the lattice would cost.
  if (series.steady_window > 0) point.cpu_seconds *= point.run_length / (measured + series.steady_window / 8);
  if (!point.failure.empty()) return point;
  for (const Observable& observable : observables())
    point.misfits.emplace(observable.name, misfit_of(observed_in(observable, found),
                                                     observed_in(observable, reference.replicas), observable.absolute));
  return point;
}

/// The reference as runs of the engine: their noise, and no bias.
ChartPoint point_of_reference(const std::string& name, const Reference& reference) {
  ChartPoint point;
  point.scene = name, point.series = "event_driven", point.parameters = reference.file.scene;
  point.replicas = static_cast<int>(reference.replicas.size());
  point.cpu_seconds = reference.cpu_seconds;
  point.run_length = reference.file.run.start_up + reference.file.run.duration;
  point.start_share = reference.file.run.start_up / point.run_length;
  for (const Observable& observable : observables()) {
    const auto values = observed_in(observable, reference.replicas);
    point.misfits.emplace(observable.name, misfit_of(values, values, observable.absolute));
  }
  return point;
}

constexpr std::string_view header =
    "scene,series,particles,width_over_diameter,length_over_width,normal_restitution,wall_normal_restitution,"
    "beta_lower,beta_upper,gravity,tc_time,replicas,cpu_seconds,run_length,start_share,failure,observable,bias,"
    "resolution,noise";

std::string in_one_cell(std::string text) {
  for (char& c : text)
    if (c == ',' || c == '\n' || c == '"') c = ';';
  return text;
}

/// The cells of one line, read in order.
class Cells {
 public:
  Cells(std::string_view line, std::string where) : rest_(line), where_(std::move(where)) {}
  std::string text() {
    if (ended_) throw error("it has too few cells");
    const auto comma = rest_.find(',');
    std::string cell{rest_.substr(0, comma)};
    ended_ = comma == std::string_view::npos;
    rest_.remove_prefix(ended_ ? rest_.size() : comma + 1);
    return cell;
  }
  double number() {
    const std::string cell = text();
    if (cell == "nan") return NAN;
    double value = 0;
    const auto [end, problem] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (problem != std::errc{} || end != cell.data() + cell.size()) throw error(gpf::quoted(cell) + " is no number");
    return value;
  }
  int count() {
    const double value = number();
    if (!(value >= 0 && value <= 1e9)) throw error("a number of disks or runs cannot be so");
    return static_cast<int>(value);
  }
  void end() const {
    if (!ended_) throw error("it has too many cells");
  }

 private:
  [[nodiscard]] InputError error(std::string why) const {
    return {fmt::format("{} cannot be read", where_), std::move(why), "run gpf chart to write the file anew"};
  }
  std::string_view rest_;
  std::string where_;
  bool ended_ = false;
};

}  // namespace

const std::vector<Observable>& observables() {
  static const std::vector<Observable> all{{"mean_velocity", "U(y)", false},
                                           {"granular_temperature", "T(y)", false},
                                           {"area_fraction", "nu(y)", false},
                                           {"slip_velocity", "U_w/U_0", false},
                                           {"pressure_yy", "P_yy(y)", false},
                                           {"pressure_xy", "P_xy(y)", false},
                                           {"normal_stress_difference", "(P_xx - P_yy)/(P_xx + P_yy)", true},
                                           {"kurtosis_x", "kurtosis of u_x", false},
                                           {"mean_flow", "mean flow", false}};
  return all;
}

const Observable& observable_named(std::string_view name) {
  std::vector<std::string_view> names;
  for (const Observable& o : observables()) {
    if (o.name == name) return o;
    names.push_back(o.name);
  }
  throw InputError(fmt::format("no observable is called '{}'", name),
                   fmt::format("there are {}", fmt::join(names, ", ")), "choose one of them");
}

std::vector<double> observed(const Observable& observable, const std::vector<Quantity>& quantities) {
  if (observable.name != "normal_stress_difference") return values_of(quantities, observable.name);
  const std::vector<double>&xx = values_of(quantities, "pressure_xx"), &yy = values_of(quantities, "pressure_yy");
  std::vector<double> values;
  for (std::size_t b = 0; b < xx.size(); ++b) values.push_back((xx[b] - yy[b]) / (xx[b] + yy[b]));
  return values;
}

std::vector<ChartPoint> chart_points(const ChartPlan& plan, const std::filesystem::path& reference,
                                     const RecordStore& records, const MethodStore& store, int jobs,
                                     const volatile std::sig_atomic_t* stop) {
  const auto known = references(plan, reference, records, jobs, stop);
  if (known.empty()) return {};
  std::vector<MethodRun> all;
  for (const ChartSeries& series : plan.series)
    for (const std::string& scene : series.scenes)
      for (MethodRun& run : runs_of(series, scene, known.at(scene), plan.replicas)) all.push_back(std::move(run));
  if (!complete(store, all, jobs, stop)) return {};
  std::vector<ChartPoint> points;
  for (const ChartSeries& series : plan.series)
    for (const std::string& scene : series.scenes) {
      const Reference& r = known.at(scene);
      points.push_back(point_of(series, scene, r, runs_of(series, scene, r, plan.replicas), store));
    }
  // How the engine's noise goes on with the length of a run: the references tell it where no series does.
  for (const auto& [name, scene] : known) {
    const bool there = std::any_of(points.begin(), points.end(), [&name = name](const ChartPoint& p) {
      return p.scene == name && p.series == "event_driven";
    });
    if (!there) points.push_back(point_of_reference(name, scene));
  }
  return points;
}

std::string csv_of(const std::vector<ChartPoint>& points) {
  std::string csv = fmt::format("{}\n", header);
  for (const ChartPoint& p : points) {
    const Scene& s = p.parameters;
    const std::string begin =
        fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{:.4g},{:.6g},{:.4g},{}", p.scene, p.series, s.particles,
                    s.width_over_diameter, s.length_over_width, s.normal_restitution, s.wall_normal_restitution,
                    s.wall_tangential_restitution[0], s.wall_tangential_restitution[1], s.gravity, s.tc_time,
                    p.replicas, p.cpu_seconds, p.run_length, p.start_share, in_one_cell(p.failure));
    if (p.misfits.empty()) csv += begin + ",,nan,nan,nan\n";
    for (const auto& [name, m] : p.misfits)
      csv += fmt::format("{},{},{:.4g},{:.4g},{:.4g}\n", begin, name, m.bias, m.resolution, m.noise);
  }
  return csv;
}

std::vector<ChartPoint> points_in(std::string_view csv, const std::string& name) {
  std::vector<ChartPoint> points;
  std::size_t number = 0;
  while (!csv.empty()) {
    const std::string_view line = csv.substr(0, csv.find('\n'));
    csv.remove_prefix(std::min(csv.size(), line.size() + 1));
    if (++number == 1) {
      if (line != header)
        throw InputError(name + " is no table of chart points", "its first line is another one",
                         "run gpf chart to write the file anew");
      continue;
    }
    Cells cells(line, fmt::format("{}:{}", name, number));
    ChartPoint p;
    p.scene = cells.text();
    p.series = cells.text();
    Scene& s = p.parameters;
    s.geometry = Geometry::channel;
    s.particles = cells.count();
    for (double* x : {&s.width_over_diameter, &s.length_over_width, &s.normal_restitution, &s.wall_normal_restitution,
                      &s.wall_tangential_restitution[0], &s.wall_tangential_restitution[1], &s.gravity, &s.tc_time})
      *x = cells.number();
    p.replicas = cells.count();
    for (double* x : {&p.cpu_seconds, &p.run_length, &p.start_share}) *x = cells.number();
    p.failure = cells.text();
    const std::string observable = cells.text();
    Misfit m;
    for (double* x : {&m.bias, &m.resolution, &m.noise}) *x = cells.number();
    cells.end();
    if (points.empty() || points.back().scene != p.scene || points.back().series != p.series)
      points.push_back(std::move(p));
    if (!observable.empty()) points.back().misfits.emplace(observable, m);
  }
  return points;
}

}  // namespace gpf
