#include "verify/trial/synthetic_claims.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <utility>

#include "gpf/stats/exponents.hpp"
#include "verify/judge.hpp"

namespace gpf {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double alpha = alpha_per_direction;
constexpr Interval two_sided{-1, 1}, above_zero{0, infinity};

/// Where the truths of a claim lie.
enum class Where { inside, edge, outside };

std::string_view name_of(Where where) {
  return where == Where::inside ? "inside" : where == Where::edge ? "on the edge" : "outside";
}

/// judge.hpp: on an edge or outside it passes with probability alpha at most; inside (edges included) it fails with
/// probability alpha at most for each edge.
SyntheticClaim stated(std::string kind, std::string truth, Where where, int edges, double pass_alpha = alpha) {
  SyntheticClaim claim{.kind = std::move(kind), .truth = std::move(truth), .replica = {}, .checks = {}};
  if (where != Where::inside) claim.most_pass = pass_alpha;
  if (where != Where::outside) claim.most_fail = edges * alpha;
  return claim;
}

/// Check k: value k of each replica, in band k.
auto bands(std::vector<Interval> in, bool share = false) {
  return [=](const std::vector<ReplicaValues>& replicas) {
    std::vector<Check> checks;
    for (std::size_t k = 0; k < in.size(); ++k) {
      Check check{.label = fmt::format("check {}", k + 1), .values = {}, .band = in[k], .share = share};
      for (const ReplicaValues& r : replicas) check.values.push_back(r[k]);
      checks.push_back(std::move(check));
    }
    return checks;
  };
}

/// Independent normal values about these truths.
auto normal_about(std::vector<double> truths, double deviation = synthetic_deviation) {
  return [=](Draws& draws) {
    ReplicaValues values;
    for (const double truth : truths) values.push_back(truth + deviation * draws.normal());
    return values;
  };
}

/// Bins of a profile, neighbours correlated with exp(-1/3) as those of a flow are.
auto profile_about(std::vector<double> truths) {
  return [=](Draws& draws) {
    const double keep = std::exp(-1.0 / 3);
    double noise = draws.normal();
    ReplicaValues values;
    for (const double truth : truths) {
      values.push_back(truth + synthetic_deviation * noise);
      noise = keep * noise + std::sqrt(1 - keep * keep) * draws.normal();
    }
    return values;
  };
}

constexpr double truth_at(Where where) { return where == Where::inside ? 0 : where == Where::edge ? 1 : 2; }
constexpr double above_at(Where where) { return where == Where::inside ? 1 : where == Where::edge ? 0 : -1; }
constexpr Where everywhere[] = {Where::inside, Where::edge, Where::outside};

void add_values(std::vector<SyntheticClaim>& claims) {
  for (const Where where : everywhere) {
    claims.push_back(value_claim(truth_at(where), false));
    claims.push_back(value_claim(above_at(where), true));
  }
  SyntheticClaim noisy = stated("value, deviation 1, up to 32 replicas", "on the edge", Where::edge, 2);
  noisy.replica = normal_about({1}, 1);
  noisy.checks = bands({two_sided});
  noisy.most_replicas = 32;
  claims.push_back(noisy);
  // What is stated holds for normal replicas. This shows what becomes of it when they are not: exponential ones.
  for (const double side : {-1.0, 1.0}) {
    SyntheticClaim skewed{.kind = "value, replicas not normal (exponential)",
                          .truth = side > 0 ? "on the upper edge" : "on the lower edge",
                          .replica = [=](Draws& d) -> ReplicaValues {
                            return {side + synthetic_deviation * (-std::log(d.uniform()) - 1)};
                          },
                          .checks = bands({two_sided})};
    claims.push_back(skewed);
  }
}

void add_orders_and_profiles(std::vector<SyntheticClaim>& claims) {
  for (const Where where : everywhere) {
    SyntheticClaim order =
        stated("order (3 inequalities)", fmt::format("{} {}", where == Where::inside ? "all" : "one", name_of(where)),
               where, 1);
    order.replica = normal_about({1, above_at(where), 1});
    order.checks = bands(std::vector<Interval>(3, above_zero));
    claims.push_back(order);

    SyntheticClaim same = stated("same (difference within a margin)", std::string(name_of(where)), where, 2);
    same.replica = [where](Draws& d) -> ReplicaValues {  // of two versions, each with its noise
      const double each = synthetic_deviation / std::sqrt(2.0);
      const double before = 5 + each * d.normal();
      return {5 + truth_at(where) + each * d.normal() - before};
    };
    same.checks = bands({two_sided});
    claims.push_back(same);

    SyntheticClaim profile =
        stated("profile (18 bins)",
               fmt::format("{} {}", where == Where::inside ? "all bins" : "one bin", name_of(where)), where, 2);
    std::vector<double> truths(18, 0.0);
    truths[7] = truth_at(where);
    profile.replica = profile_about(truths);
    profile.checks = bands(std::vector<Interval>(18, two_sided));
    profile.large = true;
    claims.push_back(profile);
  }
  SyntheticClaim edges = stated("profile (18 bins)", "all on an edge", Where::edge, 2);
  edges.replica = profile_about(std::vector<double>(18, 1.0));
  edges.checks = bands(std::vector<Interval>(18, two_sided));
  edges.large = true;
  claims.push_back(edges);
}

/// A curve x^exponent, bent by the factor exp(bend (ln x)^2), at eight points over a decade, fitted in each replica;
/// checks as of the claims of power laws: exponent within .1 and half the spread of the windows, bend that of a
/// departure of 10 %.
SyntheticClaim exponent_claim(SyntheticClaim claim, double exponent, double bend) {
  claim.replica = [=](Draws& draws) {
    ReplicaValues y;
    for (int k = 0; k < 8; ++k) {
      const double ln_x = k * std::log(10.0) / 7 - std::log(10.0) / 2;
      // Deviation of the fitted exponent: .05/(sqrt(8) .754) = .023, a quarter of the tolerance; that of the bend is
      // sqrt(2) .05 sqrt(2)/.329 = .30, nearly half of it.
      y.push_back(std::exp(exponent * ln_x + bend * ln_x * ln_x + 0.05 * draws.normal()));
    }
    return y;
  };
  claim.checks = [](const std::vector<ReplicaValues>& replicas) {
    std::vector<std::vector<double>> x(8), y(8);
    for (std::size_t k = 0; k < 8; ++k)
      for (const ReplicaValues& r : replicas) {
        x[k].push_back(std::pow(10.0, static_cast<double>(k) / 7));
        y[k].push_back(r[k]);
      }
    const Exponents fit = fit_exponents(x, y);
    const double margin = 0.1 + fit.half_spread(), most = bend_of_departure(0.1, fit.lowest_x(), fit.highest_x());
    return std::vector<Check>{{.label = "exponent", .values = fit.exponent, .band = {-1 - margin, -1 + margin}},
                              {.label = "bend", .values = fit.bend(), .band = {-most, most}}};
  };
  claim.large = true;
  return claim;
}

void add_exponents(std::vector<SyntheticClaim>& claims) {
  claims.push_back(exponent_claim(stated("exponent", "inside", Where::inside, 2), -1, 0));
  // The band is wider than the tolerance, by what the windows differ: an exponent on the edge of the tolerance lies
  // inside it, so that nothing is stated of its passing.
  SyntheticClaim edge = stated("exponent", "on the edge of the tolerance, inside the band", Where::inside, 2);
  claims.push_back(exponent_claim(std::move(edge), -0.9, 0));
  claims.push_back(exponent_claim(stated("exponent", "outside", Where::outside, 2), -0.8, 0));
  // Slopes at the ends differ by 2 bend (2/3) ln 10; the band ends at .70.
  claims.push_back(exponent_claim(stated("exponent", "no power law: bent twice as much as allowed", Where::outside, 2),
                                  -1, 1.4 / (2 * 2.0 / 3 * std::log(10.0))));
}

/// The claims' way: both ends of the bracket have their sign.
void add_crossings(std::vector<SyntheticClaim>& claims) {
  for (const Where where : everywhere) {
    SyntheticClaim claim =
        stated("zero crossing (signs at both ends of a bracket)", std::string(name_of(where)), where, 1);
    claim.replica = normal_about({1, -above_at(where)});
    claim.checks = bands({above_zero, {-infinity, 0}});
    claims.push_back(claim);
  }
}

void add_shares(std::vector<SyntheticClaim>& claims) {
  for (const int cap : {8, 32})
    for (const auto& [where, truth] : {std::pair{Where::inside, 0.95}, {Where::edge, 0.5}, {Where::outside, 0.3}}) {
      SyntheticClaim claim =
          stated(fmt::format("class (share of up to {} replicas)", cap),
                 fmt::format("share {:g}, {}", truth, name_of(where)), where, 1, share_alpha_per_direction);
      claim.replica = [share = truth](Draws& d) -> ReplicaValues { return {d.uniform() < share ? 1.0 : 0.0}; };
      claim.checks = bands({majority}, true);
      claim.most_replicas = cap;
      claims.push_back(claim);
    }
}

}  // namespace

double Draws::uniform() {
  const auto words = random_words(key_, 0x756e69666f726du, index_++);
  return (words[0] + 0.5) * 0x1p-32;
}

SyntheticClaim value_claim(double truth, bool one_sided) {
  const double depth = one_sided ? truth : 1 - std::abs(truth);
  const Where where = depth > 0 ? Where::inside : depth == 0 ? Where::edge : Where::outside;
  SyntheticClaim claim =
      stated(one_sided ? "sign (one-sided)" : "value", std::string(name_of(where)), where, one_sided ? 1 : 2);
  claim.replica = normal_about({truth});
  claim.checks = bands({one_sided ? above_zero : two_sided});
  return claim;
}

std::vector<SyntheticClaim> synthetic_claims() {
  std::vector<SyntheticClaim> claims;
  add_values(claims);
  add_orders_and_profiles(claims);
  add_exponents(claims);
  add_crossings(claims);
  add_shares(claims);
  return claims;
}

}  // namespace gpf
