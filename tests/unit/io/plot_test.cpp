#include "gpf/io/plot.hpp"

#include <boost/test/unit_test.hpp>
#include <limits>

#include "gpf/base/error.hpp"
#include "gpf/io/atomic_file.hpp"
#include "gpf/io/subprocess.hpp"
#include "unit/io/environment.hpp"
#include "unit/io/temporary_folder.hpp"

namespace {

using gpf::InputError;
using gpf::Plot;
using gpf::Series;
using gpf::SeriesStyle;
using gpf::StorageError;
using gpf::test::TemporaryFolder;

const double nan = std::numeric_limits<double>::quiet_NaN();

Plot sample() {
  Plot plot{.title = "Mean velocity", .xlabel = "y/W", .ylabel = "U"};
  plot.series.push_back({.label = "points", .x = {0, 1, 2}, .y = {1, 2, 3}, .yerr = {.1, .2, nan}});
  plot.series.push_back({.label = "line", .style = SeriesStyle::line, .x = {0, 1, 2, 3}, .y = {1, nan, 2, 3}});
  plot.series.push_back(
      {.label = "band", .style = SeriesStyle::band, .x = {0, 1}, .y = {1, 2}, .lower = {0, 1}, .upper = {2, 3}});
  return plot;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++n;
  return n;
}

BOOST_AUTO_TEST_SUITE(plot)

BOOST_AUTO_TEST_CASE(picture_is_complete_and_reproducible) {
  const TemporaryFolder folder;
  gpf::write_svg(sample(), folder / "a.svg");
  gpf::write_svg(sample(), folder / "b.svg");
  const std::string svg = gpf::read_text(folder / "a.svg");
  BOOST_TEST((svg == gpf::read_text(folder / "b.svg")));
  for (const char* const text : {"Mean velocity", "y/W", ">points<", ">line<", ">band<"}) {
    BOOST_TEST(count(svg, text) >= 1, text);
  }
  BOOST_TEST(folder.names() == (std::vector<std::string>{"a.svg", "b.svg"}));
}

BOOST_AUTO_TEST_CASE(data_stand_in_the_script_to_the_last_bit) {
  Plot plot;
  plot.series.push_back({.x = {0.1, 1e-300}, .y = {1. / 3, -7}});
  const std::string script = gpf::gnuplot_script(plot);
  BOOST_TEST(script.find("0.1 0.3333333333333333\n1e-300 -7\n") != std::string::npos, script);
}

BOOST_AUTO_TEST_CASE(values_that_cannot_be_drawn_are_left_out) {
  Plot plot;
  plot.series.push_back({.x = {1, 2, nan, 4}, .y = {1, nan, 3, 4}});
  BOOST_TEST(gpf::gnuplot_script(plot).find("<< END\n1 1\n4 4\nEND") != std::string::npos);
  plot.series.front().style = SeriesStyle::line;  // a line must not bridge the gap
  BOOST_TEST(gpf::gnuplot_script(plot).find("<< END\n1 1\n\n4 4\nEND") != std::string::npos);
  plot.series.front().y = {-1, 0, 1, 2};
  plot.logy = true;
  BOOST_TEST(gpf::gnuplot_script(plot).find("<< END\n4 2\nEND") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(bars_below_zero_reach_the_bottom_of_a_logarithmic_axis) {
  Plot plot{.logy = true};
  plot.series.push_back({.x = {1, 2}, .y = {5, 1}, .yerr = {1, 2}});
  BOOST_TEST(gpf::gnuplot_script(plot).find("1 5 4 6\n2 1 0.1 3\n") != std::string::npos);
  plot.yrange = {0.5, 10};
  BOOST_TEST(gpf::gnuplot_script(plot).find("2 1 0.5 3\n") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(no_text_can_run_a_command) {
  const TemporaryFolder folder;
  const std::filesystem::path witness = folder / "witness";
  const std::string run = "touch " + witness.string();
  const std::string calls = "system('" + run + "')";
  for (const std::string& text :
       {"`" + run + "`", "'.`" + run + "`.'", "' . " + calls + " . '", "'\n" + calls + "\n'", "\"; " + calls + " #",
        "x\\'\n!" + run, "\r\n!" + run + "\r\n", "@run $(" + run + ") ${run}", "\\\n!" + run, "'; !" + run + "; '",
        std::string("nul\0", 4) + "'\n!" + run, "END\n!" + run, "\xff'\n!" + run, "\xc2'" + calls + "'"}) {
    Plot plot = sample();
    plot.title = plot.xlabel = plot.ylabel = text;
    for (Series& series : plot.series) series.label = text;
    gpf::write_svg(plot, folder / "a.svg");
    BOOST_TEST(!std::filesystem::exists(witness), text);
  }
  // The witness is worth something: as a command of its own the text does run.
  gpf::run_program({"gnuplot", "-d"}, "x = " + calls + "\n");
  BOOST_TEST(std::filesystem::exists(witness));
}

BOOST_AUTO_TEST_CASE(texts_are_shown_as_they_are) {
  const TemporaryFolder folder;
  Plot plot = sample();
  plot.title = "it's\x01\ta_b^2 {/Symbol x} <b> & \"q\" $x `y` \\n %g \xce\xbd \xef\xbf\xbe";
  plot.series.front().label = "U_0 & <V> ]]>]]>";
  gpf::write_svg(plot, folder / "a.svg");
  const std::string svg = gpf::read_text(folder / "a.svg");
  // Read back by an XML parser: the text survives as it was, but for control characters, U+FFFE and ]]>, which XML does
  // not have.
  const auto parsed = gpf::run_program({"python3", "-c",
                                        "import sys, xml.etree.ElementTree as tree\n"
                                        "for e in tree.parse(sys.stdin).iter():\n"
                                        "  sys.stdout.buffer.write(((e.text or '') + '\\n').encode())"},
                                       svg);
  BOOST_TEST(parsed.exit_status == 0, parsed.errors);
  BOOST_TEST(count(parsed.output, "it's  a_b^2 {/Symbol x} <b> & \"q\" $x `y` \\n %g \xce\xbd \xef\xbf\xbd\n") == 1,
             parsed.output);
  BOOST_TEST(count(parsed.output, "U_0 & <V> ]] >]] >\n") == 2);  // drawn, and as the name of the group of points
}

BOOST_AUTO_TEST_CASE(very_long_texts_and_many_points) {
  const TemporaryFolder folder;
  Plot plot = sample();
  plot.title = plot.series.front().label = std::string(20000, 'W');
  Series long_one{.label = "many", .style = SeriesStyle::line};
  for (int i = 0; i < 20000; ++i) {
    long_one.x.push_back(i);
    long_one.y.push_back(i % 7);
  }
  plot.series.push_back(long_one);
  gpf::write_svg(plot, folder / "a.svg");
  BOOST_TEST(gpf::read_text(folder / "a.svg").ends_with("</svg>\n\n"));
}

/// The message of the error that write_svg throws, empty when it succeeds.
std::string write_error(const Plot& plot, const std::filesystem::path& path) {
  try {
    gpf::write_svg(plot, path);
  } catch (const gpf::Error& error) {
    return error.what();
  }
  return "";
}

BOOST_AUTO_TEST_CASE(extreme_data) {
  const TemporaryFolder folder;
  for (const std::vector<double>& y :
       {std::vector<double>{5}, {5, 5}, {1e-300, 1e300}, {-1e307, 1e307}, {5e-324, 1e-307}}) {
    for (const bool logarithmic : {false, true}) {
      Plot plot{.logx = logarithmic, .logy = logarithmic};
      plot.series.push_back({.x = std::vector<double>(y.size(), 2), .y = y});
      BOOST_TEST_CONTEXT(gpf::gnuplot_script(plot)) { BOOST_TEST(write_error(plot, folder / "a.svg") == ""); }
    }
  }
}

BOOST_AUTO_TEST_CASE(plots_that_make_no_sense_are_input_errors) {
  Plot plot;
  BOOST_CHECK_THROW(gpf::gnuplot_script(plot), InputError);
  plot.series.push_back({.x = {1}, .y = {nan}});
  BOOST_CHECK_THROW(gpf::gnuplot_script(plot), InputError);
  plot.series.front().y = {1, 2};
  BOOST_CHECK_THROW(gpf::gnuplot_script(plot), InputError);
  plot.series.front() = {.style = SeriesStyle::band, .x = {1}, .lower = {1}};
  BOOST_CHECK_THROW(gpf::gnuplot_script(plot), InputError);
  for (const auto& range : {std::pair{1., 1.}, {2., 1.}, {nan, 1.}}) {
    plot = sample();
    plot.xrange = range;
    BOOST_CHECK_THROW(gpf::gnuplot_script(plot), InputError);
  }
  plot.xrange = {0, 1};
  BOOST_CHECK_NO_THROW(gpf::gnuplot_script(plot));
  plot.logx = true;
  BOOST_CHECK_THROW(gpf::gnuplot_script(plot), InputError);
}

BOOST_AUTO_TEST_CASE(missing_or_failing_gnuplot_is_a_storage_error) {
  const TemporaryFolder folder;
  {
    const gpf::test::ScopedVariable nowhere("PATH", "/nonexistent");
    BOOST_CHECK_EXCEPTION(gpf::write_svg(sample(), folder / "a.svg"), StorageError, [](const StorageError& error) {
      return error.problem().find("gnuplot") != std::string::npos && error.remedy().find("install") == 0;
    });
  }
  for (const char* const impostor : {"#!/bin/sh\nexit 4\n", "#!/bin/sh\necho '<svg>'\n"}) {
    gpf::write_text_atomically(folder / "gnuplot", impostor);
    std::filesystem::permissions(folder / "gnuplot", std::filesystem::perms::owner_all);
    const gpf::test::ScopedVariable here("PATH", folder.path().string());
    BOOST_CHECK_THROW(gpf::write_svg(sample(), folder / "a.svg"), StorageError);
  }
  BOOST_TEST(folder.names() == std::vector<std::string>{"gnuplot"});
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
