// vacf: how long a disk remembers its fluctuation velocity.
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "gpf/measure/correlations.hpp"
#include "verify/estimators/estimators.hpp"
#include "verify/estimators/pair_functions.hpp"

namespace gpf {
namespace {

/// C(t) = <u(0) u(t)>/<u(0)^2> (eq. 3.5) of disks that were in `bin` or its mirror image at time 0, by lag; `name` is
/// "time/ux" or "time/uy".
std::vector<double> autocorrelation(const Record& record, const char* name, int bin) {
  const NamedArray &sums = array_named(record.arrays, name), &count = array_named(record.arrays, "time/count");
  std::vector<double> c;
  for (std::size_t lag = 0; lag < Correlations::lags; ++lag) {
    double sum = 0, n = 0;
    for (const int b : {bin, record.run.bins - 1 - bin}) {
      sum += sums.at(static_cast<std::size_t>(b), lag);
      n += count.at(static_cast<std::size_t>(b), lag);
    }
    c.push_back(sum / n);
  }
  for (std::size_t lag = c.size(); lag-- > 0;) c[lag] /= c[0];
  return c;
}

}  // namespace

/// C_x at the centre and in the shear layer - bin 5, or 2 in very dense flows - has decayed from `decayed_after` on:
/// its means over the windows of time from there, each twice as long as the one before, lie within the tolerance about
/// zero.
Evidence estimate_autocorrelation(const Claim& claim, Tier, const SceneRecords& records) {
  const double after = claim.parameter("decayed_after"), very_dense = claim.parameter("very_dense");
  const Interval band = band_about(0, claim.tolerance_total());
  Evidence evidence;
  evidence.plot = {.title = "Velocity autocorrelation function",
                   .xlabel = "t (W/g)^(-1/2)",
                   .ylabel = "C_x",
                   .series = {{.label = "band",
                               .style = SeriesStyle::band,
                               .x = {after, 1},
                               .y = {0, 0},
                               .lower = {band.lo, band.lo},
                               .upper = {band.hi, band.hi}}}};
  for (const SceneValues& scene : by_area_fraction(records)) {
    const std::string label = label_of(scene.scene());
    const double interval = scene.records().front().run.sample_interval;
    const int shear = scene.scene().area_fraction() > very_dense ? 1 : scene.half() / 2;
    for (const int bin : {scene.half() - 1, shear}) {
      const auto curves = [&](const char* name) {
        std::vector<std::vector<double>> all;
        for (const Record& record : scene.records()) all.push_back(autocorrelation(record, name, bin));
        return all;
      };
      const auto x = curves("time/ux"), y = curves("time/uy");
      const auto at = [&](const std::vector<std::vector<double>>& c, std::size_t lag) {
        return per_replica(c.size(), [&](std::size_t r) { return c[r][lag]; });
      };
      for (double from = after; from < interval * (Correlations::lags - 1); from *= 2) {
        const auto first = static_cast<std::size_t>(from / interval),
                   last = std::min(2 * first, Correlations::lags - 1);
        evidence.checks.push_back({.label = fmt::format("{}, bin {}: C_x from t {} to {}", label, bin + 1, from,
                                                        interval * static_cast<double>(last)),
                                   .values = per_replica(x.size(),
                                                         [&](std::size_t r) {
                                                           double sum = 0;
                                                           for (std::size_t lag = first; lag <= last; ++lag)
                                                             sum += x[r][lag];
                                                           return sum / static_cast<double>(last - first + 1);
                                                         }),
                                   .band = band,
                                   .x = from,
                                   .reference = 0});
      }
      Series points{.label = fmt::format("{}, bin {}", label, bin + 1)};
      std::string cx, cy;
      for (std::size_t lag = 0; lag < Correlations::lags; ++lag) {
        add_point(points, interval * static_cast<double>(lag), at(x, lag));
        if (lag > 0 && (lag & (lag - 1)) == 0) {
          cx += fmt::format(" {:.3f}", over_replicas(at(x, lag)).mean);
          cy += fmt::format(" {:.3f}", over_replicas(at(y, lag)).mean);
        }
      }
      evidence.plot.series.push_back(std::move(points));
      evidence.notes.push_back(fmt::format("{}, bin {}: after 1, 2, 4, 8, 16, 32 intervals of {} C_x is{}; C_y{}.",
                                           label, bin + 1, interval, cx, cy));
    }
  }
  evidence.notes.emplace_back(
      "u_x about the instantaneous mean of the bin that the disk is in at that time (eq. 2.10), c_y as it is: a plug "
      "that "
      "moves as a whole across the channel shows in C_y, not in C_x.");
  return evidence;
}

}  // namespace gpf
