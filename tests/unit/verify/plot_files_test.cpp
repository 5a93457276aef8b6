#include "verify/plot_files.hpp"

#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <limits>

#include "verify/csv.hpp"

BOOST_AUTO_TEST_SUITE(plot_files)

BOOST_AUTO_TEST_CASE(cells_that_would_break_a_line_are_quoted) {
  BOOST_TEST(gpf::csv_line({"a", "b,c", "\"d\"", "e\nf", ""}) == "a,\"b,c\",\"\"\"d\"\"\",\"e\nf\",\n");
}

BOOST_AUTO_TEST_CASE(every_number_of_every_series_is_there) {
  gpf::Plot plot{"title", "y/W", "U, (gW)^(1/2)"};
  plot.series = {{"measured", gpf::SeriesStyle::points, {0.5, 1}, {0.1, -1e-300}, {0.01, 0.02}},
                 {"band", gpf::SeriesStyle::band, {0}, {}, {}, {-1}, {1}},
                 {"", gpf::SeriesStyle::line, {1, 2}, {std::numeric_limits<double>::quiet_NaN(), 1.0 / 3}}};
  BOOST_TEST(gpf::plot_csv(plot) ==
             "series,style,y/W,\"U, (gW)^(1/2)\",error,lower,upper\n"
             "measured,points,0.5,0.1,0.01,,\n"
             "measured,points,1,-1e-300,0.02,,\n"
             "band,band,0,,,-1,1\n"
             ",line,1,,,,\n"
             ",line,2,0.3333333333333333,,,\n");
}

BOOST_AUTO_TEST_CASE(the_numbers_stand_beside_the_picture) {
  BOOST_TEST(gpf::data_file_of("claims/a.b.svg") == "claims/a.b.csv");
  BOOST_TEST(gpf::plot_markdown("a", "x.svg") == "![a](x.svg)\n\n[Data of this plot](x.csv)\n");
}

BOOST_AUTO_TEST_CASE(beside_every_plot_of_the_committed_reports_lie_its_numbers) {
  std::size_t plots = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(GPF_REPORTS)) {
    const std::filesystem::path& file = entry.path();
    // Drawings - states of disks, density fields - are called <claim>+<number>.
    if (file.extension() != ".svg" || file.stem().string().find('+') != std::string::npos) continue;
    BOOST_TEST(std::filesystem::exists(gpf::data_file_of(file.string())), "no numbers of " << file);
    ++plots;
  }
  BOOST_TEST(plots > 200U);
}

BOOST_AUTO_TEST_SUITE_END()
