#include "gpf/io/snapshot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gpf/io/utf8.hpp"
#include "gpf/measure/density_spectrum.hpp"

namespace gpf {
namespace {

constexpr int most_kx = 8, most_ky = 4;
constexpr int most_cells = 1024;    // more add nothing to wavenumbers as low as these
constexpr double decades = 4;       // of power over the noise, from white to black
constexpr double longest = 900;     // pixels along the channel
constexpr double tallest = 400;     // pixels across it
constexpr double square_side = 18;  // of the spectrum

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : xml_characters(text))
    result += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
  return result;
}

std::string spectrum_squares(const Scene& scene, const State& state, double top) {
  // Cells of about a diameter: finer ones add nothing to wavenumbers as low as these.
  const auto cells = [](double diameters) { return std::clamp(static_cast<int>(diameters), 4 * most_kx, most_cells); };
  const DensitySpectrum spectrum(density_field(scene, state, cells(scene.length_over_width * scene.width_over_diameter),
                                               cells(scene.width_over_diameter)));
  const double noise = noise_of_spectrum(scene);
  std::string svg;
  for (int kx = 0; kx <= most_kx; ++kx)
    for (int ky = -most_ky; ky <= most_ky; ++ky) {
      if (kx == 0 && ky == 0) continue;  // the mean
      const double level = std::clamp(std::log10(spectrum.power(kx, ky) / noise) / decades, 0.0, 1.0);
      const int grey = static_cast<int>(std::lround(255 * (1 - level)));
      svg += fmt::format(
          "<rect x=\"{:.0f}\" y=\"{:.0f}\" width=\"{}\" height=\"{}\" fill=\"rgb({},{},{})\" "
          "stroke=\"#ccc\"><title>({}, {}): {:.3g} of the noise</title></rect>\n",
          40 + kx * square_side, top + (most_ky - ky) * square_side, square_side, square_side, grey, grey, grey, kx, ky,
          spectrum.power(kx, ky) / noise);
    }
  for (const int kx : {0, 2, 4, 6, 8})
    svg += fmt::format("<text x=\"{:.0f}\" y=\"{:.0f}\">{}</text>\n", 45 + kx * square_side,
                       top + (2 * most_ky + 2) * square_side - 3, kx);
  for (const int ky : {-4, -2, 0, 2, 4})
    svg += fmt::format("<text x=\"16\" y=\"{:.0f}\">{}</text>\n", top + (most_ky - ky + 1) * square_side - 4, ky);
  svg += fmt::format(
      "<text x=\"{:.0f}\" y=\"{:.0f}\">power at (kx to the right, ky upward): white noise, black 10⁴ times "
      "that</text>\n",
      60 + (most_kx + 1) * square_side, top + (most_ky + 1) * square_side);
  return svg;
}

}  // namespace

std::string snapshot_svg(const Scene& scene, const State& state, const std::string& title) {
  const double scale = std::min(longest / scene.length(), tallest), channel = scale, along = scale * scene.length();
  const double radius = std::max(0.5, scale * scene.diameter() / 2), below = 30 + channel + 14;
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{:.0f}\" height=\"{:.0f}\" font-family=\"sans-serif\" "
      "font-size=\"12\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n<text x=\"8\" y=\"18\">{}</text>\n",
      std::max(along + 16, 760.0), below + (2 * most_ky + 3) * square_side, escaped(title));
  svg += fmt::format(
      "<rect x=\"8\" y=\"28\" width=\"{:.2f}\" height=\"{:.2f}\" fill=\"none\" stroke=\"black\"/>\n<path "
      "stroke=\"#246\" stroke-linecap=\"round\" stroke-width=\"{:.2f}\" d=\"",
      along, channel, 2 * radius);
  // A line of no length with round ends is a disk, and takes a fifth of the bytes of a <circle>.
  for (const Vec2 r : state.position) svg += fmt::format("M{:.4g},{:.4g}h0", 8 + scale * r.x, 28 + scale * (1 - r.y));
  return svg + "\"/>\n" + spectrum_squares(scene, state, below) + "</svg>\n";
}

}  // namespace gpf
