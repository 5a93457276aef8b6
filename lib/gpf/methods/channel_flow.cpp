#include "gpf/methods/channel_flow.hpp"

#include <fmt/format.h>

#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "gpf/base/error.hpp"
#include "gpf/base/vec2.hpp"
#include "gpf/theory/jenkins_richman.hpp"

namespace gpf {
namespace {

using std::numbers::pi;

/// Where Henderson's contact value ends to be of use: p diverges at 1, disks are closely packed at .907.
constexpr double densest = 0.9;

/// Unknowns: for each node - the lower wall, the cells, the upper wall - U and ln T, and last ln P.
class Equations {
 public:
  Equations(const Scene& scene, int cells)
      : scene_(scene), cells_(cells), diameter_(scene.diameter()), cell_((1 - diameter_) / cells) {}

  [[nodiscard]] int nodes() const { return cells_ + 2; }
  [[nodiscard]] int size() const { return 2 * nodes() + 1; }
  [[nodiscard]] double cell() const { return cell_; }
  static double velocity(const Eigen::VectorXd& x, int node) { return x[2 * node]; }
  static double temperature(const Eigen::VectorXd& x, int node) { return std::exp(x[2 * node + 1]); }
  static double pressure(const Eigen::VectorXd& x) { return std::exp(x[x.size() - 1]); }

  /// nu at pressure P and temperature T: p grows with nu.
  [[nodiscard]] double area_fraction(double p, double t) const {
    double lo = 0, hi = densest;
    double nu = std::min(0.5, p * pi * square(diameter_) / (4 * t));
    for (int k = 0; k < 60; ++k) {
      const double excess = jenkins_richman_pressure(jenkins_richman_gas(nu, t, diameter_)) - p;
      (excess > 0 ? hi : lo) = nu;
      const double slope =
          (jenkins_richman_pressure(jenkins_richman_gas(nu * (1 + 1e-7), t, diameter_)) - p - excess) / (1e-7 * nu);
      double next = nu - excess / slope;
      if (!(next > lo && next < hi)) next = (lo + hi) / 2;
      if (std::abs(next - nu) < 1e-15) return next;
      nu = next;
    }
    return nu;
  }

  [[nodiscard]] Gas gas(const Eigen::VectorXd& x, int node) const {
    const double t = temperature(x, node);
    return jenkins_richman_gas(area_fraction(pressure(x), t), t, diameter_);
  }

  /// Momentum and heat that flow upward through the face below node k (k = 1 ... cells + 1).
  struct Flux {
    double momentum, heat, viscosity, shear;
  };
  [[nodiscard]] Flux flux(const Eigen::VectorXd& x, int k, const std::vector<Gas>& gases) const {
    const double distance = (k == 1 || k == cells_ + 1) ? cell_ / 2 : cell_;
    const Gas &a = gases[static_cast<std::size_t>(k) - 1], &b = gases[static_cast<std::size_t>(k)];
    const double mu = (shear_viscosity(a) + shear_viscosity(b)) / 2,
                 kappa = (heat_conductivity(a) + heat_conductivity(b)) / 2;
    const double shear = (velocity(x, k) - velocity(x, k - 1)) / distance;
    return {-mu * shear, -kappa * (temperature(x, k) - temperature(x, k - 1)) / distance, mu, shear};
  }

