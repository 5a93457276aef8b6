#include "gpf/stats/step_down.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include "gpf/base/error.hpp"
#include "gpf/base/random.hpp"
#include "gpf/base/vec2.hpp"

namespace gpf {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Equal splits of tied values give equal statistics but for round-off.
bool reaches(double relabelled, double observed) { return relabelled >= observed * (1 - 1e-9); }

/// Numbers with the same counts on either side, as a matrix values x numbers: sums over the values of one side are
/// then sums of rows, which the compiler vectorises.
class Group {
 public:
  Group(std::size_t na, std::size_t nb, std::uint64_t stream) : na_(na), nb_(nb), stream_(stream) {}

  void add(std::size_t number) { members_.push_back(number); }

  void fill(std::span<const TwoSides> numbers) {
    const std::size_t columns = members_.size();
    values_.assign((na_ + nb_) * columns, 0.0);
    shares_.clear();
    for (std::size_t k = 0; k < columns; ++k) {
      const TwoSides& n = numbers[members_[k]];
      std::vector<double> all = n.a;
      all.insert(all.end(), n.b.begin(), n.b.end());
      // Centred, and of sum of squares 1: t does not change, and squares lose no digits. Centred twice, because the
      // mean of numbers whose scatter is small has a round-off of its own.
      for (int pass = 0; pass < 2; ++pass) {
        const double mean = std::accumulate(all.begin(), all.end(), 0.0) / static_cast<double>(all.size());
        for (double& x : all) x -= mean;
      }
      const double squares = std::inner_product(all.begin(), all.end(), all.begin(), 0.0);
      const double scale = squares > 0 ? 1 / std::sqrt(squares) : 0.0;
      for (std::size_t r = 0; r < all.size(); ++r) values_[r * columns + k] = all[r] * scale;
      if (n.share) shares_.push_back(k);
    }
    squares_.resize(values_.size());
    std::transform(values_.begin(), values_.end(), squares_.begin(), [](double x) { return x * x; });
    sum_.resize(columns);
    sum_squares_.resize(columns);
    side_.resize(na_);
    std::iota(side_.begin(), side_.end(), std::size_t{0});
  }

  [[nodiscard]] double relabellings() const { return combinations(na_ + nb_, na_); }

  /// Draws side a anew.
  void draw(std::uint64_t seed, std::uint64_t number) {
    order_.resize(na_ + nb_);
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    for (std::size_t k = 0; k < na_; ++k) {
      const std::uint64_t word = random_words(seed, stream_, number << 16 | k)[0];
      std::swap(order_[k], order_[k + (word * (order_.size() - k) >> 32)]);
    }
    std::copy_n(order_.begin(), na_, side_.begin());
  }

  /// The next choice of side a in lexical order; false, and the first again, after the last.
  bool next() {
    for (std::size_t k = na_; k-- > 0;)
      if (side_[k] < nb_ + k) {
        ++side_[k];
        for (std::size_t j = k + 1; j < na_; ++j) side_[j] = side_[j - 1] + 1;
        return true;
      }
    std::iota(side_.begin(), side_.end(), std::size_t{0});
    return false;
  }

  /// Squares of the statistics under the present choice, each at its number's place.
  void statistics(std::vector<double>& squared) {
    const std::size_t columns = members_.size();
    std::fill(sum_.begin(), sum_.end(), 0.0);
    std::fill(sum_squares_.begin(), sum_squares_.end(), 0.0);
    double* const sum = sum_.data();
    double* const sum_squares = sum_squares_.data();
    for (const std::size_t row : side_) {
      const double* const x = values_.data() + row * columns;
      const double* const x2 = squares_.data() + row * columns;
      for (std::size_t k = 0; k < columns; ++k) sum[k] += x[k];
      for (std::size_t k = 0; k < columns; ++k) sum_squares[k] += x2[k];
    }
    const double na = static_cast<double>(na_), nb = static_cast<double>(nb_), f = na + nb - 2;
    const double wallace = square((8 * f + 1) / (8 * f + 3)) * f;
    for (std::size_t k = 0; k < columns; ++k) {
      // The sum over all is 0, that of the squares 1.
      const double difference = square(sum[k] * (1 / na + 1 / nb));
      const double within_a = sum_squares[k] - square(sum[k]) / na, within_b = 1 - sum_squares[k] - square(sum[k]) / nb;
      const double variance = within_a / (na * (na - 1)) + within_b / (nb * (nb - 1));
      const double t2 = within_a + within_b > 1e-13 ? difference / variance : difference > 1e-13 ? infinity : 0;
      squared[members_[k]] = wallace * std::log1p(t2 / f);
    }
    const double among_relabellings = (1 / na + 1 / nb) / (na + nb - 1);
    for (const std::size_t k : shares_) squared[members_[k]] = square(sum[k] * (1 / na + 1 / nb)) / among_relabellings;
  }

