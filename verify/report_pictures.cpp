#include "verify/report_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "verify/report_check.hpp"

namespace gpf {
namespace {

/// A check at its place in a picture.
struct Bar {
  double x;
  ScaledCheck check;
};

/// Puts bars together, all within +-limit: what lies beyond is drawn at the edge and counted.
class Bars {
 public:
  explicit Bars(double limit) : limit_(limit) {
    intervals_.style = SeriesStyle::line;
    intervals_.label = "confidence interval";
  }

  void add(Series& points, const Bar& bar) {
    points.x.push_back(bar.x);
    points.y.push_back(clamped(bar.check.value));
    if (std::abs(bar.check.value) > limit_) ++beyond_;
    constexpr double gap = std::numeric_limits<double>::quiet_NaN();
    for (const double x : {bar.x, bar.x, gap}) intervals_.x.push_back(x);
    for (const double y : {clamped(bar.check.lo), clamped(bar.check.hi), gap}) intervals_.y.push_back(y);
    for (const double end : {bar.check.value, bar.check.lo, bar.check.hi})
      extent_ = {std::min(extent_.first, clamped(end)), std::max(extent_.second, clamped(end))};
  }

  [[nodiscard]] const Series& intervals() const { return intervals_; }
  /// Of everything drawn, and zero.
  [[nodiscard]] std::pair<double, double> extent() const { return extent_; }
  [[nodiscard]] std::string caption() const {
    if (beyond_ == 0) return {};
    return fmt::format(" {} value(s) beyond +-{:g} are drawn at that edge.", beyond_, limit_);
  }

 private:
  [[nodiscard]] double clamped(double y) const { return std::clamp(y, -limit_, limit_); }

  double limit_;
  std::pair<double, double> extent_{0, 0};
  std::size_t beyond_ = 0;
  Series intervals_;
};

constexpr double band_limit = 3;    // half widths of the band
constexpr double bound_limit = 30;  // standard errors

/// From the first to the last of `count` numbers; wide enough that gnuplot puts its marks at whole numbers only.
std::pair<double, double> number_axis(std::size_t count) {
  constexpr double least_span = 6;
  return {0, std::max(static_cast<double>(count) + 1, least_span)};
}

Plot assembled(std::string title, std::string xlabel, std::size_t count, const Bars& bars, bool to_band,
               const std::vector<Series>& points) {
  const auto range = number_axis(count);
  constexpr double room = 1.08;
  const auto [least, greatest] = bars.extent();
  const double above = room * std::max(greatest, to_band ? 1.3 : 5.0),
               below = room * std::min(least, to_band ? -1.3 : -2.0);
  Plot plot;
  plot.title = std::move(title);
  plot.xlabel = std::move(xlabel);
  plot.ylabel = to_band ? "(value - centre of band) / half width of band" : "distance to bound / standard error";
  plot.xrange = range;
  plot.yrange = {below, above};
  Series band{"band", SeriesStyle::band, {range.first, range.second}};
  band.lower = std::vector<double>(2, to_band ? -1.0 : 0.0);
  band.upper = std::vector<double>(2, to_band ? 1.0 : above);
  band.y = {0, 0};
  plot.series = {bars.intervals(), band};
  plot.series.insert(plot.series.end(), points.begin(), points.end());
  return plot;
}

std::string left_out_text(std::size_t left_out, std::string_view why) {
  return left_out == 0 ? "" : fmt::format(" {} check(s) {} are not shown.", left_out, why);
}

}  // namespace

std::optional<Picture> checks_picture(const Verdict& verdict) {
  const auto& checks = verdict.checks;
  const bool to_band =
      std::any_of(checks.begin(), checks.end(), [](const JudgedCheck& c) { return scaled_to_band(c).has_value(); });
  const auto scaled = [to_band](const JudgedCheck& c) { return to_band ? scaled_to_band(c) : scaled_to_bound(c); };

  Bars bars(to_band ? band_limit : bound_limit);
  // The plot's colours go by position, so that the third is red and the fourth green: empty series stay.
  std::vector<Series> points{{"fail"}, {"pass"}, {"inconclusive"}};
  const auto series_of = [&points](Outcome outcome) -> Series& {
    return points[outcome == Outcome::fail ? 0 : outcome == Outcome::pass ? 1 : 2];
  };
  std::vector<JudgedCheck> drawable;
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < checks.size(); ++i)
    if (scaled(checks[i])) {
      drawable.push_back(checks[i]);
      numbers.push_back(i + 1);
    }
  if (drawable.empty()) return std::nullopt;
  const std::vector<std::size_t> chosen = tightest(drawable, most_checks_in_picture);
  for (const std::size_t k : chosen)
    bars.add(series_of(drawable[k].outcome), {static_cast<double>(numbers[k]), *scaled(drawable[k])});

  const std::size_t beyond = drawable.size() - chosen.size(), undrawable = checks.size() - drawable.size();
  return Picture{assembled(verdict.claim_id + ": checks", "number of the check in the table", checks.size(), bars,
                           to_band, points),
                 fmt::format("{}{}{}{}",
                             to_band ? "Each check in half widths of its band, which is shaded."
                                     : "Each check by its distance to its bound; the shaded side is the wanted one.",
                             bars.caption(), left_out_text(beyond, "with more room"),
                             left_out_text(undrawable, to_band ? "without two edges" : "without a bound or an error"))};
}

std::optional<Picture> bias_and_scatter(const std::vector<JudgedClaim>& claims) {
  Bars bars(band_limit);
  std::vector<Series> points;
  std::vector<std::string> absent;
  std::size_t left_out = 0;
  for (std::size_t n = 0; n < claims.size(); ++n) {
    std::vector<JudgedCheck> drawable;
    for (const JudgedCheck& c : claims[n].verdict.checks)
      if (scaled_to_band(c)) drawable.push_back(c);
    if (drawable.empty()) {
      absent.push_back(fmt::format("{} {}", n + 1, claims[n].claim.id));
      continue;
    }
    const std::vector<std::size_t> chosen = tightest(drawable, most_checks_per_claim);
    left_out += drawable.size() - chosen.size();
    Series series{fmt::format("{} {}", n + 1, claims[n].claim.id)};
    for (std::size_t k = 0; k < chosen.size(); ++k) {
      // Side by side in the middle of the claim's column.
      const double place = (static_cast<double>(k) + 0.5) / static_cast<double>(chosen.size()) - 0.5;
      bars.add(series, {static_cast<double>(n + 1) + 0.7 * place, *scaled_to_band(drawable[chosen[k]])});
    }
    points.push_back(std::move(series));
  }
  if (points.empty()) return std::nullopt;
  std::string caption =
      bars.caption() +
      left_out_text(left_out, fmt::format("with more room than {} others of their claim", most_checks_per_claim));
  if (!absent.empty())
    caption += fmt::format(" Claims that rest on signs, orders or other one-sided checks alone are left out: {}.",
                           fmt::join(absent, ", "));
  return Picture{assembled("Bias and scatter of all claims", "number of the claim in the table", claims.size(), bars,
                           true, points),
                 caption};
}

}  // namespace gpf
