// The judge on synthetic replicas whose truth is known: does it err as often as it says, and no more?
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "verify/judge.hpp"

using namespace gpf;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Rates {
  double pass = 0, fail = 0;
};

/// Repeats the whole procedure - look, and look again with more replicas until decided or `cap` is reached - on claims
/// of `checks` checks, each of independent normal replicas of mean `truth` and deviation 1.
Rates measure(double truth, Interval band, int cap, std::size_t checks = 1, int experiments = 20000) {
  std::mt19937_64 generator(20240229);
  std::normal_distribution<double> normal(truth, 1);
  const std::vector<int> looks = looks_up_to(cap);
  Rates rates;
  for (int e = 0; e < experiments; ++e) {
    Evidence evidence;
    evidence.checks.assign(checks, {"quantity", {}, band, false, 0, 0});
    Outcome outcome = Outcome::inconclusive;
    for (std::size_t look = 0; look < looks.size() && outcome == Outcome::inconclusive; ++look) {
      for (Check& c : evidence.checks)
        while (c.values.size() < static_cast<std::size_t>(looks[look])) c.values.push_back(normal(generator));
      outcome =
          judge({}, Tier::quick, evidence, looks[look], static_cast<int>(look) + 1, static_cast<int>(looks.size()))
              .outcome;
    }
    rates.pass += (outcome == Outcome::pass) / static_cast<double>(experiments);
    rates.fail += (outcome == Outcome::fail) / static_cast<double>(experiments);
  }
  return rates;
}

/// Four standard deviations of a rate measured in 20000 experiments; a test of it raises a false alarm with
/// probability 6e-5.
double scatter(double rate) { return 4 * std::sqrt(rate * (1 - rate) / 20000); }

}  // namespace

BOOST_AUTO_TEST_SUITE(judge_rates)

// With a single look and the other edge out of reach an interval ends exactly as often as alpha says on the wrong side.
BOOST_AUTO_TEST_CASE(at_the_edge_a_single_look_errs_with_probability_alpha_each_way) {
  const Rates rates = measure(1000, {-1000, 1000}, 4);
  BOOST_TEST(std::abs(rates.pass - 0.01) < scatter(0.01));
  BOOST_TEST(std::abs(rates.fail - 0.01) < scatter(0.01));
}

// Over four looks with alpha/4 each: no more than alpha together (Bonferroni), no less than alpha/4 (the first look).
BOOST_AUTO_TEST_CASE(looking_again_keeps_the_rates) {
  const Rates rates = measure(1000, {-1000, 1000}, 32);
  for (const double rate : {rates.pass, rates.fail}) {
    BOOST_TEST(rate < 0.01 + scatter(0.01));
    BOOST_TEST(rate > 0.0025 - scatter(0.0025));
  }
}

BOOST_AUTO_TEST_CASE(a_one_sided_band_has_the_same_rates_at_its_edge) {
  for (const Interval band : {Interval{0, infinity}, Interval{-infinity, 0}}) {
    const Rates rates = measure(0, band, 4);
    BOOST_TEST(std::abs(rates.pass - 0.01) < scatter(0.01));
    BOOST_TEST(std::abs(rates.fail - 0.01) < scatter(0.01));
  }
}

// "same": a difference in a margin of +-3 deviations. Two one-sided tests.
BOOST_AUTO_TEST_CASE(equivalence_is_shown_when_it_holds_and_rarely_when_it_does_not) {
  const Rates equal = measure(0, {-3, 3}, 8);
  BOOST_TEST(equal.pass > 0.95);  // last look: half width t_{0.995, 7} s/sqrt(8) = 1.24 s, against 3
  BOOST_TEST(equal.fail == 0);
  const Rates different = measure(3, {-3, 3}, 8);
  BOOST_TEST(different.pass < 0.01 + scatter(0.01));
  BOOST_TEST(different.fail < 0.01 + scatter(0.01));
}

