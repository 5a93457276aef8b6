#include "verify/estimators/local_order.hpp"

#include <algorithm>
#include <cmath>

namespace gpf {
namespace {

double mean_between(const std::vector<double>& g, double from, double to) {
  double sum = 0, cells = 0;
  for (std::size_t k = 0; k < g.size(); ++k)
    if (PairFunctions::distance(k) > from && PairFunctions::distance(k) < to) sum += g[k], cells += 1;
  return sum / cells;
}

/// The valley that is deepest against the lower of the two sides, over 1.55 < r/d < 2.45; three cells are averaged, and
/// a valley below .05 counts as .05.
double split_of(const std::vector<double>& g) {
  std::vector<double> shell;
  for (std::size_t k = 1; k + 1 < g.size(); ++k)
    if (PairFunctions::distance(k) > 1.55 && PairFunctions::distance(k) < 2.45)
      shell.push_back((g[k - 1] + g[k] + g[k + 1]) / 3);
  double deepest = 1;
  for (auto valley = shell.begin() + 1; valley + 1 < shell.end(); ++valley) {
    const double left = *std::max_element(shell.begin(), valley), right = *std::max_element(valley + 1, shell.end());
    deepest = std::max(deepest, std::min(left, right) / std::max(*valley, 0.05));
  }
  return deepest;
}

}  // namespace

LocalOrder local_order(const std::vector<double>& pair_correlation, double hexatic) {
  return {.shell = mean_between(pair_correlation, 1.95, 2.35) - mean_between(pair_correlation, 1.4, 1.7),
          .split = split_of(pair_correlation),
          .hexatic = hexatic};
}

LocalOrder local_order(const PairFunctions& pairs) { return local_order(pairs.pair_correlation(), pairs.hexatic()); }

std::vector<OrderCriterion> criteria_of(Order order) {
  switch (order) {
    case Order::gas:
      return {{"second shell", &LocalOrder::shell, {-INFINITY, 0}}};
    case Order::liquid:
      return {{"second shell", &LocalOrder::shell, {0.13, INFINITY}},
              {"split of the second maximum", &LocalOrder::split, {0, 1.4}},
              {"mean |psi_6|", &LocalOrder::hexatic, {0, 0.70}}};
    case Order::crystal:
      break;
  }
  return {{"split of the second maximum", &LocalOrder::split, {2, INFINITY}},
          {"mean |psi_6|", &LocalOrder::hexatic, {0.80, INFINITY}}};
}

std::optional<Order> classify(const LocalOrder& order) {
  for (const Order candidate : {Order::gas, Order::liquid, Order::crystal}) {
    const std::vector<OrderCriterion> criteria = criteria_of(candidate);
    if (std::all_of(criteria.begin(), criteria.end(), [&](const auto& c) { return c.range.contains(order.*c.value); }))
      return candidate;
  }
  return std::nullopt;
}

std::string name_of(const std::optional<Order>& order) {
  if (!order) return "between the classes";
  switch (*order) {
    case Order::gas:
      return "gas";
    case Order::liquid:
      return "liquid";
    case Order::crystal:
      break;
  }
  return "crystal";
}

}  // namespace gpf
