#include "gpf/io/gnuplot_data.hpp"

#include <fmt/format.h>

#include <cmath>
#include <initializer_list>

#include "gpf/base/error.hpp"

namespace gpf::gnuplot {
namespace {

/// Puts rows together; a gap between two rows becomes a blank line.
class RowWriter {
 public:
  void add(double x, std::initializer_list<double> ys) {
    if (gap_ && !rows_.text.empty()) rows_.text += '\n';
    gap_ = false;
    rows_.text += fmt::format("{}", x);
    rows_.x.include(x);
    for (const double y : ys) {
      rows_.text += fmt::format(" {}", y);
      rows_.y.include(y);
    }
    rows_.text += '\n';
  }
  void gap() { gap_ = true; }
  Rows rows() && { return std::move(rows_); }

 private:
  Rows rows_;
  bool gap_ = false;
};

}  // namespace

bool drawable(double value, bool logarithmic) {
  return std::isfinite(value) && (!logarithmic || value >= std::numeric_limits<double>::min());
}

void check_lengths(const Series& series) {
  const std::size_t n = series.x.size();
  const bool band = series.style == SeriesStyle::band;
  const auto absent_or_full = [n](const std::vector<double>& values) { return values.empty() || values.size() == n; };
  const bool right = band ? series.lower.size() == n && series.upper.size() == n && absent_or_full(series.y)
                          : series.y.size() == n && absent_or_full(series.yerr);
  if (!right) {
    throw InputError("cannot plot series '" + series.label + "'", "its vectors differ in length",
                     "give one entry per x");
  }
}

double logarithmic_floor(const Plot& plot) {
  if (plot.yrange) return plot.yrange->first;
  Extent positive;
  for (const Series& series : plot.series) {
    for (const auto* values : {&series.y, &series.upper}) {
      for (const double value : *values) {
        if (drawable(value, true)) positive.include(value);
      }
    }
  }
  return positive.least / 10;
}

Rows line_rows(const Plot& plot, const Series& series) {
  RowWriter writer;
  for (std::size_t i = 0; i < series.y.size(); ++i) {
    if (drawable(series.x[i], plot.logx) && drawable(series.y[i], plot.logy)) {
      writer.add(series.x[i], {series.y[i]});
    } else {
      writer.gap();
    }
  }
  return std::move(writer).rows();
}

Rows point_rows(const Plot& plot, const Series& series, double floor) {
  RowWriter writer;
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    const double x = series.x[i], y = series.y[i];
    if (!drawable(x, plot.logx) || !drawable(y, plot.logy)) continue;
    if (series.yerr.empty()) {
      writer.add(x, {y});
    } else {
      const double bar = std::isfinite(series.yerr[i]) ? std::abs(series.yerr[i]) : 0;
      writer.add(x, {y, plot.logy && y - bar <= 0 ? floor : y - bar, y + bar});
    }
  }
  return std::move(writer).rows();
}

Rows band_rows(const Plot& plot, const Series& series, double floor) {
  RowWriter writer;
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    const double low = plot.logy && series.lower[i] <= 0 ? floor : series.lower[i];
    if (drawable(series.x[i], plot.logx) && drawable(low, plot.logy) && drawable(series.upper[i], plot.logy)) {
      writer.add(series.x[i], {low, series.upper[i]});
    } else {
      writer.gap();
    }
  }
  return std::move(writer).rows();
}

}  // namespace gpf::gnuplot
