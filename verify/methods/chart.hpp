// Cost and error of each method on each scene, in each observable.
#pragma once

#include <csignal>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "verify/methods/chart_plan.hpp"
#include "verify/methods/method_runs.hpp"
#include "verify/methods/misfit.hpp"
#include "verify/store.hpp"

namespace gpf {

/// What is compared.
struct Observable {
  std::string_view name, title;
  bool absolute;  ///< may vanish: errors are not relative
};
/// mean_velocity, granular_temperature, area_fraction, slip_velocity, pressure_yy, pressure_xy,
/// normal_stress_difference (P_xx - P_yy)/(P_xx + P_yy), kurtosis_x, mean_flow.
const std::vector<Observable>& observables();
/// Throws InputError that lists the known ones.
const Observable& observable_named(std::string_view name);
/// One value a bin, or one.
std::vector<double> observed(const Observable& observable, const std::vector<Quantity>& quantities);

/// A method on a scene.
struct ChartPoint {
  std::string scene, series;
  Scene parameters;
  int replicas = 0;
  double cpu_seconds = 0;                              ///< of a run from the lattice: start-up and measured time
  double run_length = 0;                               ///< start-up and measured time, W = 1 and the scene's unit
  double start_share = 0;                              ///< start-up's part of run_length
  std::string failure;                                 ///< why the method gave up in some replica; empty: it did not
  std::map<std::string, Misfit, std::less<>> misfits;  ///< by observable; of a method that gave up none
};

/// The runs of the plan, and the records of the references, that are missing are made first. Throws StorageError,
/// InputError; PhysicsError when a reference cannot be run. Empty when stopped. Where no series runs the engine for the
/// scene's own time the references themselves are such a point.
std::vector<ChartPoint> chart_points(const ChartPlan& plan, const std::filesystem::path& reference,
                                     const RecordStore& records, const MethodStore& store, int jobs,
                                     const volatile std::sig_atomic_t* stop);

/// One line for each point and observable, as reference/methods.csv holds it.
std::string csv_of(const std::vector<ChartPoint>& points);
/// Reads that back. Throws InputError with the line.
std::vector<ChartPoint> points_in(std::string_view csv, const std::string& name);

}  // namespace gpf
