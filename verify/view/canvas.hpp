// Pictures of the flow in pixels, for a movie.
#pragma once

#include <string>

#include "gpf/scene/scene.hpp"
#include "gpf/scene/state.hpp"
#include "verify/view/colouring.hpp"

namespace gpf {

/// Draws states of one scene to scale on a white ground: x to the right, the lower wall below, colours from zero to a
/// fixed greatest value.
class Canvas {
 public:
  /// The channel is at most that many pixels long and wide; the picture has even sides, as video wants them.
  static constexpr int longest = 1280, tallest = 720;

  /// The colours' range is that of `first`: 99 of 100 disks lie in it.
  Canvas(const Scene& scene, int bins, Colouring colouring, const State& first);

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  /// Rows from above, three bytes (red, green, blue) for each pixel.
  [[nodiscard]] std::string draw(const State& state) const;

 private:
  struct Place {
    double x, y;
  };
  void draw_disk(std::string& pixels, Place centre, const unsigned char* colour) const;
  void draw_walls(std::string& pixels) const;

  Scene scene_;
  int bins_;
  Colouring colouring_;
  double scale_, radius_, greatest_;
  int width_, height_;
};

}  // namespace gpf
