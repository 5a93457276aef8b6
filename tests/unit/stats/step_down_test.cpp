#include "gpf/stats/step_down.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "gpf/base/error.hpp"
#include "gpf/stats/hypothesis.hpp"
#include "unit/stats/synthetic.hpp"

using namespace gpf;

namespace {

/// `count` numbers of R replicas a side, any two of them with correlation rho: a part that a replica's numbers share.
std::vector<TwoSides> correlated(std::uint64_t key, std::size_t count, std::size_t na, std::size_t nb, double rho) {
  const auto noise = synthetic::white(key, (count + 1) * (na + nb));
  std::vector<TwoSides> numbers(count);
  for (std::size_t k = 0; k < count; ++k)
    for (std::size_t r = 0; r < na + nb; ++r) {
      const double x = std::sqrt(rho) * noise[r] + std::sqrt(1 - rho) * noise[(k + 1) * (na + nb) + r];
      (r < na ? numbers[k].a : numbers[k].b).push_back(x);
    }
  return numbers;
}

double abs_t(const std::vector<double>& a, const std::vector<double>& b) {
  const WelchTest t = welch(summarise(a), summarise(b));
  return std::abs(t.difference) / t.error;
}

/// Adjusted p-values by the book: every split as a bit mask, t from welch(), maxima over the remaining numbers.
std::vector<double> by_brute_force(const std::vector<TwoSides>& numbers) {
  const std::size_t na = numbers[0].a.size(), n = na + numbers[0].b.size(), count = numbers.size();
  std::vector<double> observed;
  for (const TwoSides& s : numbers) observed.push_back(abs_t(s.a, s.b));
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](auto i, auto j) { return observed[i] > observed[j]; });
  std::vector<double> p(count);
  double splits = 0;
  for (unsigned mask = 0; mask < 1U << n; ++mask) {
    if (static_cast<std::size_t>(__builtin_popcount(mask)) != na) continue;
    ++splits;
    for (std::size_t k = 0; k < count; ++k) {
      double largest = 0;
      for (std::size_t j = k; j < count; ++j) {
        const TwoSides& s = numbers[order[j]];
        std::vector<double> a, b;
        for (std::size_t r = 0; r < n; ++r) (mask >> r & 1U ? a : b).push_back(r < na ? s.a[r] : s.b[r - na]);
        largest = std::max(largest, abs_t(a, b));
      }
      p[order[k]] += largest >= observed[order[k]] * (1 - 1e-9);
    }
  }
  double smallest = 0;
  for (const std::size_t k : order) p[k] = smallest = std::max(smallest, p[k] / splits);
  return p;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(step_down)

BOOST_AUTO_TEST_CASE(all_splits_give_what_brute_force_gives) {
  for (const auto& [na, nb] : {std::pair{4, 4}, {3, 5}, {5, 4}}) {
    auto numbers = correlated(7, 5, static_cast<std::size_t>(na), static_cast<std::size_t>(nb), 0.5);
    for (double& x : numbers[3].a) x = 1e6 + 1e-3 * (x + 4);  // a shift far down in the digits
    for (double& x : numbers[3].b) x = 1e6 + 1e-3 * x;
    const StepDown found = step_down_max_t(numbers, 9999, 1);
    const auto expected = by_brute_force(numbers);
    BOOST_TEST(found.exact);
    BOOST_TEST(found.largest.size() == combinations(static_cast<std::size_t>(na + nb), static_cast<std::size_t>(na)));
    for (std::size_t k = 0; k < expected.size(); ++k) BOOST_TEST(std::abs(found.p_adjusted[k] - expected[k]) < 1e-12);
    BOOST_TEST(found.global_p == *std::min_element(expected.begin(), expected.end()));
  }
}

BOOST_AUTO_TEST_CASE(random_relabellings_agree_with_all) {
  const auto numbers = correlated(11, 4, 6, 6, 0.3);  // 924 splits
  const StepDown all = step_down_max_t(numbers, 924, 1);
  BOOST_TEST(all.exact);
  auto more = correlated(12, 1, 16, 16, 0)[0];
  more.a = more.b;  // no difference: this group makes the relabellings random, and moves nothing
  std::vector<TwoSides> both = numbers;
  for (const TwoSides& n : numbers) {
    const double alone = step_down_max_t({{n, more}}, 20000, 5).p_single[0];
    const double exact = step_down_max_t({{n}}, 924, 1).p_single[0];
    BOOST_TEST(std::abs(alone - exact) < 4 * std::sqrt(exact * (1 - exact) / 20000) + 1e-4);
  }
}

