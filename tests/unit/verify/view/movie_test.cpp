// Pictures in pixels, and the program that they are piped to.
#include <boost/test/unit_test.hpp>

#include "gpf/base/error.hpp"
#include "gpf/io/atomic_file.hpp"
#include "unit/io/temporary_folder.hpp"
#include "verify/view/canvas.hpp"
#include "verify/view/palette.hpp"
#include "verify/view/piped_program.hpp"

using namespace gpf;

namespace {

/// The pixel of a picture at x, y in units of W, in a margin of four pixels.
Rgb pixel(const Canvas& canvas, const std::string& pixels, double length, double x, double y) {
  const double scale = (canvas.width() - 8) / length;
  const int column = 4 + static_cast<int>(scale * x), row = 4 + static_cast<int>(scale * (1 - y));
  Rgb colour{};
  for (std::size_t c = 0; c < 3; ++c)
    colour[c] = static_cast<std::uint8_t>(pixels[3 * static_cast<std::size_t>(row * canvas.width() + column) + c]);
  return colour;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(movie)

BOOST_AUTO_TEST_CASE(disks_are_where_they_are_and_the_colour_is_their_speed) {
  Scene scene;
  scene.particles = 2;
  scene.width_over_diameter = 5;
  scene.length_over_width = 1;
  const State state{{{0.3, 0.8}, {0.02, 0.4}}, {{1, 0}, {0, 4}}};
  const Canvas canvas(scene, 3, Colouring::speed, state);
  BOOST_TEST(canvas.width() % 2 == 0);
  BOOST_TEST(canvas.height() == Canvas::tallest);
  const std::string pixels = canvas.draw(state);
  BOOST_REQUIRE(pixels.size() ==
                3 * static_cast<std::size_t>(canvas.width()) * static_cast<std::size_t>(canvas.height()));
  const auto at = [&](double x, double y) { return pixel(canvas, pixels, 1, x, y); };
  BOOST_TEST((at(0.3, 0.8) == colour_at(0.25)));
  BOOST_TEST((at(0.05, 0.4) == palette.back()));
  BOOST_TEST((at(0.98, 0.4) == palette.back()));  // beyond the end of the period
  BOOST_TEST((at(0.6, 0.6) == Rgb{255, 255, 255}));
  BOOST_TEST((at(0.3, 0.2) == Rgb{255, 255, 255}));  // y points upward
}

BOOST_AUTO_TEST_CASE(a_program_reads_all_that_is_written) {
  const test::TemporaryFolder folder;
  PipedProgram copy({"dd", "status=none", "of=" + (folder / "copy").string()});
  const std::string text(300'000, 'x');  // more than a pipe holds
  copy.write(text);
  copy.write("end");
  copy.finish();
  BOOST_TEST(read_text(folder / "copy") == text + "end");
}

BOOST_AUTO_TEST_CASE(a_program_that_fails_is_quoted) {
  BOOST_CHECK_THROW(PipedProgram({"no-such-program-of-gpf"}), StorageError);
  const auto quoted = [](const StorageError& error) { return error.why().find("full") != std::string::npos; };
  PipedProgram late({"sh", "-c", "cat > /dev/null; echo full >&2; exit 3"});
  late.write("x");
  BOOST_CHECK_EXCEPTION(late.finish(), StorageError, quoted);
  PipedProgram early({"sh", "-c", "echo full >&2; exit 3"});
  BOOST_CHECK_EXCEPTION(early.write(std::string(1'000'000, 'x')), StorageError, quoted);
}

BOOST_AUTO_TEST_SUITE_END()
