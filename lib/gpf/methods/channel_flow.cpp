#include "gpf/methods/channel_flow.hpp"

#include <fmt/format.h>

#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "gpf/base/error.hpp"
#include "gpf/base/vec2.hpp"
#include "gpf/theory/garzo_dufty.hpp"
#include "gpf/theory/jenkins_richman.hpp"

namespace gpf {
namespace {

using std::numbers::pi;

/// Disks are closely packed at .907, but Henderson's contact value diverges at 1 only. The iteration may go there - a
/// cap would leave it no way back - the result may not.
constexpr double densest = 0.9;

/// What a closure says of the gas at a node: viscosity, and q = -conductivity grad T - diffusive grad n.
struct Node {
  Gas gas;
  double viscosity, conductivity, diffusive;
};

/// The constitutive relations of disks with Henderson's contact value.
class Relations {
 public:
  Relations(Closure closure, double restitution, double diameter)
      : inelastic_(closure == Closure::garzo_dufty), restitution_(restitution), diameter_(diameter) {}

  [[nodiscard]] double pressure(double nu, double t) const {
    const Gas gas = jenkins_richman_gas(nu, t, diameter_);
    return inelastic_ ? garzo_dufty_pressure(gas, restitution_) : jenkins_richman_pressure(gas);
  }

  [[nodiscard]] double dissipation(const Gas& gas) const {
    return inelastic_ ? garzo_dufty_dissipation_rate(gas, restitution_) : dissipation_rate(gas, restitution_);
  }

  /// At pressure P and temperature T.
  [[nodiscard]] Node node(double p, double t) const {
    const Gas gas = jenkins_richman_gas(area_fraction(p, t), t, diameter_);
    if (!inelastic_) return {gas, shear_viscosity(gas), heat_conductivity(gas), 0};
    return {gas, garzo_dufty_viscosity(gas, restitution_), garzo_dufty_heat_conductivity(gas, restitution_),
            garzo_dufty_diffusive_heat_conductivity(gas, restitution_, henderson_contact_slope(gas.area_fraction))};
  }

 private:
  /// nu at pressure P and temperature T: p = n T (1 + f) grows with nu, f with nu g.
  [[nodiscard]] double area_fraction(double p, double t) const {
    const double ideal = 4 * t / (pi * square(diameter_));  // over nu
    double lo = 0, hi = 1, nu = std::min(0.5, p / ideal);
    for (int k = 0; k < 80; ++k) {
      const double here = pressure(nu, t);
      (here > p ? hi : lo) = nu;
      const double slope = ideal + (here / nu - ideal) * (2 + henderson_contact_slope(nu));
      double next = nu - (here - p) / slope;
      if (!(next > lo && next < hi)) next = (lo + hi) / 2;
      if (std::abs(next - nu) < 1e-15 * nu) return next;
      nu = next;
    }
    return nu;
  }

  bool inelastic_;
  double restitution_, diameter_;
};

/// Unknowns: for each node - the lower wall, the cells, the upper wall - U and ln T, and last ln P.
class Equations {
 public:
  Equations(const Scene& scene, const ChannelFlowSetting& setting)
      : scene_(scene),
        relations_(setting.closure, scene.normal_restitution, scene.diameter()),
        cells_(setting.cells),
        cell_((1 - scene.diameter()) / setting.cells) {}

  [[nodiscard]] int cells() const { return cells_; }
  [[nodiscard]] int nodes() const { return cells_ + 2; }
  [[nodiscard]] int size() const { return 2 * nodes() + 1; }
  [[nodiscard]] double cell() const { return cell_; }
  [[nodiscard]] const Relations& relations() const { return relations_; }
  static double velocity(const Eigen::VectorXd& x, Eigen::Index node) { return x[2 * node]; }
  static double temperature(const Eigen::VectorXd& x, Eigen::Index node) { return std::exp(x[2 * node + 1]); }
  static double pressure(const Eigen::VectorXd& x) { return std::exp(x[x.size() - 1]); }

  [[nodiscard]] Node node(const Eigen::VectorXd& x, int k) const {
    return relations_.node(pressure(x), temperature(x, k));
  }
  [[nodiscard]] std::vector<Node> all_nodes(const Eigen::VectorXd& x) const {
    std::vector<Node> all;
    for (int k = 0; k < nodes(); ++k) all.push_back(node(x, k));
    return all;
  }

