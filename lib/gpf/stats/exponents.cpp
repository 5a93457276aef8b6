#include "gpf/stats/exponents.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "gpf/base/error.hpp"
#include "gpf/stats/fit.hpp"
#include "gpf/stats/interval.hpp"

namespace gpf {
namespace {

void check_points(std::span<const std::vector<double>> x, std::span<const std::vector<double>> y) {
  if (x.size() != y.size() || x.size() < 4) {
    throw InputError(fmt::format("no power law from {} values of x and {} of y", x.size(), y.size()),
                     "the slopes at its two ends are compared, and each needs two points", "pass at least four pairs");
  }
  for (std::size_t k = 0; k < x.size(); ++k) {
    if (x[k].empty() || x[k].size() != x[0].size() || y[k].size() != x[0].size()) {
      throw InputError(fmt::format("point {} has {} and {} values", k, x[k].size(), y[k].size()),
                       "every replica is fitted by itself", "pass one value of x and y per replica at each point");
    }
    for (std::size_t r = 0; r < x[k].size(); ++r) {
      if (!(x[k][r] > 0 && std::isfinite(x[k][r]) && y[k][r] > 0 && std::isfinite(y[k][r]))) {
        throw InputError(fmt::format("point ({}, {}) is on no power law", x[k][r], y[k][r]),
                         "only numbers above 0 have a logarithm", "leave it out, or shift the quantity");
      }
    }
  }
}

/// Points first ... first + count - 1 of replica r.
double slope(std::span<const std::vector<double>> x, std::span<const std::vector<double>> y, std::size_t r) {
  std::vector<double> log_x;
  std::vector<Estimate> log_y;
  for (std::size_t k = 0; k < x.size(); ++k) {
    log_x.push_back(std::log(x[k][r]));
    log_y.push_back({std::log(y[k][r]), 1});
  }
  return fit_line(log_x, log_y).slope;
}

std::vector<std::vector<double>> in_order(std::span<const std::vector<double>> points,
                                          const std::vector<std::size_t>& order) {
  std::vector<std::vector<double>> sorted;
  for (const std::size_t k : order) sorted.push_back(points[k]);
  return sorted;
}

}  // namespace

double Exponents::half_spread() const {
  const auto by_exponent = [](const FitWindow& a, const FitWindow& b) { return a.exponent < b.exponent; };
  const auto [least, most] = std::minmax_element(windows.begin(), windows.end(), by_exponent);
  return (most->exponent - least->exponent) / 2;
}

std::vector<double> Exponents::bend() const {
  std::vector<double> bend;
  for (std::size_t r = 0; r < low_end.size(); ++r) bend.push_back(high_end[r] - low_end[r]);
  return bend;
}

double bend_of_departure(double departure, double lowest_x, double highest_x) {
  return 2.0 / 3.0 * 16 * departure / std::log(highest_x / lowest_x);
}

Exponents fit_exponents(std::span<const std::vector<double>> x, std::span<const std::vector<double>> y) {
  check_points(x, y);
  const auto mean = [&](std::size_t k) { return summarise(x[k]).mean; };
  std::vector<std::size_t> order(x.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return mean(a) < mean(b); });
  const std::vector<std::vector<double>> sorted_x = in_order(x, order), sorted_y = in_order(y, order);

  const std::size_t points = x.size(), third = std::max<std::size_t>(2, points / 3),
                    quarter = std::max<std::size_t>(1, points / 4);
  const auto slopes = [&](std::size_t first, std::size_t count) {
    std::vector<double> of_replica;
    for (std::size_t r = 0; r < x[0].size(); ++r)
      of_replica.push_back(
          slope(std::span(sorted_x).subspan(first, count), std::span(sorted_y).subspan(first, count), r));
    return of_replica;
  };
  Exponents fit{slopes(0, points), slopes(0, third), slopes(points - third, third), {}};
  const auto add_window = [&](std::size_t first, std::size_t count) {
    fit.windows.push_back({mean(order[first]), mean(order[first + count - 1]), summarise(slopes(first, count)).mean});
  };
  add_window(0, points);
  add_window(0, points - quarter);
  add_window(quarter, points - quarter);
  return fit;
}

}  // namespace gpf
