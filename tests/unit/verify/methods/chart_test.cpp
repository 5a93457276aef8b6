// The chart's plan, its points and their front.
#include "verify/methods/chart.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <fstream>

#include "gpf/base/error.hpp"
#include "gpf/io/atomic_file.hpp"
#include "unit/io/temporary_folder.hpp"
#include "verify/methods/chart_pages.hpp"

using namespace gpf;

namespace {

const std::string head =
    "title = \"T\"\nreplicas = 2\nreference_replicas = 2\n[scenes]\nchart = [\"a\"]\nevidence = [\"b\"]\n"
    "held_back = [\"c\"]\n";

std::string refusal(const std::string& text) {
  try {
    static_cast<void>(parse_chart_plan(text, "m.toml"));
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

ChartPoint point(const char* series, double cost, double error) {
  ChartPoint p;
  p.scene = "a", p.series = series, p.cpu_seconds = cost;
  p.misfits["mean_velocity"] = {error, 0, 0};
  return p;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(chart)

BOOST_AUTO_TEST_CASE(lists_of_factors_make_series) {
  const ChartPlan plan =
      parse_chart_plan(head +
                           "[[series]]\nmethod = \"event_driven\"\nof = \"both\"\nlengths = [0.25, 1]\n"
                           "tc = [10]\n[[series]]\nmethod = \"all_pairs\"\nscenes = [\"b\"]\n"
                           "steady_window = 3\n",
                       "m.toml");
  BOOST_REQUIRE(plan.series.size() == 3U);
  BOOST_TEST(plan.series[0].text() == "event_driven length x0.25 t_c x10");
  BOOST_TEST(plan.series[1].text() == "event_driven t_c x10");
  BOOST_TEST(plan.series[2].text() == "all_pairs window 3");
  BOOST_TEST((plan.series[0].scenes == std::vector<std::string>{"a", "b"}));
  BOOST_TEST((plan.series[2].scenes == std::vector<std::string>{"b"}));
}

BOOST_AUTO_TEST_CASE(plans_that_cannot_be_meant_are_refused) {
  BOOST_TEST(contains(refusal(head + "[[series]]\nmethod = \"event_driven\"\nscenes = [\"c\"]\n"), "held-back"));
  BOOST_TEST(contains(refusal(head + "[[series]]\nmethod = \"event_driven\"\n"), "one of the two"));
  BOOST_TEST(contains(refusal(head + "[[series]]\nmethod = \"magic\"\nof = \"both\"\n"), "magic"));
  BOOST_TEST(contains(refusal(head + "[[series]]\nmethod = \"event_driven\"\nof = \"none\"\n"), "both"));
  BOOST_TEST(
      contains(refusal(head + "[[series]]\nmethod = \"event_driven\"\nof = \"both\"\nlengths = [0]\n"), "lengths"));
  BOOST_TEST(contains(refusal("title = \"T\"\nreplicas = 1\n"), "replicas = 1"));
  std::string twice = head;
  twice.replace(twice.find("[\"c\"]"), 5, "[\"a\"]");
  BOOST_TEST(contains(refusal(twice), "held back and looked at"));
}

BOOST_AUTO_TEST_CASE(a_varied_scene_keeps_its_density) {
  SceneFile file = parse_scene(
      "[scene]\ngeometry = \"channel\"\nparticles = 40\nwidth_over_diameter = 10\nlength_over_width = 2\n"
      "normal_restitution = 0.9\nwall_tangential_restitution = 0.5\n[run]\nstart_up = 8\nduration = 16\n",
      "s.toml");
  ChartSeries series;
  series.particles = 0.5, series.length = 0.25, series.tc = 10;
  const SceneFile half = varied(file, series);
  BOOST_TEST(half.scene.particles == 20);
  BOOST_TEST(half.scene.area_fraction() == file.scene.area_fraction(), boost::test_tools::tolerance(1e-12));
  BOOST_TEST(half.scene.tc_time == 10 * file.scene.tc_time);
  BOOST_TEST(half.run.duration == 4);
  BOOST_TEST(half.run.start_up == 8);
  series.steady_window = 2;
  BOOST_TEST(varied(file, series).run.duration == 2);
  BOOST_TEST(varied(file, series).run.start_up == 0.25);
}

BOOST_AUTO_TEST_CASE(points_read_back_from_their_table) {
  std::vector<ChartPoint> points{point("event_driven", 2, 0.01), point("hydrodynamics cells=100", 0.01, 0.1)};
  points[0].parameters.particles = 900;
  points[0].parameters.wall_tangential_restitution = {0.1, 0.9};
  points[1].misfits["slip_velocity"] = {0.5, NAN, 0.25};
  points.push_back(point("monte_carlo", 0.5, 0));
  points.back().misfits.clear();
  points.back().failure = "too dense, it says";
  const auto back = points_in(csv_of(points), "m.csv");
  BOOST_REQUIRE(back.size() == 3U);
  BOOST_TEST(back[0].parameters.particles == 900);
  BOOST_TEST(back[0].parameters.wall_tangential_restitution[1] == 0.9);
  BOOST_TEST(back[1].misfits.at("slip_velocity").noise == 0.25);
  BOOST_TEST(std::isnan(back[1].misfits.at("slip_velocity").resolution));
  BOOST_TEST(back[2].failure == "too dense; it says");
  BOOST_TEST(back[2].misfits.empty());
  BOOST_TEST(csv_of(back) == csv_of(points));

  const std::string csv = csv_of(points);
  BOOST_CHECK_THROW(points_in("a,b\n", "m.csv"), InputError);
  BOOST_CHECK_THROW(points_in(csv + "a,b\n", "m.csv"), InputError);
  BOOST_CHECK_THROW(points_in(csv.substr(0, csv.size() - 1) + ",1\n", "m.csv"), InputError);
  std::string wrong = csv;
  wrong.replace(wrong.find("900"), 3, "9x0");
  BOOST_CHECK_THROW(points_in(wrong, "m.csv"), InputError);
}

BOOST_AUTO_TEST_CASE(the_front_is_what_nothing_beats) {
  const std::vector<ChartPoint> points{point("cheap", 1, 0.5), point("beaten", 2, 0.6), point("good", 3, 0.1),
                                       point("same", 3, 0.1), point("unknown", 0.1, NAN)};
  std::vector<const ChartPoint*> all;
  for (const ChartPoint& p : points) all.push_back(&p);
  BOOST_TEST((pareto_front(all, "mean_velocity") == std::vector<bool>{true, false, true, true, false}));
}

BOOST_AUTO_TEST_CASE(a_small_chart_from_beginning_to_end) {
  const test::TemporaryFolder folder;
  const auto reference = folder.path() / "reference";
  std::filesystem::create_directories(reference / "scenes");
  write_text_atomically(reference / "scenes" / "a.toml",
                        "[scene]\ngeometry = \"channel\"\nparticles = 60\nwidth_over_diameter = 10\n"
                        "length_over_width = 1.2\nnormal_restitution = 0.95\nwall_tangential_restitution = 0.5\n"
                        "[run]\nstart_up = 10\nduration = 20\nbins = 5\n");
  ChartPlan plan = parse_chart_plan(
      "title = \"T\"\nreplicas = 2\nreference_replicas = 2\n[scenes]\nchart = [\"a\"]\nevidence = [\"a\"]\n"
      "held_back = [\"c\"]\n[[series]]\nmethod = \"hydrodynamics\"\nof = \"chart\"\n[[series]]\nmethod = "
      "\"event_driven\"\nof = \"chart\"\nlengths = [0.25]\n[[series]]\nmethod = \"monte_carlo cells=2\"\nof = "
      "\"chart\"\n"
      "[[series]]\nmethod = \"all_pairs\"\nof = \"chart\"\nsteady_window = 1\n",
      "m.toml");
  plan.evidence.clear();
  const RecordStore records(folder.path() / "records", Trust::same_version);
  const MethodStore store(folder.path() / "records" / "methods");
  const auto points = chart_points(plan, reference, records, store, 1, nullptr);
  BOOST_REQUIRE(points.size() == 5U);
  BOOST_TEST(points[0].misfits.at("mean_velocity").bias < 0.5);
  BOOST_TEST(points[0].misfits.at("mean_velocity").noise == 0);
  BOOST_TEST(points[0].replicas == 1);
  BOOST_TEST(points[1].misfits.at("mean_velocity").noise > 0);
  BOOST_TEST(points[1].run_length == 15);
  BOOST_TEST(contains(points[2].failure, "less than 4 cells"));
  BOOST_TEST(points[2].misfits.empty());
  BOOST_TEST(points[3].run_length == 11);
  // The references, as runs of the engine.
  BOOST_TEST(points[4].series == "event_driven");
  BOOST_TEST(points[4].run_length == 30);
  BOOST_TEST(points[4].misfits.at("mean_velocity").bias == 0);
  BOOST_TEST(points[4].misfits.at("mean_velocity").noise > 0);

  // Nothing is run twice: the times are those of the first time.
  const auto again = chart_points(plan, reference, records, store, 1, nullptr);
  BOOST_TEST(csv_of(again) == csv_of(points));
  // A damaged result is made anew: one that is cut off, and one in which a profile has lost its end.
  for (const auto& entry : std::filesystem::directory_iterator(folder.path() / "records" / "methods")) {
    std::string text = read_text(entry.path());
    const auto at = text.find("\"mean_velocity\"");
    if (at == std::string::npos) continue;
    const auto comma = text.find(',', at), end = text.find(']', at);
    text.erase(comma, end - comma);
    write_text_atomically(entry.path(), text);
  }
  BOOST_TEST(chart_points(plan, reference, records, store, 1, nullptr)[1].misfits.at("mean_velocity").noise ==
             points[1].misfits.at("mean_velocity").noise);
  for (const auto& entry : std::filesystem::directory_iterator(folder.path() / "records" / "methods"))
    std::ofstream(entry.path()) << "{\"identity\": 3";
  BOOST_TEST(chart_points(plan, reference, records, store, 1, nullptr)[1].misfits.at("mean_velocity").noise ==
             points[1].misfits.at("mean_velocity").noise);

  write_chart_page(plan, points, folder.path() / "page");
  const std::string page = read_text(folder.path() / "page" / "methods.md");
  BOOST_TEST(contains(page, "gave up: less than 4 cells"));
  BOOST_TEST(std::filesystem::exists(folder.path() / "page" / "methods" / "a-mean_velocity.svg"));
  BOOST_TEST(std::filesystem::exists(folder.path() / "page" / "methods" / "a-mean_velocity.csv"));
}

/// When it fails: `gpf chart --redraw`, and read what has changed.
BOOST_AUTO_TEST_CASE(the_committed_page_is_that_of_the_committed_points) {
  const std::filesystem::path reference = GPF_REFERENCE, reports = GPF_REPORTS;
  const test::TemporaryFolder folder;
  write_chart_page(load_chart_plan(reference / "methods.toml"),
                   points_in(read_text(reference / "methods.csv"), "methods.csv"), folder.path());
  BOOST_TEST((read_text(folder.path() / "methods.md") == read_text(reports / "methods.md")));
  std::size_t plots = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path() / "methods")) {
    BOOST_TEST(std::filesystem::exists(reports / "methods" / entry.path().filename()), entry.path().filename());
    ++plots;
  }
  BOOST_TEST(plots == 44U);  // two for each of 22
}

BOOST_AUTO_TEST_SUITE_END()
