// The page's text: nothing from outside in it that could run, nothing outside that it needs.
#include "verify/view/page.hpp"

#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>
#include <regex>

#include "gpf/scene/scene_file.hpp"
#include "gpf/scene/start.hpp"
#include "verify/simulate.hpp"
#include "verify/view/page_data.hpp"

using namespace gpf;

namespace {

const std::string hostile = "</script><script>alert(1)</script>@SCRIPT@<!-- \xff";

/// A record whose texts someone else has written.
ViewSource hostile_source() {
  const SceneFile file = parse_scene(
      "[scene]\ngeometry = \"channel\"\nparticles = 64\narea_fraction = 0.10\nwidth_over_diameter = 15\n"
      "normal_restitution = 1\nwall_tangential_restitution = 1\n[run]\nduration = 2\nbins = 3\ndensity_modes = 2\n",
      "test");
  ViewSource source;
  source.name = hostile;
  source.record = simulate(file);
  source.record->build = R"({"commit": "</script><b>", "</script>": ["<"]})";
  source.record->session = hostile;  // not even JSON
  source.scene = file.scene;
  source.run = file.run;
  source.start = {source.record->time, source.record->final_state};
  return source;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(page)

BOOST_AUTO_TEST_CASE(data_hold_no_tag_and_give_the_texts_back) {
  const ViewSource source = hostile_source();
  PackedFrames frames(source.scene, source.run.bins, source.run.density_modes);
  frames.add(source.start.state);
  const std::string text = page_data(source, frames, 0.5, 1);
  BOOST_TEST(text.find('<') == std::string::npos);
  const auto json = nlohmann::json::parse(text);
  BOOST_TEST(json.at("frames") == 1);
  BOOST_TEST(json.at("interval") == 0.5);
  BOOST_TEST(json.at("name").get<std::string>().starts_with("</script><script>alert(1)"));
  BOOST_TEST(json.at("record").at("mean_velocity").at("mean").size() == 3);
  BOOST_TEST(json.at("record").at("density_modes").size() == 3);
  BOOST_TEST(count(json.at("tables").dump(), "</script><b>") == 1);
}

BOOST_AUTO_TEST_CASE(a_page_is_whole_and_runs_its_own_scripts_only) {
  const ViewSource source = hostile_source();
  int shown = 0;
  const std::string page = view_page(source, {.count = 5, .interval = 0.1}, [&](int done) { shown = done; });
  BOOST_TEST(shown == 5);
  BOOST_TEST(count(page, "</script>") == 3);  // the data, uPlot, our own
  BOOST_TEST(count(page, "<script>alert") == 0);
  BOOST_TEST(count(page, "&lt;script&gt;alert") == 2);  // title and heading
  BOOST_TEST(!std::regex_search(page.substr(0, page.find("<script")), std::regex("(src|href)\\s*=|url\\(|@import")));
  BOOST_TEST(count(page, "default-src 'none'") == 1);
}

BOOST_AUTO_TEST_CASE(a_form_is_filled_once) {
  const auto text_of = [](std::string_view name) { return name == "A" ? std::string("@B@") : std::string(); };
  BOOST_TEST(filled("1 @A@ 2 @A@ 3 @", text_of) == "1 @B@ 2 @B@ 3 @");
  BOOST_TEST(html_text("<a b='c' d=\"e\">&") == "&lt;a b=&#39;c&#39; d=&quot;e&quot;&gt;&amp;");
}

BOOST_AUTO_TEST_SUITE_END()
