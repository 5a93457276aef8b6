#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

#include "gpf/base/error.hpp"
#include "gpf/io/gnuplot_data.hpp"
#include "gpf/io/plot.hpp"
#include "gpf/io/utf8.hpp"

namespace gpf {
namespace {

using gnuplot::Extent;
using gnuplot::Rows;

/// The colours of Okabe & Ito (2008), which the colour-blind can tell apart, darkest first.
constexpr std::array<std::string_view, 7> colours{"#000000", "#0072b2", "#d55e00", "#009e73",
                                                  "#cc79a7", "#e69f00", "#56b4e9"};
/// gnuplot's filled circle, square, triangle, diamond, triangle down, then open ones: distinct in black and white.
constexpr std::array<int, 8> point_types{7, 5, 9, 13, 11, 6, 4, 8};
constexpr std::array<std::string_view, 4> dashes{"solid", "'_ '", "'_ . '", "'- '"};

/// A text as a gnuplot literal: double-quoted, with every byte that could mean something to gnuplot as an octal escape,
/// so that neither quotes nor backticks ever stand in a script. (Single quotes would need fewer escapes, but gnuplot
/// 5.4 reads ''' as the end of a text.) What SVG cannot hold is replaced, ]]> too, as gnuplot writes > as it is.
std::string literal(const std::string& text) {
  constexpr std::string_view harmless = " .,()/=+-";
  std::string quoted = "\"";
  int brackets = 0;  // ] just before
  for (const char c : xml_characters(text)) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '>' && brackets >= 2) quoted += ' ';
    brackets = c == ']' ? brackets + 1 : 0;
    if (code >= 0x80 || std::isalnum(code) != 0 || harmless.find(c) != std::string_view::npos)
      quoted += c;
    else
      quoted += fmt::format("\\{:03o}", code);
  }
  return quoted + '"';
}

/// Data blocks and the elements of the plot command that draw them.
class Drawing {
 public:
  explicit Drawing(const Plot& plot) : plot_(plot), floor_(plot.logy ? gnuplot::logarithmic_floor(plot) : 0) {
    for (std::size_t i = 0; i < plot.series.size(); ++i) add(plot.series[i], colours[i % colours.size()]);
  }

  [[nodiscard]] std::string commands() const { return data_ + "plot " + elements_ + "\n"; }
  [[nodiscard]] bool empty() const { return elements_.empty(); }
  [[nodiscard]] const Extent& x() const { return x_; }
  [[nodiscard]] const Extent& y() const { return y_; }
  /// Characters of the longest label in the key, and how many labels there are.
  [[nodiscard]] std::size_t longest_label() const { return longest_label_; }
  [[nodiscard]] std::size_t labels() const { return labels_; }

 private:
  void add(const Series& series, std::string_view colour) {
    gnuplot::check_lengths(series);
    switch (series.style) {
      case SeriesStyle::points:
        return add_points(series, colour);
      case SeriesStyle::line:
        if (add_rows(gnuplot::line_rows(plot_, series))) {
          draw(fmt::format("using 1:2 with lines lw 1.8 lc '{}' dt {}", colour, dashes[lines_++ % dashes.size()]),
               series.label);
        }
        return;
      case SeriesStyle::band:
        if (add_rows(gnuplot::band_rows(plot_, series, floor_))) {
          draw(fmt::format("using 1:2:3 with filledcurves fill transparent solid 0.25 noborder lc '{}'", colour),
               series.label);
        }
        if (add_rows(gnuplot::line_rows(plot_, series))) {
          draw(fmt::format("using 1:2 with lines lw 1.8 lc '{}' dt solid", colour), "");
        }
    }
  }

  /// Bars as plain strokes: gnuplot's own error bars leave gaps around the points and alter the points in the key.
  void add_points(const Series& series, std::string_view colour) {
    if (!add_rows(gnuplot::point_rows(plot_, series, floor_))) return;
    if (!series.yerr.empty()) {
      draw(fmt::format("using 1:3:(0):($4-$3) with vectors nohead lw 1.2 lc '{}' dt solid", colour), "");
    }
    draw(fmt::format("using 1:2 with points lw 1.2 pt {} ps 0.7 lc '{}'", point_types[points_++ % point_types.size()],
                     colour),
         series.label);
  }

