// vdf.plug.tails and vdf.dense.tails: the tails of P(u_x) and P(u_y) at the centre of dense flows.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "gpf/base/error.hpp"
#include "verify/estimators/centre_tail.hpp"
#include "verify/estimators/estimators.hpp"

namespace gpf {
namespace {

const CentreTail& find(const std::vector<CentreTail>& all, double nu, double wall, double restitution) {
  const auto same = [](double a, double b) { return std::abs(a - b) < 0.005; };
  const auto found = std::find_if(all.begin(), all.end(), [&](const CentreTail& t) {
    return same(t.nu, nu) && same(t.wall, wall) && same(t.restitution, restitution);
  });
  if (found != all.end()) return *found;
  throw InputError(fmt::format("no scene with nu {}, beta_w {}, e_n {}", nu, wall, restitution),
                   "the claim compares it with others", "add it to the claim's scenes");
}

}  // namespace

// Exponents alpha of P(u) ~ |u|^-alpha at the centre, by maximum likelihood over the counts of a window in u/sigma; and
// the share of disks beyond 3 sigma over that of a Gaussian. Thesis figs. 3.16 and 3.20.
Evidence estimate_plug_tails(const Claim& claim, Tier, const SceneRecords& records) {
  const double gaussian_within = claim.parameter("over_population"), tolerance = claim.tolerance_total(),
               constant_from = claim.parameter("constant_from_restitution");
  Evidence evidence;
  evidence.plot = tail_plot("Tails of the velocity distributions in the plug");
  for (const Velocity velocity : {Velocity::ux, Velocity::uy, Velocity::cx}) {
    const std::vector<CentreTail> tails = centre_tails(records, velocity);
    note_tails(evidence, tails);
    if (velocity == Velocity::cx) break;  // shown, not judged: see tail_definitions
    check_reach(evidence, tails);
    const char* name = name_of(velocity);
    const double expected = claim.parameter(velocity == Velocity::ux ? "alpha_x" : "alpha_y");
    const CentreTail *elastic = &tails.front(), *last = &tails.back(), *before = nullptr;
    evidence.checks.push_back(
        {.label = fmt::format("{}, {}: counts beyond 3 sigma, over those of a Gaussian", name, elastic->label()),
         .values = elastic->over_population(),
         .band = {1 / gaussian_within, gaussian_within},
         .x = elastic->restitution,
         .reference = 1});
    for (const CentreTail& tail : tails) {
      if (velocity == Velocity::ux || &tail == last) add_tail(evidence.plot, tail);
      const bool constant = tail.restitution < constant_from + 0.001;
      if (constant)
        evidence.checks.push_back({.label = fmt::format("{}, {}: over-populated beyond 3 sigma", name, tail.label()),
                                   .values = tail.over_population(),
                                   .band = {gaussian_within, INFINITY},
                                   .x = tail.restitution,
                                   .reference = NAN});
      for (std::size_t s = 0; constant && s < std::size(tail_sides); ++s)
        for (const TailFit& fit : tail.fits[s])
          evidence.checks.push_back({.label = fmt::format("{}, {}: exponent of {}, {}", name, tail.label(),
                                                          tail_sides[s].label, window_label(fit.window)),
                                     .values = fit.exponent,
                                     .band = band_about(expected, tolerance),
                                     .x = tail.restitution,
                                     .reference = expected});
      for (std::size_t w = 0;
           constant && before != nullptr && before->restitution < constant_from + 0.001 && w < std::size(tail_windows);
           ++w)
        evidence.checks.push_back(
            {.label = fmt::format("{}: change of the exponent from e_n {:.2f} to {:.2f}, {}", name, before->restitution,
                                  tail.restitution, window_label(tail_windows[w])),
             .values = difference(tail.fits[0][w].exponent, before->fits[0][w].exponent),
             .band = band_about(0, tolerance),
             .x = tail.restitution,
             .reference = 0});
      before = &tail;
    }
    add_power_law(evidence.plot, expected, velocity == Velocity::ux ? 0.008 : 0.016);
  }
  evidence.notes.emplace_back(tail_definitions);
  return evidence;
}

// Order of the exponents at the centre at the highest density with e_n, against those at nu .56, and of rough walls
// against smooth ones. Thesis figs. 3.22-3.25; both tails together, in each window.
Evidence estimate_dense_tails(const Claim& claim, Tier, const SceneRecords& records) {
  const double tolerance = claim.tolerance_total(), dense = 0.85, less_dense = 0.56, smooth = 0.9, rough = 0.1;
  const Interval positive{0, INFINITY};
  std::size_t out_of_reach = 0;
  Evidence evidence;
  evidence.plot = tail_plot("Tails at the centre of very dense flows");
  for (const Velocity velocity : {Velocity::ux, Velocity::uy, Velocity::cx}) {
    const std::vector<CentreTail> tails = centre_tails(records, velocity);
    note_tails(evidence, tails);
    for (const CentreTail& tail : tails)
      if (velocity == Velocity::ux && tail.wall > 0.5) add_tail(evidence.plot, tail);
    if (velocity == Velocity::cx) break;  // shown, not judged: see tail_definitions
    for (std::size_t w = 0; w < std::size(tail_windows); ++w) {
      const std::string where = fmt::format("{}, {}", name_of(velocity), window_label(tail_windows[w]));
      bool reached = true;  // whether all histograms that the next check reads hold the window
      const auto alpha = [&](double nu, double wall, double restitution) -> const std::vector<double>& {
        const CentreTail& tail = find(tails, nu, wall, restitution);
        reached &= tail.reach() >= tail_windows[w].to;
        return tail.fits[0][w].exponent;
      };
      const auto fall = [&](double nu, double from, double to) {
        return difference(alpha(nu, smooth, from), alpha(nu, smooth, to));
      };
      const auto judge = [&](Check check) {
        if (reached)
          evidence.checks.push_back(std::move(check));
        else
          ++out_of_reach;
        reached = true;
      };
      for (const auto& [from, to] : {std::pair(0.99, 0.90), std::pair(0.90, 0.80)})
        judge({.label = fmt::format("{}: fall of the exponent from e_n {:.2f} to {:.2f} at nu .85", where, from, to),
               .values = fall(dense, from, to),
               .band = positive,
               .x = to,
               .reference = NAN});
      for (const double to : {0.90, 0.80})
        judge({.label = fmt::format("{}: fall from e_n .99 to {:.2f} at nu .56, less that at nu .85", where, to),
               .values = difference(fall(less_dense, 0.99, to), fall(dense, 0.99, to)),
               .band = positive,
               .x = to,
               .reference = NAN});
      for (const double restitution : {0.99, 0.90, 0.80})
        judge({.label = fmt::format("{}: exponent at e_n {:.2f}, rough less smooth walls", where, restitution),
               .values = difference(alpha(dense, rough, restitution), alpha(dense, smooth, restitution)),
               .band = band_about(0, tolerance),
               .x = restitution,
               .reference = 0});
    }
  }
  evidence.health.push_back({"some histograms hold the windows", !evidence.checks.empty(),
                             fmt::format("{} checks judged, {} left out because a histogram ends within the window",
                                         evidence.checks.size(), out_of_reach)});
  evidence.notes.emplace_back(tail_definitions);
  evidence.notes.emplace_back(
      "That the exponent is constant below e_n .8 is not tested: nothing is run there at nu .85.");
  return evidence;
}

}  // namespace gpf