BOOST_AUTO_TEST_CASE(a_single_number_has_the_p_value_of_welch) {
  auto numbers = correlated(3, 1, 16, 16, 0);
  for (double& x : numbers[0].a) x += 0.6;
  const StepDown found = step_down_max_t(numbers, 20000, 1);
  const double p = welch(summarise(numbers[0].a), summarise(numbers[0].b)).p_value;
  BOOST_TEST(!found.exact);
  BOOST_TEST(found.p_adjusted[0] == found.p_single[0]);
  BOOST_TEST(std::abs(found.global_p - p) < 0.2 * p + 0.002);
  // Wallace's normal variable has that p-value too.
  BOOST_TEST(std::abs(std::erfc(found.statistic[0] / std::sqrt(2.0)) - p) < 0.03 * p);
}

// Family of 60 correlated numbers, nothing differs: any named at .05 in 5 % of families, whatever the correlation.
BOOST_AUTO_TEST_CASE(families_raise_false_alarms_at_the_stated_rate) {
  constexpr int families = 600;
  for (const double rho : {0.0, 0.8}) {
    int named = 0;
    for (int f = 0; f < families; ++f)
      named +=
          step_down_max_t(correlated(1000 + static_cast<std::uint64_t>(f), 60, 8, 8, rho), 199, 3).global_p <= 0.05;
    const double rate = static_cast<double>(named) / families;
    BOOST_TEST(std::abs(rate - 0.05) < 4 * std::sqrt(0.05 * 0.95 / families));
  }
}

// 1 of 40 numbers differs by 3 deviations: it is named, and the rate at which another one is stays below alpha.
BOOST_AUTO_TEST_CASE(a_shift_is_found_and_hides_no_error) {
  int found = 0, wrong = 0;
  constexpr int families = 300;
  for (int f = 0; f < families; ++f) {
    auto numbers = correlated(5000 + static_cast<std::uint64_t>(f), 40, 8, 12, 0.3);
    for (double& x : numbers[17].b) x -= 3;
    const StepDown result = step_down_max_t(numbers, 499, 9);
    found += result.p_adjusted[17] <= 0.05;
    for (std::size_t k = 0; k < numbers.size(); ++k)
      if (k != 17 && result.p_adjusted[k] <= 0.05) {
        ++wrong;
        break;
      }
  }
  BOOST_TEST(found > 0.95 * families);
  BOOST_TEST(wrong < 0.05 * families + 4 * std::sqrt(0.05 * 0.95 * families));
}

BOOST_AUTO_TEST_CASE(ties_and_numbers_without_scatter) {
  const TwoSides constant{{2, 2, 2, 2}, {2, 2, 2, 2}};
  const TwoSides sure{{1, 1, 1, 1}, {2, 2, 2, 2}};
  const TwoSides tied{{0, 0, 1, 1}, {0, 1, 0, 1}};
  const TwoSides share{{1, 1, 1, 1}, {0, 0, 0, 0}, true};
  const StepDown alone = step_down_max_t({{constant}}, 100, 1);
  BOOST_TEST(alone.p_adjusted[0] == 1);
  BOOST_TEST(alone.statistic[0] == 0);
  const StepDown found = step_down_max_t({{constant, sure, tied, share}}, 100, 1);
  BOOST_TEST(std::isinf(found.statistic[1]));
  BOOST_TEST(found.p_single[1] == 2.0 / 70);    // the split itself and its mirror image
  BOOST_TEST(found.p_adjusted[1] == 4.0 / 70);  // and two of `tied`, which are sure as well
  BOOST_TEST(found.p_adjusted[2] == 1);
  BOOST_TEST(std::abs(found.statistic[3] - std::sqrt(7.0)) < 1e-12);  // sqrt((n - 1)), all hits on one side
  BOOST_TEST(found.p_single[3] == 2.0 / 70);
}

BOOST_AUTO_TEST_CASE(the_critical_value_is_where_a_number_gets_named) {
  auto numbers = correlated(21, 30, 16, 16, 0.2);
  const StepDown null = step_down_max_t(numbers, 999, 1);
  const double critical = null.critical(0.05);
  BOOST_TEST(critical > 2.5);  // a single number needs 1.96, 30 independent ones 3.14
  BOOST_TEST(critical < 3.5);
  BOOST_TEST(std::count_if(null.largest.begin(), null.largest.end(), [&](double z) { return z > critical; }) == 49);
  BOOST_TEST(std::isinf(null.critical(0.0009)));
}

BOOST_AUTO_TEST_CASE(what_cannot_be_compared_is_refused) {
  BOOST_CHECK_THROW(step_down_max_t({{TwoSides{{1}, {1, 2}}}}, 99, 1), InputError);
  BOOST_CHECK_THROW(step_down_max_t({{TwoSides{{1, 2}, {1, std::numeric_limits<double>::infinity()}}}}, 99, 1),
                    InputError);
  BOOST_CHECK_THROW(step_down_max_t({{TwoSides{{1, 2}, {1, 2}}}}, 0, 1), InputError);
  BOOST_TEST(step_down_max_t({}, 99, 1).global_p == 1);
}

BOOST_AUTO_TEST_SUITE_END()