  /// Momentum and heat that flow upward through the face below node k (k = 1 ... cells + 1).
  struct Flux {
    double momentum, heat, viscosity, shear;
  };
  [[nodiscard]] Flux flux(const Eigen::VectorXd& x, int k, const std::vector<Node>& all) const {
    const double distance = (k == 1 || k == cells_ + 1) ? cell_ / 2 : cell_;
    const Node &a = all[static_cast<std::size_t>(k) - 1], &b = all[static_cast<std::size_t>(k)];
    const double viscosity = (a.viscosity + b.viscosity) / 2, conductivity = (a.conductivity + b.conductivity) / 2,
                 diffusive = (a.diffusive + b.diffusive) / 2;
    const double shear = (velocity(x, k) - velocity(x, k - 1)) / distance;
    const double heat = -conductivity * (b.gas.granular_temperature - a.gas.granular_temperature) / distance -
                        diffusive * (b.gas.number_density() - a.gas.number_density()) / distance;
    return {-viscosity * shear, heat, viscosity, shear};
  }

  [[nodiscard]] Eigen::VectorXd residual(const Eigen::VectorXd& x) const {
    Eigen::VectorXd r(size());
    const std::vector<Node> all = all_nodes(x);
    std::vector<Flux> faces{{}};
    for (int k = 1; k <= cells_ + 1; ++k) faces.push_back(flux(x, k, all));
    double disks = 0;
    for (int k = 1; k <= cells_; ++k) {
      const Flux &below = faces[static_cast<std::size_t>(k)], &above = faces[static_cast<std::size_t>(k) + 1];
      const Gas& here = all[static_cast<std::size_t>(k)].gas;
      const double n = here.number_density();
      disks += n * cell_;
      // Half of the heating at each face belongs to either cell; what the walls' faces heat is their cell's own.
      const auto heating = [&](const Flux& f, bool wall) { return (wall ? 1 : 0.5) * f.viscosity * square(f.shear); };
      const double distance_below = k == 1 ? cell_ / 2 : cell_, distance_above = k == cells_ ? cell_ / 2 : cell_;
      const Eigen::Index row = 2 * Eigen::Index{k};
      r[row] = (below.momentum - above.momentum) / cell_ + n * scene_.gravity;
      r[row + 1] = (below.heat - above.heat + distance_below * heating(below, k == 1) +
                    distance_above * heating(above, k == cells_)) /
                       cell_ -
                   relations_.dissipation(here);
    }
    wall(x, 0, -faces[1].momentum, -faces[1].heat, lower, r);
    wall(x, cells_ + 1, faces.back().momentum, faces.back().heat, upper, r);
    r[size() - 1] = disks - scene_.particles / scene_.length();
    return r;
  }

  /// What may be left of each: 1e-9 of the weight in a cell over its size, more where round-off of the terms that
  /// cancel is larger - thin gases between smooth walls are that hot and fast.
  [[nodiscard]] Eigen::VectorXd tolerance(const Eigen::SparseMatrix<double>& derivative,
                                          const Eigen::VectorXd& x) const {
    const Eigen::VectorXd terms = derivative.cwiseAbs() * x.cwiseAbs().cwiseMax(1);
    return (1e-12 * terms).array() + 1e-9 * scene_.particles / scene_.length() / cell_;
  }

 private:
  /// What flows into the wall is what its collisions take.
  void wall(const Eigen::VectorXd& x, Eigen::Index node, double momentum, double heat, Wall which,
            Eigen::VectorXd& r) const {
    const double e = scene_.wall_normal_restitution,
                 beta = scene_.wall_tangential_restitution[static_cast<std::size_t>(which)];
    const double t = temperature(x, node), collisions = pressure(x) / ((1 + e) * std::sqrt(pi * t / 2));
    r[2 * node] = (momentum - collisions * (1 - beta) * 2 / (1 + beta) * velocity(x, node)) / cell_;
    r[2 * node + 1] = (heat - collisions * ((1 - square(beta)) / 2 + 1 - square(e)) * t) / cell_;
  }