  /// A new data block, for the next calls of draw. Returns whether there is anything in it.
  bool add_rows(const Rows& rows) {
    if (rows.text.empty()) return false;
    block_ = fmt::format("$data{}", blocks_++);
    data_ += fmt::format("{} << END\n{}END\n", block_, rows.text);
    for (const double end : {rows.x.least, rows.x.greatest}) x_.include(end);
    for (const double end : {rows.y.least, rows.y.greatest}) y_.include(end);
    return true;
  }

  void draw(std::string_view how, const std::string& label) {
    elements_ += fmt::format("{}{} {} {}", elements_.empty() ? "" : ", ", block_, how,
                             label.empty() ? "notitle" : "title " + literal(label) + " noenhanced");
    if (!label.empty()) ++labels_;
    longest_label_ = std::max(longest_label_, character_count(label));
  }

  const Plot& plot_;
  double floor_;
  std::string data_, elements_, block_;
  Extent x_, y_;
  std::size_t blocks_ = 0, lines_ = 0, points_ = 0, labels_ = 0, longest_label_ = 0;
};

std::string axis(char name, const std::string& label, bool logarithmic,
                 const std::optional<std::pair<double, double>>& range, Extent drawn) {
  std::string commands = fmt::format("set {}label {} noenhanced\n", name, literal(label));
  if (range) {
    if (!(gnuplot::drawable(range->first, logarithmic) && gnuplot::drawable(range->second, logarithmic) &&
          range->first < range->second)) {
      throw InputError(fmt::format("cannot plot over the {} range [{}, {}]", name, range->first, range->second),
                       logarithmic ? "a logarithmic axis needs 0 < lower < upper" : "lower < upper must hold",
                       "give another range or none");
    }
    commands += fmt::format("set {}range [{}:{}]\n", name, range->first, range->second);
    drawn = {range->first, range->second};
  }
  // Within a decade or so gnuplot puts tics between the powers of ten, which the power alone would not tell apart.
  const bool powers = logarithmic && drawn.greatest / drawn.least > 30;
  if (logarithmic) commands += fmt::format("set logscale {} 10\n", name);
  return commands + fmt::format("set format {} '{}'\n", name, powers ? "10^{%T}" : "%h");
}

/// Size of the picture and place of the key, in pixels: the plot keeps its size, and the key, right of it, adds to the
/// width. gnuplot's own placing takes labels for half as wide again as they are, at the plot's expense.
std::string layout(const Drawing& drawing) {
  constexpr std::size_t plot_right = 620, least_height = 480, margins = 150;
  constexpr std::size_t sample = 68, character = 9, entry = 27;  // at 16 pixels of font size
  const std::size_t longest = std::min<std::size_t>(drawing.longest_label(), 80);
  const std::size_t width = plot_right + 20 + (longest > 0 ? sample + character * longest : 0);
  const std::size_t height = std::max(least_height, margins + entry * drawing.labels());
  return fmt::format(
      "set terminal svg enhanced size {0},{1} fixed font 'Helvetica,16' background '#ffffff' rounded\n"
      "set rmargin at screen {2:.4f}\n"
      "set key at screen {3:.4f}, graph 1 left top vertical Left reverse samplen 2.6 spacing 1.1 noenhanced\n",
      width, height, static_cast<double>(plot_right) / static_cast<double>(width),
      static_cast<double>(plot_right + 12) / static_cast<double>(width));
}

}  // namespace

std::string gnuplot_script(const Plot& plot) {
  const Drawing drawing(plot);
  if (drawing.empty()) {
    throw InputError("cannot draw plot '" + plot.title + "'", "no series holds a value that its axes can show",
                     "give finite values, positive ones on logarithmic axes");
  }
  // Enhanced text serves our own tick labels only; every text from outside is marked noenhanced.
  return fmt::format(
      "set encoding utf8\n{}"
      "set border lw 0.8 lc '#404040'\n"
      "set tics nomirror scale 0.6 textcolor '#000000'\n"
      "set grid lt 1 lw 0.6 lc '#d9d9d9'\n"
      "set title {} noenhanced\n{}{}{}",
      layout(drawing), literal(plot.title), axis('x', plot.xlabel, plot.logx, plot.xrange, drawing.x()),
      axis('y', plot.ylabel, plot.logy, plot.yrange, drawing.y()), drawing.commands());
}

}  // namespace gpf
