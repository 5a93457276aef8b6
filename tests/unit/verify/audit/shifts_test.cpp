#include "verify/audit/shifts.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "gpf/base/error.hpp"
#include "unit/stats/synthetic.hpp"

using namespace gpf;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A version's estimates: `count` numbers of unit scatter, correlated through what replicas share.
std::vector<ClaimEstimate> version(std::uint64_t key, int count, std::size_t replicas, Interval band = {-4, 4}) {
  const auto noise = synthetic::white(key, (static_cast<std::size_t>(count) + 1) * replicas);
  std::vector<ClaimEstimate> estimates;
  for (int k = 0; k < count; ++k) {
    ClaimEstimate e{
        .claim = fmt::format("claim.{}", k / 3), .label = fmt::format("bin {}", k % 3), .values = {}, .band = band};
    for (std::size_t r = 0; r < replicas; ++r)
      e.values.push_back(std::sqrt(0.4) * noise[r] +
                         std::sqrt(0.6) * noise[(static_cast<std::size_t>(k) + 1) * replicas + r]);
    estimates.push_back(std::move(e));
  }
  return estimates;
}

void shift(ClaimEstimate& e, double by) {
  for (double& x : e.values) x += by;
}

ClaimEstimate exact(std::vector<double> values) {
  return {.claim = "balance", .label = "energy", .values = std::move(values), .band = {-1e-9, 1e-9}, .exact = true};
}

