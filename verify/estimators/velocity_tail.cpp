#include "verify/estimators/velocity_tail.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace gpf {
namespace {

constexpr double cell = VelocityDistribution::cell;

/// ((x/from)^bend - 1)/bend
double rise(double x, double from, double bend) {
  const double log_x = std::log(x / from);
  return std::abs(bend) < 1e-6 ? log_x : std::expm1(bend * log_x) / bend;
}

/// What ln L and its derivatives by the slope are made of, for each cell: integrals of e^(-slope h), of h e^(-slope h)
/// and of h^2 e^(-slope h), by Simpson's rule.
struct Moments {
  double zero = 0, one = 0, two = 0;
};
class Cells {
 public:
  Cells(TailWindow window, std::size_t count, double bend) {
    for (std::size_t i = 0; i < count; ++i)
      for (int k = 0; k < 3; ++k)
        rise_.push_back(rise(window.from + (static_cast<double>(i) + 0.5 * k) * cell, window.from, bend));
  }
  [[nodiscard]] Moments of(std::size_t i, double slope) const {
    constexpr std::array<double, 3> weight{1, 4, 1};
    Moments m;
    for (std::size_t k = 0; k < 3; ++k) {
      const double h = rise_[3 * i + k], p = weight[k] * std::exp(-slope * h);
      m.zero += p, m.one += p * h, m.two += p * h * h;
    }
    return m;
  }

 private:
  std::vector<double> rise_;  // at both ends and in the middle of each cell
};

double log_likelihood(const TailCounts& tail, double slope, double bend) {
  const Cells cells(tail.window, tail.counts.size(), bend);
  double sum = 0, n = 0, all = 0;
  for (std::size_t i = 0; i < tail.counts.size(); ++i) {
    const double p = cells.of(i, slope).zero;
    sum += tail.counts[i] * std::log(p), n += tail.counts[i], all += p;
  }
  return sum - n * std::log(all);
}

}  // namespace

TailCounts tail_counts(const VelocityDistribution& d, TailWindow window, TailSide side) {
  TailCounts tail{window, {}};
  const auto cells = static_cast<std::size_t>(std::lround((window.to - window.from) / cell));
  for (std::size_t i = 0; i < cells; ++i) {
    const double lo = window.from + static_cast<double>(i) * cell, hi = lo + cell;
    tail.counts.push_back((side == TailSide::negative ? 0 : d.between(lo, hi)) +
                          (side == TailSide::positive ? 0 : d.between(-hi, -lo)));
  }
  return tail;
}

double TailLaw::log_likelihood(const TailCounts& tail) const { return gpf::log_likelihood(tail, slope, bend); }

double TailLaw::slope_at_end(TailWindow window) const { return slope * std::pow(window.to / window.from, bend); }

TailLaw fit_tail(const TailCounts& tail, double bend) {
  double n = 0;
  for (const double count : tail.counts) n += count;
  if (n < 10) return {std::numeric_limits<double>::quiet_NaN(), bend};
  const Cells cells(tail.window, tail.counts.size(), bend);
  double slope = 5;
  for (int iteration = 0; iteration < 50; ++iteration) {  // Newton; ln L is concave
    Moments all;
    double first = 0, second = 0;
    for (std::size_t i = 0; i < tail.counts.size(); ++i) {
      const Moments m = cells.of(i, slope);
      const double mean = m.one / m.zero;
      first -= tail.counts[i] * mean, second += tail.counts[i] * (m.two / m.zero - mean * mean);
      all.zero += m.zero, all.one += m.one, all.two += m.two;
    }
    const double mean = all.one / all.zero;
    first += n * mean, second -= n * (all.two / all.zero - mean * mean);
    const double step = std::clamp(-first / second, -2.0, 2.0);
    slope += step;
    if (std::abs(step) < 1e-9) break;
  }
  return {slope, bend};
}

TailLaw fit_stretched_tail(const TailCounts& tail) {
  const auto best = [&](double bend) {
    const TailLaw law = fit_tail(tail, bend);
    return law.log_likelihood(tail);
  };
  const double golden = (std::sqrt(5.0) - 1) / 2;
  double lo = -2, hi = 4, a = hi - golden * (hi - lo), b = lo + golden * (hi - lo), at_a = best(a), at_b = best(b);
  while (hi - lo > 1e-4) {
    if (at_a > at_b)
      hi = b, b = a, at_b = at_a, a = hi - golden * (hi - lo), at_a = best(a);
    else
      lo = a, a = b, at_a = at_b, b = lo + golden * (hi - lo), at_b = best(b);
  }
  return fit_tail(tail, 0.5 * (lo + hi));
}

std::vector<TailFit> fit_tails(const std::vector<VelocityDistribution>& replicas, TailSide side) {
  std::vector<TailFit> fits;
  for (const TailWindow window : tail_windows) {
    TailFit fit{window, {}, {}, {}, {}};
    std::vector<TailCounts> tails;
    for (const VelocityDistribution& d : replicas) tails.push_back(tail_counts(d, window, side));
    for (std::size_t r = 0; r < tails.size(); ++r) {
      const TailLaw stretched = fit_stretched_tail(tails[r]);
      fit.exponent.push_back(fit_tail(tails[r], 0).slope);
      fit.bend.push_back(stretched.bend);
      fit.end_slope.push_back(stretched.slope_at_end(window) - stretched.slope);
      TailCounts others{window, std::vector<double>(tails[r].counts.size(), 0.0)};
      for (std::size_t q = 0; q < tails.size(); ++q)
        for (std::size_t i = 0; q != r && i < others.counts.size(); ++i) others.counts[i] += tails[q].counts[i];
      fit.against_power.push_back(fit_stretched_tail(others).log_likelihood(tails[r]) -
                                  fit_tail(others, 0).log_likelihood(tails[r]));
    }
    fits.push_back(std::move(fit));
  }
  return fits;
}

TailExponent tail_exponent(const std::vector<TailFit>& fits) {
  TailExponent result;
  double least = INFINITY, most = -INFINITY;
  for (const TailFit& fit : fits) {
    const double mean = over_replicas(fit.exponent).mean;
    least = std::min(least, mean), most = std::max(most, mean);
  }
  result.per_replica = per_replica(fits.front().exponent.size(), [&](std::size_t r) {
    double sum = 0;
    for (const TailFit& fit : fits) sum += fit.exponent[r];
    return sum / static_cast<double>(fits.size());
  });
  result.half_spread = 0.5 * (most - least);
  result.estimate = over_replicas(result.per_replica);
  result.estimate.error += result.half_spread;
  return result;
}

}  // namespace gpf
