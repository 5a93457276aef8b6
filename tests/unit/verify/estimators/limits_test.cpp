// The estimators of limits.*: short versions of what the claims ask for, and that each can fail.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "unit/verify/estimators/made_record.hpp"
#include "verify/estimators/estimators.hpp"

namespace gpf::test {

BOOST_AUTO_TEST_SUITE(limits)

Claim collapse_claim(double always_to) {
  return made_claim(0.0013, {{"disks", 60},
                             {"width_over_diameter", 9},
                             {"horizon", 8},
                             {"seeds_quick", 2},
                             {"always_to", always_to},
                             {"never_from", 0.9},
                             {"tc_per_mean_free_time", 1e-4},
                             {"horizon_with_tc", 1},
                             {"share_at_once", 1e-4}});
}

BOOST_AUTO_TEST_CASE(strong_dissipation_collapses_and_mild_does_not) {
  const Evidence evidence = estimate_limits_collapse(collapse_claim(0.1), Tier::quick, {});
  BOOST_TEST(evidence.checks.size() == 1u + 6 * 2 + 1 + 2 * 3 * 2);
  for (const Check& check : evidence.checks) {
    BOOST_TEST_CONTEXT(check.label)
    if (check.exact)
      for (const double value : check.values) BOOST_TEST(check.band.contains(value));
  }
  BOOST_TEST(!evidence.plot.series.empty());
}

BOOST_AUTO_TEST_CASE(that_mild_dissipation_collapses_would_be_false) {
  const Evidence evidence = estimate_limits_collapse(collapse_claim(0.8), Tier::quick, {});
  BOOST_TEST(check_with(evidence, "nu 0.05, e_n 0.8: runs").values[0] < 2);
  BOOST_TEST(!all_inside(evidence));
}

BOOST_AUTO_TEST_CASE(a_long_t_c_makes_another_flow) {
  const Claim claim = made_claim(0.05, {{"seeds_quick", 2},
                                        {"start_up", 10},
                                        {"duration", 10},
                                        {"reference", 1e-8},
                                        {"lower_end", 1e-10},
                                        {"upper_end_omega_tc", 0.01},
                                        {"onset_omega_tc", 0.1},
                                        {"end_of_a_double", 1e-15}});
  const Evidence evidence = estimate_limits_tc(claim, Tier::quick, {});
  for (const double change : check_with(evidence, "change of the loss in pairs").values)
    BOOST_TEST(change < -0.99);
  for (const double change : check_with(evidence, "t_c 1e-10: change of U_0").values)
    BOOST_TEST(std::abs(change) < 0.2);
}

Claim roundoff_claim(double overlap_quanta) {
  return made_claim(0.13, {{"seeds_quick", 2},
                           {"longest_quick", 10},
                           {"overlap_quanta", overlap_quanta},
                           {"overlap_bits", 0.1},
                           {"late_epoch_log2", 40},
                           {"wear_contacts", 500},
                           {"single_contacts", 20}});
}

BOOST_AUTO_TEST_CASE(round_off_stays_small_in_double_and_does_not_in_float) {
  const Evidence evidence = estimate_limits_roundoff(roundoff_claim(7), Tier::quick, {});
  for (const Check& check : evidence.checks) {
    BOOST_TEST_CONTEXT(check.label)
    if (check.exact)
      for (const double value : check.values) BOOST_TEST(check.band.contains(value));
  }
  for (const double rate : check_with(evidence, "nu 0.30, elastic: growth of a difference").values)
    BOOST_TEST(rate > 0.5);
  const Evidence strict = estimate_limits_roundoff(roundoff_claim(0.1), Tier::quick, {});
  BOOST_TEST(!outside(strict).empty());
}

BOOST_AUTO_TEST_CASE(extreme_runs_reach_their_end_and_balance) {
  const Evidence evidence = estimate_limits_engine(made_claim(1e-12), Tier::quick, {});
  BOOST_TEST(all_inside(evidence));
  BOOST_TEST(evidence.extra_cpu_seconds > 0);
  BOOST_TEST(!all_inside(estimate_limits_engine(made_claim(0), Tier::quick, {})));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace gpf::test