// The replicas' scatter is half the tolerance, as the run lengths should be chosen: at the centre of the band the
// claim passes, and one as far outside as the tolerance is wide fails, nearly always.
BOOST_AUTO_TEST_CASE(well_chosen_runs_decide) {
  const Interval band{-2, 2};
  const Rates centre = measure(0, band, 16);
  BOOST_TEST(centre.pass > 0.99);
  BOOST_TEST(centre.fail == 0);
  const Rates outside = measure(4, band, 16);
  BOOST_TEST(outside.fail > 0.99);
  BOOST_TEST(outside.pass == 0);
}

// With too little data the answer is neither.
BOOST_AUTO_TEST_CASE(noise_larger_than_the_band_is_inconclusive) {
  const Rates rates = measure(0, {-0.1, 0.1}, 4);
  BOOST_TEST(rates.pass < 0.01);
  BOOST_TEST(rates.fail < 0.02 + scatter(0.02));
}

// Ten checks with the truth on their edges: Holm keeps the family's rate of failure at alpha, not ten times alpha; and
// a pass takes ten errors at once.
BOOST_AUTO_TEST_CASE(many_checks_do_not_add_up_to_failures) {
  const Rates rates = measure(1000, {-1000, 1000}, 4, 10, 20000);
  BOOST_TEST(rates.fail < 0.01 + scatter(0.01));
  BOOST_TEST(rates.fail > 0.005);  // 1 - (1 - 0.001)^10 = 0.01 for independent checks
  BOOST_TEST(rates.pass == 0);
}

/// As measure(), for one share whose true value is `truth`: labels are independent.
Rates measure_share(double truth, int cap, int experiments = 2000) {
  std::mt19937_64 generator(20240301);
  std::bernoulli_distribution labelled(truth);
  const std::vector<int> looks = looks_up_to(cap);
  Rates rates;
  for (int e = 0; e < experiments; ++e) {
    Evidence evidence;
    evidence.checks = {{.label = "share", .values = {}, .band = majority, .share = true}};
    std::vector<double>& values = evidence.checks[0].values;
    Outcome outcome = Outcome::inconclusive;
    for (std::size_t look = 0; look < looks.size() && outcome == Outcome::inconclusive; ++look) {
      while (values.size() < static_cast<std::size_t>(looks[look])) values.push_back(labelled(generator) ? 1 : 0);
      outcome =
          judge({}, Tier::quick, evidence, looks[look], static_cast<int>(look) + 1, static_cast<int>(looks.size()))
              .outcome;
    }
    rates.pass += (outcome == Outcome::pass) / static_cast<double>(experiments);
    rates.fail += (outcome == Outcome::fail) / static_cast<double>(experiments);
  }
  return rates;
}

// A label that half of all replicas have is not their class: passing is an error, at most one in twenty over all looks.
// Failing it is one too (the band includes its edge), at most one in a hundred. Binomials are discrete: the rates lie
// below.
BOOST_AUTO_TEST_CASE(a_class_that_is_a_matter_of_chance_is_rarely_called_one) {
  for (const int cap : {8, 16, 32}) {
    const Rates rates = measure_share(0.5, cap);
    constexpr double fewer = 3.1623;  // root of ten: a tenth of the experiments
    BOOST_TEST(rates.pass < 0.05 + fewer * scatter(0.05));
    BOOST_TEST(rates.fail < 0.01 + fewer * scatter(0.01));
  }
  BOOST_TEST(measure_share(0.3, 32).pass < 0.002);
}

BOOST_AUTO_TEST_CASE(a_class_is_found_where_there_is_one) {
  BOOST_TEST(measure_share(1, 8).pass > 0.9999);
  BOOST_TEST(measure_share(0.95, 32).pass > 0.99);
  BOOST_TEST(measure_share(0, 8).fail > 0.9999);
  BOOST_TEST(measure_share(0.05, 32).fail > 0.99);
  BOOST_TEST(measure_share(1, 4).pass == 0.0);  // 4 of 4: 95 % lower bound .47
}

BOOST_AUTO_TEST_SUITE_END()