  [[nodiscard]] Eigen::VectorXd residual(const Eigen::VectorXd& x) const {
    Eigen::VectorXd r(size());
    std::vector<Gas> gases;
    for (int k = 0; k < nodes(); ++k) gases.push_back(gas(x, k));
    std::vector<Flux> faces{{}};
    for (int k = 1; k <= cells_ + 1; ++k) faces.push_back(flux(x, k, gases));
    double disks = 0;
    for (int k = 1; k <= cells_; ++k) {
      const Flux &below = faces[static_cast<std::size_t>(k)], &above = faces[static_cast<std::size_t>(k) + 1];
      const Gas& here = gases[static_cast<std::size_t>(k)];
      const double n = here.number_density();
      disks += n * cell_;
      // Half of the heating at each face belongs to either cell; what the walls' faces heat is their cell's own.
      const auto heating = [&](const Flux& f, bool wall) { return (wall ? 1 : 0.5) * f.viscosity * square(f.shear); };
      const double distance_below = k == 1 ? cell_ / 2 : cell_, distance_above = k == cells_ ? cell_ / 2 : cell_;
      r[2 * k] = (below.momentum - above.momentum) / cell_ + n * scene_.gravity;
      r[2 * k + 1] = (below.heat - above.heat + distance_below * heating(below, k == 1) +
                      distance_above * heating(above, k == cells_)) /
                         cell_ -
                     dissipation_rate(here, scene_.normal_restitution);
    }
    wall(x, 0, -faces[1].momentum, -faces[1].heat, lower, r);
    wall(x, cells_ + 1, faces.back().momentum, faces.back().heat, upper, r);
    r[size() - 1] = disks - scene_.particles / scene_.length();
    return r;
  }

 private:
  /// What flows into the wall is what its collisions take.
  void wall(const Eigen::VectorXd& x, int node, double momentum, double heat, Wall which, Eigen::VectorXd& r) const {
    const double e = scene_.wall_normal_restitution,
                 beta = scene_.wall_tangential_restitution[static_cast<std::size_t>(which)];
    const double t = temperature(x, node), collisions = pressure(x) / ((1 + e) * std::sqrt(pi * t / 2));
    r[2 * node] = (momentum - collisions * (1 - beta) * 2 / (1 + beta) * velocity(x, node)) / cell_;
    r[2 * node + 1] = (heat - collisions * ((1 - square(beta)) / 2 + 1 - square(e)) * t) / cell_;
  }