  Scene scene_;
  Relations relations_;
  int cells_;
  double cell_;
};

/// The derivative of the residual by central differences: where walls hardly hold the gas, one-sided ones stall
/// Newton's method. A node touches its neighbours only, so that every third may be moved at once.
Eigen::SparseMatrix<double> derivative(const Equations& equations, const Eigen::VectorXd& x) {
  std::vector<Eigen::Triplet<double>> entries;
  const int last = equations.size() - 1;
  const auto step_of = [](double value) { return 3e-6 * std::max(1.0, std::abs(value)); };
  for (int colour = 0; colour < 3; ++colour)
    for (int kind = 0; kind < 2; ++kind) {
      Eigen::VectorXd up = x, down = x;
      for (int k = colour; k < equations.nodes(); k += 3) {
        const int column = 2 * k + kind;
        const double step = step_of(x[column]);
        up[column] += step, down[column] -= step;
        // The number of disks: each node's share by itself.
        if (kind == 1 && k > 0 && k <= equations.cells())
          entries.emplace_back(
              last, column,
              (equations.node(up, k).gas.number_density() - equations.node(down, k).gas.number_density()) *
                  equations.cell() / (2 * step));
      }
      const Eigen::VectorXd change = equations.residual(up) - equations.residual(down);
      for (int k = colour; k < equations.nodes(); k += 3) {
        const int column = 2 * k + kind;
        for (int row = std::max(0, 2 * k - 2); row < std::min(last, 2 * k + 4); ++row)
          entries.emplace_back(row, column, change[row] / (2 * step_of(x[column])));
      }
    }
  Eigen::VectorXd up = x, down = x;
  const double step = step_of(x[last]);
  up[last] += step, down[last] -= step;
  const Eigen::VectorXd change = equations.residual(up) - equations.residual(down);
  for (int row = 0; row <= last; ++row) entries.emplace_back(row, last, change[row] / (2 * step));
  Eigen::SparseMatrix<double> matrix(last + 1, last + 1);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

struct Outcome {
  bool converged = false;
  int steps = 0;
  double residual = 0;
};

/// Newton's method from x, led by pseudo-time steps that double.
Outcome solve(const Equations& equations, Eigen::VectorXd& x) {
  constexpr int most_steps = 120;
  Eigen::VectorXd r = equations.residual(x);
  double pseudo_time = 0.02;
  Outcome outcome;
  for (; outcome.steps < most_steps && !outcome.converged; ++outcome.steps) {
    Eigen::SparseMatrix<double> matrix = derivative(equations, x);
    const Eigen::VectorXd allowed = equations.tolerance(matrix, x);
    // Cells change by no more than their rate times the pseudo-time; walls and pressure follow at once.
    for (int k = 1; k <= equations.cells(); ++k) {
      const double n = equations.node(x, k).gas.number_density();
      const Eigen::Index row = 2 * Eigen::Index{k};
      matrix.coeffRef(row, row) -= n / pseudo_time;
      matrix.coeffRef(row + 1, row + 1) -= n * Equations::temperature(x, k) / pseudo_time;
    }
    Eigen::SparseLU<Eigen::SparseMatrix<double>> solver(matrix);
    if (solver.info() != Eigen::Success) break;
    const Eigen::VectorXd step = solver.solve(-r);
    // ln T and ln P by no more than 1/2 at once.
    double largest = std::abs(step[step.size() - 1]);
    for (Eigen::Index k = 0; k < equations.nodes(); ++k) largest = std::max(largest, std::abs(step[2 * k + 1]));
    if (!(largest < 1e6)) {
      pseudo_time /= 8;
      continue;
    }
    pseudo_time *= largest > 0.5 ? 0.7 : 2;
    x += step * std::min(1.0, 0.5 / largest);
    r = equations.residual(x);
    outcome.converged = (r.cwiseAbs() - allowed).maxCoeff() < 0;
  }
  outcome.residual = r.norm();
  return outcome;
}

/// A uniform gas at T = 1 that moves at 1.
Eigen::VectorXd uniform(const Equations& equations, const Scene& scene) {
  Eigen::VectorXd x(equations.size());
  for (Eigen::Index k = 0; k < equations.nodes(); ++k) x[2 * k] = 1, x[2 * k + 1] = 0;
  const double nu = std::min(scene.area_fraction() / (1 - scene.diameter()), 0.8);
  x[equations.size() - 1] = std::log(equations.relations().pressure(nu, 1));
  return x;
}

void refuse_packed(const Equations& equations, const Eigen::VectorXd& x, double restitution) {
  double most = 0;
  for (int k = 1; k <= equations.cells(); ++k) most = std::max(most, equations.node(x, k).gas.area_fraction);
  if (most > densest)
    throw PhysicsError(
        "the theory packs the disks as densely as they go",
        fmt::format(
            "nu reaches {:.3g} in the plug at e_n = {:.4g}, where the pressure is no longer that of disks; less "
            "restitution packs them more",
            most, restitution),
        "use the event-driven engine; where cells are not small against a free path, more of them may help");
}

/// The scene's solution; what a uniform gas does not lead to is reached from elastic disks, step by step in 1 - e_n.
Eigen::VectorXd solution(const Scene& scene, const ChannelFlowSetting& setting, int& steps) {
  const Equations equations(scene, setting);
  Eigen::VectorXd x = uniform(equations, scene);
  Outcome last = solve(equations, x);
  steps = last.steps;
  if (last.converged) return x;
  const double target = 1 - scene.normal_restitution;
  double reached = 0, step = target / 16;
  Scene easier = scene;
  easier.normal_restitution = 1;
  x = uniform(equations, scene);
  last = solve(Equations(easier, setting), x);
  steps += last.steps;
  while (last.converged && reached < target && step > target / 1000 && steps < 1000) {
    const double next = std::min(target, reached + step);
    easier.normal_restitution = next < target ? 1 - next : scene.normal_restitution;
    const Equations between(easier, setting);
    Eigen::VectorXd trial = x;
    const Outcome outcome = solve(between, trial);
    steps += outcome.steps;
    if (outcome.converged) {
      refuse_packed(between, trial, easier.normal_restitution);
      x = trial, reached = next, step *= 1.5;
    } else {
      last.residual = outcome.residual, step /= 4;
    }
  }
  if (!last.converged || reached < target)
    throw PhysicsError("the profiles of the channel do not converge",
                       fmt::format("the residual stays at {:.3g}; elastic disks led to e_n = {:.4g} at best",
                                   last.residual, 1 - reached),
                       "the theory may have no steady state there; use the event-driven engine, or try more cells");
  return x;
}

void check(const Scene& scene, int cells) {
  const auto require = [](bool ok, std::string problem, const char* why, const char* remedy) {
    if (!ok) throw InputError(std::move(problem), why, remedy);
  };
  require(scene.geometry == Geometry::channel && scene.gravity > 0, "no channel under gravity",
          "the equations are those of gravity-driven flow between walls", "give a channel scene");
  for (const double beta : scene.wall_tangential_restitution)
    require(beta > -1 && beta < 1, fmt::format("beta_w = {}", beta), "such a wall takes no momentum, or all slip",
            "take a value between -1 and 1");
  require(cells >= 8, fmt::format("{} cells", cells), "the profiles would not be resolved", "take 100");
  require(cells <= 10000, fmt::format("{} cells", cells), "round-off would be all that finer ones resolve", "take 100");
}

}  // namespace

ChannelProfile channel_flow(const Scene& scene, const ChannelFlowSetting& setting) {
  const int cells = setting.cells;
  check(scene, cells);
  // Solved for g = 1: velocities go with the square root of g, temperatures and stresses with g.
  Scene unit = scene;
  unit.gravity = 1;
  ChannelProfile profile;
  const Equations equations(unit, setting);
  const Eigen::VectorXd x = solution(unit, setting, profile.newton_steps);
  refuse_packed(equations, x, scene.normal_restitution);

  double flow = 0, disks = 0;
  for (int k = 1; k <= cells; ++k) {
    const Gas gas = equations.node(x, k).gas;
    profile.y.push_back(scene.diameter() / 2 + (k - 0.5) * equations.cell());
    profile.mean_velocity.push_back(Equations::velocity(x, k));
    profile.granular_temperature.push_back(gas.granular_temperature);
    profile.area_fraction.push_back(gas.area_fraction);
    flow += gas.number_density() * Equations::velocity(x, k), disks += gas.number_density();
  }
  const std::vector<Node> all = equations.all_nodes(x);
  const Equations::Flux bottom = equations.flux(x, 1, all), top = equations.flux(x, cells + 1, all);
  profile.pressure = Equations::pressure(x);
  profile.slip_lower = Equations::velocity(x, 0);
  profile.slip_upper = Equations::velocity(x, cells + 1);
  profile.shear_lower = -bottom.momentum;
  profile.shear_upper = top.momentum;
  profile.heat_lower = -bottom.heat;
  profile.heat_upper = top.heat;
  profile.mean_flow = flow / disks;
  const double g = scene.gravity, root = std::sqrt(g);
  for (double& u : profile.mean_velocity) u *= root;
  for (double& t : profile.granular_temperature) t *= g;
  for (double* stress : {&profile.pressure, &profile.shear_lower, &profile.shear_upper}) *stress *= g;
  for (double* u : {&profile.slip_lower, &profile.slip_upper, &profile.mean_flow}) *u *= root;
  for (double* heat : {&profile.heat_lower, &profile.heat_upper}) *heat *= g * root;
  return profile;
}

}  // namespace gpf
