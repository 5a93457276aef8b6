#include "verify/view/canvas.hpp"

#include <algorithm>
#include <cmath>

#include "verify/view/palette.hpp"

namespace gpf {
namespace {

constexpr int margin = 4;               // pixels around the channel
constexpr Rgb one_colour{36, 68, 102};  // of snapshots, too

int even(double pixels) { return 2 * static_cast<int>(std::ceil(pixels / 2)); }

double most_of(std::vector<double> values) {
  const std::size_t rank = values.size() - 1 - values.size() / 100;
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(rank), values.end());
  return values[rank];
}

}  // namespace

Canvas::Canvas(const Scene& scene, int bins, Colouring colouring, const State& first)
    : scene_(scene),
      bins_(bins),
      colouring_(colouring),
      scale_(std::min((longest - 2 * margin) / scene.length(), double{tallest - 2 * margin})),
      radius_(std::max(0.5, scale_ * scene.diameter() / 2)),
      greatest_(most_of(shown_values(first, colouring, bins))),
      width_(even(scale_ * scene.length() + 2 * margin)),
      height_(even(scale_ + 2 * margin)) {}

std::string Canvas::draw(const State& state) const {
  std::string pixels(static_cast<std::size_t>(3 * width_ * height_), '\xff');
  const std::vector<double> values = shown_values(state, colouring_, bins_);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Rgb colour = colouring_ == Colouring::one ? one_colour : colour_at(greatest_ > 0 ? values[i] / greatest_ : 0);
    const Vec2 r = state.position[i];
    // A disk that reaches over the end of a period is seen at both ends.
    for (const double x : {r.x - scene_.length(), r.x, r.x + scene_.length()})
      for (const double y : {r.y - 1, r.y, r.y + 1}) {
        const bool image = y != r.y;
        if (image && scene_.geometry == Geometry::channel) continue;
        draw_disk(pixels, {margin + scale_ * x, margin + scale_ * (1 - y)}, colour.data());
      }
  }
  if (scene_.geometry == Geometry::channel) draw_walls(pixels);
  return pixels;
}

/// Pixels at the rim are mixed by how far the disk reaches into them.
void Canvas::draw_disk(std::string& pixels, Place centre, const unsigned char* colour) const {
  const auto clipped = [](double at, int low, int high) {
    return std::clamp(static_cast<int>(std::floor(at)), low, high);
  };
  const double right = margin + scale_ * scene_.length(), bottom = margin + scale_;
  if (centre.x + radius_ < margin || centre.x - radius_ > right) return;
  if (centre.y + radius_ < margin || centre.y - radius_ > bottom) return;
  const int first_x = clipped(centre.x - radius_ - 1, margin, width_ - 1),
            last_x = clipped(centre.x + radius_ + 1, margin, std::min(width_ - 1, static_cast<int>(right)));
  const int first_y = clipped(centre.y - radius_ - 1, margin, height_ - 1),
            last_y = clipped(centre.y + radius_ + 1, margin, std::min(height_ - 1, static_cast<int>(bottom)));
  for (int y = first_y; y <= last_y; ++y)
    for (int x = first_x; x <= last_x; ++x) {
      const double distance = std::hypot(x + 0.5 - centre.x, y + 0.5 - centre.y);
      const double cover = std::clamp(radius_ - distance + 0.5, 0.0, 1.0);
      if (cover == 0) continue;
      for (std::size_t c = 0; c < 3; ++c) {
        char& byte = pixels[static_cast<std::size_t>(3 * (y * width_ + x)) + c];
        const double ground = static_cast<unsigned char>(byte);
        byte = static_cast<char>(std::lround(std::lerp(ground, colour[c], cover)));
      }
    }
}

void Canvas::draw_walls(std::string& pixels) const {
  constexpr int thickness = 2;
  const int bottom = static_cast<int>(margin + scale_);
  for (const int top : {margin - thickness, std::min(bottom + 1, height_ - thickness)})
    std::fill_n(pixels.begin() + std::ptrdiff_t{3} * width_ * top, std::ptrdiff_t{3} * width_ * thickness, '\x40');
}

}  // namespace gpf