 private:
  std::size_t na_, nb_;
  std::uint64_t stream_;
  std::vector<std::size_t> members_, shares_, side_, order_;
  std::vector<double> values_, squares_, sum_, sum_squares_;
};

void require_usable(std::span<const TwoSides> numbers, int relabellings) {
  if (relabellings < 1)
    throw InputError(fmt::format("no p-values from {} relabellings", relabellings),
                     "they are fractions of the relabellings", "ask for some thousands");
  for (const TwoSides& n : numbers) {
    if (n.a.size() < 2 || n.b.size() < 2)
      throw InputError(fmt::format("no comparison of {} with {} replica(s)", n.a.size(), n.b.size()),
                       "their scatter is the error", "run at least two on either side");
    for (const auto* side : {&n.a, &n.b})
      if (!std::all_of(side->begin(), side->end(), [](double x) { return std::isfinite(x); }))
        throw InputError("a value to be compared is not finite", "it has no place among the others",
                         "leave out numbers that were not measured");
  }
}

std::vector<Group> groups_of(std::span<const TwoSides> numbers) {
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> index;
  std::vector<Group> groups;
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    const auto [found, is_new] = index.try_emplace({numbers[k].a.size(), numbers[k].b.size()}, groups.size());
    if (is_new) groups.emplace_back(numbers[k].a.size(), numbers[k].b.size(), groups.size());
    groups[found->second].add(k);
  }
  for (Group& g : groups) g.fill(numbers);
  return groups;
}

}  // namespace

double combinations(std::size_t all, std::size_t chosen) {
  double result = 1;
  for (std::size_t k = 1; k <= chosen; ++k)
    result = std::round(result * static_cast<double>(all - chosen + k) / static_cast<double>(k));
  return result;
}

double StepDown::critical(double alpha) const {
  // So many relabellings may reach it, the observed one among them.
  const double tried = static_cast<double>(largest.size()) + (exact ? 0 : 1);
  const double may_reach = std::floor(alpha * tried + 1e-9);
  if (may_reach < 1) return infinity;
  const auto place = static_cast<std::size_t>(may_reach) - (exact ? 0 : 1);
  return place < largest.size() ? largest[place] : 0;
}

StepDown step_down_max_t(std::span<const TwoSides> numbers, int relabellings, std::uint64_t seed) {
  require_usable(numbers, relabellings);
  StepDown result;
  if (numbers.empty()) return result;
  std::vector<Group> groups = groups_of(numbers);
  const std::size_t count = numbers.size();
  std::vector<double> observed(count), now(count);
  for (Group& g : groups) g.statistics(observed);
  std::vector<std::size_t> order(count);  // from the largest down
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return observed[i] > observed[j]; });

  double all = 1;
  for (const Group& g : groups) all *= g.relabellings();
  result.exact = all <= relabellings;
  const auto tries = result.exact ? static_cast<std::uint64_t>(all) : static_cast<std::uint64_t>(relabellings);
  std::vector<double> reached(count), reached_alone(count);
  for (std::uint64_t n = 0; n < tries; ++n) {
    if (!result.exact)
      for (Group& g : groups) g.draw(seed, n);
    for (Group& g : groups) g.statistics(now);
    for (std::size_t k = 0; k < count; ++k) reached_alone[k] += reaches(now[k], observed[k]);
    double largest = 0;  // of the numbers whose observed statistic is not larger than that of this one
    for (std::size_t k = count; k-- > 0;) {
      largest = std::max(largest, now[order[k]]);
      reached[order[k]] += reaches(largest, observed[order[k]]);
    }
    result.largest.push_back(std::sqrt(largest));
    if (result.exact)
      for (Group& g : groups)
        if (g.next()) break;
  }
  std::sort(result.largest.begin(), result.largest.end(), std::greater<>());

  const double itself = result.exact ? 0 : 1, tried = static_cast<double>(tries) + itself;
  result.p_adjusted.resize(count);
  double smallest = 0;  // an adjusted value never falls below that of a larger statistic
  for (const std::size_t k : order) {
    smallest = std::max(smallest, (reached[k] + itself) / tried);
    result.p_adjusted[k] = smallest;
  }
  for (std::size_t k = 0; k < count; ++k) {
    result.statistic.push_back(std::sqrt(observed[k]));
    result.p_single.push_back((reached_alone[k] + itself) / tried);
  }
  result.global_p = result.p_adjusted[order.front()];
  return result;
}

}  // namespace gpf
