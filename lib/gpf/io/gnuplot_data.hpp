// For the plots only: the drawable part of a series as gnuplot reads it, and the range that it covers.
#pragma once

#include <algorithm>
#include <limits>
#include <string>

#include "gpf/io/plot.hpp"

namespace gpf::gnuplot {

/// The smallest and the largest of the values drawn along an axis.
struct Extent {
  double least = std::numeric_limits<double>::infinity(), greatest = -std::numeric_limits<double>::infinity();

  void include(double value) {
    least = std::min(least, value);
    greatest = std::max(greatest, value);
  }
};

/// Rows of numbers, one line each; a blank line breaks a line or a band. Empty when nothing can be drawn.
struct Rows {
  std::string text;
  Extent x, y;
};

/// Whether an axis can show the value. gnuplot fails on logarithms of denormal numbers, so they count as zero there.
bool drawable(double value, bool logarithmic);

/// @throws InputError when the vectors that the series' style needs differ in length.
void check_lengths(const Series& series);

/// Where bars and bands that reach down to zero or below end on a logarithmic y axis: under every positive value.
double logarithmic_floor(const Plot& plot);

Rows line_rows(const Plot& plot, const Series& series);                 ///< x y
Rows point_rows(const Plot& plot, const Series& series, double floor);  ///< x y, or x y low high with error bars
Rows band_rows(const Plot& plot, const Series& series, double floor);   ///< x low high

}  // namespace gpf::gnuplot