Moved of_exact(const ClaimEstimate& before, const ClaimEstimate& after) {
  return compare({{before}}, {{after}}).identities.at(0).moved;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(shifts)

BOOST_AUTO_TEST_CASE(the_same_bits_have_not_moved) {
  const auto before = version(1, 12, 8);
  const Shifts found = compare(before, before);
  BOOST_TEST(found.all.size() == 12U);
  for (const Shift& s : found.all) BOOST_TEST((s.moved == Moved::no));
  BOOST_TEST(found.global_p == 1);
  BOOST_TEST(!found.any_named());
}

BOOST_AUTO_TEST_CASE(other_seeds_are_not_called_a_change) {
  const Shifts found = compare(version(1, 60, 16), version(2, 60, 16), {.permutations = 1999});
  BOOST_TEST(!found.any_named());
  BOOST_TEST(found.global_p > 0.01);
  // 90 % interval of the difference: +- .6 at R = 16, the margin a quarter of the band's width, 2.
  BOOST_TEST(
      std::all_of(found.all.begin(), found.all.end(), [](const Shift& s) { return s.moved == Moved::equivalent; }));
  // verdicts.md: about 1.8 deviations for 70 numbers at R = 16.
  for (const Shift& s : found.all) BOOST_TEST(std::abs(s.detectable - 1.75) < 0.8);
}

BOOST_AUTO_TEST_CASE(known_shifts_are_named_and_no_others) {
  const auto before = version(1, 60, 16);
  auto after = version(2, 60, 16);
  shift(after[7], 3);
  shift(after[40], -2.5);
  const Shifts found = compare(before, after, {.permutations = 1999});
  for (std::size_t k = 0; k < found.all.size(); ++k)
    BOOST_TEST((found.all[k].moved == Moved::yes) == (k == 7 || k == 40));
  BOOST_TEST(found.all[7].difference > 2);
  BOOST_TEST(found.all[40].difference < -1.5);
  BOOST_TEST(found.global_p == 1.0 / 2000);
  BOOST_TEST(found.any_named());
  BOOST_TEST(found.all[7].interval.contains(found.all[7].difference));
}

// A shift as large as `detectable` is found in nine of ten families; that of the mean over numbers, as errors scatter.
BOOST_AUTO_TEST_CASE(the_detectable_shift_is_found_with_its_power) {
  int found = 0;
  constexpr int families = 300;
  double detectable = 0;
  for (const Shift& s : compare(version(1, 40, 16), version(2, 40, 16), {.permutations = 999}).all)
    detectable += s.detectable / 40;
  for (std::uint64_t f = 0; f < families; ++f) {
    auto after = version(100 + 2 * f, 40, 16);
    shift(after[5], detectable);
    found += compare(version(101 + 2 * f, 40, 16), after, {.permutations = 499}).all[5].moved == Moved::yes;
  }
  BOOST_TEST(found > 0.82 * families);
  BOOST_TEST(found < 0.97 * families);
}

BOOST_AUTO_TEST_CASE(without_a_width_or_with_noise_nothing_is_equivalent) {
  for (const Interval band : {Interval{0, infinity}, Interval{-0.5, 0.5}}) {
    const Shifts found = compare(version(1, 6, 16, band), version(2, 6, 16, band), {.permutations = 499});
    for (const Shift& s : found.all) BOOST_TEST((s.moved == Moved::unresolved));
  }
}

BOOST_AUTO_TEST_CASE(unequal_numbers_of_replicas) {
  auto before = version(1, 9, 16), few = version(3, 4, 4);
  auto after = version(2, 9, 8), few_after = version(4, 4, 4);
  for (auto* side : {&few, &few_after})
    for (ClaimEstimate& e : *side) e.claim = "few." + e.claim;
  shift(after[2], 4);
  before.insert(before.end(), few.begin(), few.end());
  after.insert(after.end(), few_after.begin(), few_after.end());
  const Shifts found = compare(before, after, {.permutations = 1999});
  for (std::size_t k = 0; k < found.all.size(); ++k) BOOST_TEST((found.all[k].moved == Moved::yes) == (k == 2));
  BOOST_TEST(std::isfinite(found.all.back().detectable));  // 4 against 4: 2/70
  const Shifts too_few = compare(version(1, 3, 3), version(2, 3, 3));
  for (const Shift& s : too_few.all) BOOST_TEST(std::isinf(s.detectable));  // 2/20
}

BOOST_AUTO_TEST_CASE(identities_are_compared_without_statistics) {
  BOOST_TEST((of_exact(exact({1e-12, 2e-12}), exact({1e-12, 2e-12})) == Moved::no));
  BOOST_TEST((of_exact(exact({1e-12, 2e-12}), exact({3e-12, 1e-12})) == Moved::equivalent));
  BOOST_TEST((of_exact(exact({1e-12, 2e-12}), exact({9e-10, 1e-12})) == Moved::unresolved));
  BOOST_TEST((of_exact(exact({1e-12, 2e-12}), exact({1e-3, 1e-12})) == Moved::yes));
  BOOST_TEST((of_exact(exact({1e-12, 2e-12}), exact({NAN, NAN})) == Moved::yes));
  BOOST_TEST((of_exact(exact({5, 5}), exact({5.1, 5})) == Moved::yes));  // out of the band before and after
  const Shifts broken = compare({{exact({0, 0})}}, {{exact({0, 1})}});
  BOOST_TEST(broken.any_named());
  BOOST_TEST(broken.identities[0].difference == 0.5);
}

BOOST_AUTO_TEST_CASE(one_value_a_side_is_compared_like_an_identity) {
  const auto one = [](double x) { return ClaimEstimate{.claim = "c", .label = "l", .values = {x}, .band = {0, 8}}; };
  BOOST_TEST((of_exact(one(3), one(4)) == Moved::equivalent));
  BOOST_TEST((of_exact(one(3), one(6)) == Moved::unresolved));
  BOOST_TEST((of_exact(one(3), one(9)) == Moved::unresolved));
  BOOST_TEST((of_exact(one(3), one(12)) == Moved::yes));
  auto two = one(3);
  two.values.push_back(4);
  BOOST_CHECK_THROW(compare({{one(3)}}, {{two}}), InputError);
}

BOOST_AUTO_TEST_CASE(what_was_not_measured_stays_unresolved) {
  auto before = version(1, 2, 4), after = version(2, 2, 4);
  after[1].values[2] = NAN;
  const Shifts found = compare(before, after);
  BOOST_TEST((found.all[1].moved == Moved::unresolved));
  BOOST_TEST(std::isnan(found.all[1].difference));
  BOOST_TEST(std::isfinite(found.all[0].difference));
}

BOOST_AUTO_TEST_CASE(sides_of_other_lengths_are_refused) {
  BOOST_CHECK_THROW(compare(version(1, 3, 4), version(2, 2, 4)), InputError);
}

BOOST_AUTO_TEST_CASE(a_share_that_is_lost_is_named) {
  const auto share = [](double hits) {
    ClaimEstimate e{.claim = "wave", .label = "share", .values = {}, .band = {0.5, 1}, .share = true};
    for (int r = 0; r < 8; ++r) e.values.push_back(r < hits ? 1 : 0);
    return e;
  };
  BOOST_TEST((compare({{share(8)}}, {{share(1)}}).all[0].moved == Moved::yes));
  BOOST_TEST((compare({{share(8)}}, {{share(7)}}).all[0].moved == Moved::unresolved));
}

BOOST_AUTO_TEST_SUITE_END()