  Scene scene_;
  int cells_;
  double diameter_, cell_;
};

/// The derivative of the residual by differences: a node touches its neighbours only, so that every third may be moved
/// at once.
Eigen::SparseMatrix<double> derivative(const Equations& equations, const Eigen::VectorXd& x, const Eigen::VectorXd& r) {
  std::vector<Eigen::Triplet<double>> entries;
  const int last = equations.size() - 1;
  const auto step_of = [](double value) { return 1e-7 * std::max(1.0, std::abs(value)); };
  for (int colour = 0; colour < 3; ++colour)
    for (int kind = 0; kind < 2; ++kind) {
      Eigen::VectorXd moved = x;
      for (int k = colour; k < equations.nodes(); k += 3) moved[2 * k + kind] += step_of(x[2 * k + kind]);
      const Eigen::VectorXd change = equations.residual(moved) - r;
      for (int k = colour; k < equations.nodes(); k += 3) {
        const int column = 2 * k + kind;
        for (int row = std::max(0, 2 * k - 2); row < std::min(last, 2 * k + 4); ++row)
          entries.emplace_back(row, column, change[row] / step_of(x[column]));
      }
      // The number of disks: each node's share by itself.
      if (kind == 1)
        for (int k = std::max(1, colour); k < equations.nodes() - 1; ++k)
          if (k % 3 == colour) {
            const double step = step_of(x[2 * k + 1]);
            Eigen::VectorXd one = x;
            one[2 * k + 1] += step;
            entries.emplace_back(last, 2 * k + 1,
                                 (equations.gas(one, k).number_density() - equations.gas(x, k).number_density()) *
                                     equations.cell() / step);
          }
    }
  Eigen::VectorXd moved = x;
  moved[last] += 1e-7;
  const Eigen::VectorXd change = equations.residual(moved) - r;
  for (int row = 0; row <= last; ++row) entries.emplace_back(row, last, change[row] / 1e-7);
  Eigen::SparseMatrix<double> matrix(last + 1, last + 1);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
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
}

}  // namespace

ChannelProfile channel_flow(const Scene& given, int cells) {
  check(given, cells);
  // Solved for g = 1: velocities go with the square root of g, temperatures and stresses with g.
  Scene scene = given;
  scene.gravity = 1;
  const Equations equations(scene, cells);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(equations.size());
  const double mean_fraction = scene.area_fraction() / (1 - scene.diameter());
  const double start_temperature = 1;
  for (int k = 0; k < equations.nodes(); ++k) x[2 * k] = 1, x[2 * k + 1] = std::log(start_temperature);
  x[equations.size() - 1] = std::log(
      jenkins_richman_pressure(jenkins_richman_gas(std::min(mean_fraction, 0.8), start_temperature, scene.diameter())));

  constexpr int most_steps = 400;
  // Fluxes are of the order of the weight; what is left of them in a cell, over its size, is round-off below this.
  const double converged = 1e-9 * scene.particles / scene.length() / equations.cell();
  Eigen::VectorXd r = equations.residual(x);
  double pseudo_time = 0.02;
  ChannelProfile profile;
  for (; profile.newton_steps < most_steps; ++profile.newton_steps) {
    Eigen::SparseMatrix<double> matrix = derivative(equations, x, r);
    // Cells change by no more than their rate times the pseudo-time; walls and pressure follow at once.
    for (int k = 1; k <= cells; ++k) {
      const double n = equations.gas(x, k).number_density();
      matrix.coeffRef(2 * k, 2 * k) -= n / pseudo_time;
      matrix.coeffRef(2 * k + 1, 2 * k + 1) -= n * Equations::temperature(x, k) / pseudo_time;
    }
    Eigen::SparseLU<Eigen::SparseMatrix<double>> solver(matrix);
    if (solver.info() != Eigen::Success) break;
    Eigen::VectorXd step = solver.solve(-r);
    // ln T and ln P by no more than 1/2 at once.
    double largest = std::abs(step[step.size() - 1]);
    for (int k = 0; k < equations.nodes(); ++k) largest = std::max(largest, std::abs(step[2 * k + 1]));
    if (!(largest < 1e6)) {
      pseudo_time /= 8;
      continue;
    }
    if (largest > 0.5) step *= 0.5 / largest;
    pseudo_time *= largest > 0.5 ? 0.7 : 2;
    x += step;
    r = equations.residual(x);
    if (r.cwiseAbs().maxCoeff() < converged) {
      ++profile.newton_steps;
      break;
    }
  }
  if (!(r.cwiseAbs().maxCoeff() < converged))
    throw PhysicsError("the profiles of the channel do not converge",
                       fmt::format("the residual is {:.3g} after {} steps", r.norm(), profile.newton_steps),
                       "the theory may have no steady state there; use the event-driven engine");

  for (int k = 1; k <= cells; ++k)
    if (equations.gas(x, k).area_fraction > 0.999 * densest)
      throw PhysicsError(
          "the theory packs the disks as densely as they go",
          fmt::format("nu reaches {} in the plug, where its pressure is no longer that of disks", densest),
          "use the event-driven engine");

  double flow = 0, disks = 0;
  for (int k = 1; k <= cells; ++k) {
    const Gas gas = equations.gas(x, k);
    profile.y.push_back(scene.diameter() / 2 + (k - 0.5) * equations.cell());
    profile.mean_velocity.push_back(Equations::velocity(x, k));
    profile.granular_temperature.push_back(gas.granular_temperature);
    profile.area_fraction.push_back(gas.area_fraction);
    flow += gas.number_density() * Equations::velocity(x, k), disks += gas.number_density();
  }
  std::vector<Gas> gases;
  for (int k = 0; k < equations.nodes(); ++k) gases.push_back(equations.gas(x, k));
  profile.pressure = Equations::pressure(x);
  profile.slip_lower = Equations::velocity(x, 0);
  profile.slip_upper = Equations::velocity(x, cells + 1);
  profile.shear_lower = -equations.flux(x, 1, gases).momentum;
  profile.shear_upper = equations.flux(x, cells + 1, gases).momentum;
  profile.mean_flow = flow / disks;
  const double g = given.gravity, root = std::sqrt(g);
  for (double& u : profile.mean_velocity) u *= root;
  for (double& t : profile.granular_temperature) t *= g;
  for (double* stress : {&profile.pressure, &profile.shear_lower, &profile.shear_upper}) *stress *= g;
  for (double* u : {&profile.slip_lower, &profile.slip_upper, &profile.mean_flow}) *u *= root;
  return profile;
}

}  // namespace gpf
