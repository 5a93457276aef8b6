// vdf.plug.rough, vdf.size, vdf.plug.size: whether two scenes have the same velocity distributions.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "gpf/base/error.hpp"
#include "verify/estimators/centre_tail.hpp"
#include "verify/estimators/estimators.hpp"
#include "verify/estimators/velocity_moments.hpp"

namespace gpf {
namespace {

constexpr double compared_up_to = 3, step = 0.5;  // sigma

/// What tells a scene from the others of its pair.
std::string label(const SceneValues& scene) {
  return fmt::format("N {}, W/d {:.0f}, beta_w {:.1f}", scene.scene().particles, scene.scene().width_over_diameter,
                     scene.scene().wall_tangential_restitution[0]);
}

/// ln of the ratio of two distributions in from < u/sigma < from + step, replica by replica.
std::vector<double> log_ratio(const std::vector<VelocityDistribution>& a, const std::vector<VelocityDistribution>& b,
                              double from) {
  return per_replica(std::min(a.size(), b.size()), [&](std::size_t r) {
    return std::log(a[r].between(from, from + step) / a[r].total) -
           std::log(b[r].between(from, from + step) / b[r].total);
  });
}

/// Mean over the replicas of a number of a distribution, with its error in brackets.
template <class F>
std::string text_of(const std::vector<VelocityDistribution>& replicas, F&& f) {
  const Estimate e = over_replicas(per_replica(replicas.size(), [&](std::size_t r) { return f(replicas[r]); }));
  return fmt::format("{:.3f} ({:.3f})", e.mean, e.error);
}

void compare(Evidence& evidence, const Claim& claim, const SceneValues& a, const SceneValues& b, int bin) {
  const double margin = claim.parameter("log_ratio"), tail_margin = claim.parameter("exponent");
  const bool centre = bin == a.half() - 1;
  for (const Velocity velocity : {Velocity::ux, Velocity::uy, Velocity::cx}) {
    const std::vector<VelocityDistribution> da = velocity_distributions(a, velocity, bin),
                                            db = velocity_distributions(b, velocity, bin);
    const std::string where =
        fmt::format("e_n {:.2f}, bin {}, {}", a.scene().normal_restitution, bin + 1, name_of(velocity));
    for (const auto& [scene, d] : {std::pair(&a, &da), std::pair(&b, &db)})
      evidence.notes.push_back(fmt::format(
          "{}, {}: sigma {}, skewness {}, kurtosis {}, {} of the disks beyond 3 sigma, distance from a Gaussian {}.",
          where, label(*scene), text_of(*d, [](const VelocityDistribution& v) { return v.sigma; }),
          text_of(*d, [](const VelocityDistribution& v) { return v.skewness; }),
          text_of(*d, [](const VelocityDistribution& v) { return v.kurtosis; }),
          text_of(*d, [](const VelocityDistribution& v) { return v.beyond(3); }), text_of(*d, distance_from_gaussian)));
    if (velocity == Velocity::cx) continue;  // shown, not judged: the motion of a whole plug is no velocity of disks
    for (double u = -compared_up_to; u < compared_up_to - 0.01; u += step)
      evidence.checks.push_back({.label = fmt::format("{}, {:g} to {:g} sigma: ln of the ratio", where, u, u + step),
                                 .values = log_ratio(da, db, u),
                                 .band = band_about(0, margin),
                                 .x = u + 0.5 * step,
                                 .reference = 0});
    if (tail_margin > 0 && centre) {
      const std::vector<TailFit> ta = fit_tails(da, TailSide::both), tb = fit_tails(db, TailSide::both);
      for (std::size_t w = 0; w < ta.size(); ++w)
        evidence.checks.push_back(
            {.label = fmt::format("{}: difference of the exponents, {}", where, window_label(ta[w].window)),
             .values = difference(ta[w].exponent, tb[w].exponent),
             .band = band_about(0, tail_margin),
             .x = ta[w].window.to,
             .reference = 0});
    }
    if (velocity != Velocity::ux) continue;
    for (const auto& [scene, d] : {std::pair(&a, &da), std::pair(&b, &db)})
      evidence.plot.series.push_back(
          density_series(fmt::format("e_n {:.2f}, bin {}, N {}, β_w {:.1f}", scene->scene().normal_restitution, bin + 1,
                                     scene->scene().particles, scene->scene().wall_tangential_restitution[0]),
                         *d));
  }
}

}  // namespace

// Two scenes at each e_n: ln of the ratio of their P(u/sigma), each normalised to 1, in steps of half a sigma up to
// 3 sigma, for u_x and u_y in the bins first_bin and second_bin (from 1) and their mirror images; where the parameter
// `exponent` is above 0, also the tail exponents at the centre. Thesis figs. 3.8, 3.9, 3.16-3.20.
Evidence estimate_same_distributions(const Claim& claim, Tier, const SceneRecords& records) {
  std::map<double, std::vector<SceneValues>> pairs;
  for (const auto& [name, replicas] : records)
    pairs[replicas.at(0).scene.normal_restitution].emplace_back(name, replicas);
  Evidence evidence;
  evidence.plot = density_plot("P(u_x) of two scenes", 1e-6);
  for (const auto& [restitution, scenes] : pairs) {
    if (scenes.size() != 2)
      throw InputError(fmt::format("{} scenes at e_n {}", scenes.size(), restitution), "two are compared",
                       "correct the claim's scenes");
    for (const char* name : {"first_bin", "second_bin"}) {
      const int bin = bin_parameter(claim, name, scenes[0]);
      static_cast<void>(bin_parameter(claim, name, scenes[1]));
      compare(evidence, claim, scenes[0], scenes[1], bin);
    }
  }
  evidence.notes.emplace_back(tail_definitions);
  return evidence;
}

}  // namespace gpf
