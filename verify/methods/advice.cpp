#include "verify/methods/advice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "gpf/base/error.hpp"

namespace gpf {
namespace {

constexpr double no_cost = std::numeric_limits<double>::infinity();

bool within_factor(double a, double b, double factor) { return a <= factor * b && b <= factor * a; }

/// "monte_carlo cells=36" of "monte_carlo cells=36 length x0.25"; empty for series in which more is varied.
std::string method_of(const std::string& series) {
  for (const char* varied : {" t_c x", " N x", " window "})
    if (series.find(varied) != std::string::npos) return "";
  return series.substr(0, series.find(" length x"));
}

double measured_time(const ChartPoint& p) { return p.run_length * (1 - p.start_share); }

/// How strongly a wall lets the flow slip: see gpf/methods/channel_flow.hpp.
double slip_strength(double beta) { return (1 + beta) / (1 - beta); }

/// Whether the like scenes lie on both sides of `value`, or at it, in what `of` makes of a scene.
template <class F>
bool bracketed(const std::vector<const ChartPoint*>& like, double value, F&& of) {
  bool below = false, above = false;
  for (const ChartPoint* p : like) {
    below = below || of(p->parameters) <= 1.02 * value;
    above = above || of(p->parameters) >= 0.98 * value;
  }
  return below && above;
}

/// Two scenes at least, none of nu, 1 - e_n, W/d and the walls' slip beyond all of them, and the channel not much
/// longer than the longest, since the longer it is, the more structures there are along it.
bool enough(const std::vector<const ChartPoint*>& like, const Scene& scene) {
  std::set<std::string> names;
  for (const ChartPoint* p : like) names.insert(p->scene);
  const auto inside = [&](auto&& of) { return bracketed(like, of(scene), of); };
  const bool long_enough = std::any_of(like.begin(), like.end(), [&](const ChartPoint* p) {
    return scene.length_over_width <= 1.5 * p->parameters.length_over_width;
  });
  return names.size() >= 2 && long_enough && inside([](const Scene& s) { return s.area_fraction(); }) &&
         inside([](const Scene& s) { return 1.01 - s.normal_restitution; }) &&
         inside([](const Scene& s) { return s.width_over_diameter; }) &&
         inside([](const Scene& s) { return slip_strength(s.wall_tangential_restitution[lower]); }) &&
         inside([](const Scene& s) { return slip_strength(s.wall_tangential_restitution[upper]); });
}

/// What the like points of one method say of it.
Candidate candidate_of(const std::string& method, const std::vector<const ChartPoint*>& like, const Scene& scene,
                       const Run& run, const Observable& observable, double tolerance) {
  Candidate c;
  c.method = method;
  const bool engine = method == "event_driven";
  double noise = 0, cost_of_time = 0;  // noise of a run that measures for 1; CPU seconds of a run per time
  bool chance = false;
  for (const ChartPoint* p : like) {
    const auto m = p->misfits.find(observable.name);
    const bool known = m != p->misfits.end() && std::isfinite(m->second.bias);
    if (!known && engine) continue;
    if (!p->failure.empty()) {
      c.why_not = fmt::format("it gave up on {}: {}", p->scene, p->failure);
      return c;
    }
    if (!known) {
      c.why_not = fmt::format("it does not give the {}", observable.title);
      return c;
    }
    const Misfit& misfit = m->second;
    if (!engine) c.bias_at_most = std::max(c.bias_at_most, misfit.bias_at_most());
    chance = chance || misfit.noise > 0;
    // The engine simulates the scene's own disks; other methods as many as they are told. Times go with g^(-1/2).
    const double disks = engine ? static_cast<double>(scene.particles) / p->parameters.particles : 1;
    const double tempo = std::sqrt(scene.gravity / p->parameters.gravity);
    noise = std::max(noise, misfit.noise * std::sqrt(measured_time(*p) / (disks * tempo)));
    cost_of_time = std::max(cost_of_time, p->cpu_seconds / p->run_length * disks * tempo);
    c.cpu_seconds = std::max(c.cpu_seconds, p->cpu_seconds);
    c.evidence.push_back(fmt::format("{}: bias {:.2g} (resolved to {:.2g}), {:.2g} CPU s", p->scene, misfit.bias,
                                     misfit.resolution, p->cpu_seconds));
  }
  if (!engine && !enough(like, scene)) {
    c.why_not = like.empty() ? "no like scene was tried" : "the scene does not lie between like scenes that were tried";
    return c;
  }
  if (c.bias_at_most > tolerance) {
    c.why_not = fmt::format("its bias may be {:.2g}", c.bias_at_most);
    return c;
  }
  if (!chance) {
    c.duration = engine ? run.duration : 0;
    if (c.evidence.empty()) c.cpu_seconds = no_cost;
    return c;
  }
  // A tenth of the tolerance is left for noise at least, and no run is shorter than a twentieth of the start-up.
  const double room = std::max(0.1 * tolerance, tolerance - c.bias_at_most) / 2;
  c.duration = std::max((noise / room) * (noise / room), run.start_up / 20);
  c.noise = noise / std::sqrt(c.duration);
  c.cpu_seconds = cost_of_time * (run.start_up + c.duration);
  if (c.error_at_most() > tolerance * (1 + 1e-9)) c.why_not = "its bias leaves no room for noise";
  return c;
}

}  // namespace

bool alike(const Scene& known, const Scene& scene) {
  const auto &a = known.wall_tangential_restitution, &b = scene.wall_tangential_restitution;
  const auto same_slip = [&](std::size_t wall) {
    return within_factor(slip_strength(a[wall]), slip_strength(b[wall]), 3.5);
  };
  return within_factor(known.area_fraction(), scene.area_fraction(), 2) &&
         within_factor(1.01 - known.normal_restitution, 1.01 - scene.normal_restitution, 2) &&
         within_factor(known.width_over_diameter, scene.width_over_diameter, 1.7) && same_slip(lower) &&
         same_slip(upper) && (a[lower] == a[upper]) == (b[lower] == b[upper]) &&
         std::abs(known.wall_normal_restitution - scene.wall_normal_restitution) < 0.02;
}

Advice advise(const std::vector<ChartPoint>& points, const Scene& scene, const Run& run, const Observable& observable,
              double tolerance) {
  if (scene.geometry != Geometry::channel || !(scene.gravity > 0))
    throw InputError("the scene is no channel under gravity", "the methods were compared on such channels",
                     "use gpf run, the event-driven engine");
  if (!(tolerance >= 1e-4 && tolerance < 1))
    throw InputError(fmt::format("a tolerance of {}", tolerance),
                     "it is a part of the value, and below 1e-4 no run is long enough", "choose 0.05, or 5%");
  if (!(run.duration > 0))
    throw InputError("the run has no duration", "the time that it takes is what the advice is about",
                     "set duration in [run]");
  for (const double beta : scene.wall_tangential_restitution)
    if (std::abs(beta) >= 1)
      throw InputError(fmt::format("beta_w = {}", beta), "such a wall takes no momentum: the flow has no steady state",
                       "take a value between -1 and 1");
  std::vector<std::string> methods{"event_driven"};
  for (const ChartPoint& p : points) {
    const std::string method = method_of(p.series);
    if (!method.empty() && std::find(methods.begin(), methods.end(), method) == methods.end())
      methods.push_back(method);
  }
  Advice advice;
  for (const std::string& method : methods) {
    std::vector<const ChartPoint*> like;
    for (const ChartPoint& p : points)
      if (method_of(p.series) == method && alike(p.parameters, scene)) like.push_back(&p);
    advice.candidates.push_back(candidate_of(method, like, scene, run, observable, tolerance));
  }
  std::stable_sort(advice.candidates.begin(), advice.candidates.end(), [](const Candidate& a, const Candidate& b) {
    return a.usable() != b.usable() ? a.usable() : a.cpu_seconds < b.cpu_seconds;
  });
  return advice;
}

}  // namespace gpf
