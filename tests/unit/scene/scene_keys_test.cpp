#include "gpf/scene/scene_keys.hpp"

#include <fmt/format.h>

#include <boost/test/unit_test.hpp>
#include <set>

#include "scene_text.hpp"

using namespace gpf;
using namespace gpf::test;

namespace {

/// The channel text with `key` = `value` on the first line of its table.
std::string text_with(const SceneKey& key, const std::string& value) {
  std::string text = channel_text;
  const auto start = text.find(fmt::format("\n{} = ", key.name));
  if (start != std::string::npos) text.erase(start, text.find('\n', start + 1) - start);
  return with(text, fmt::format("[{}]", key.table), fmt::format("[{}]\n{} = {}", key.table, key.name, value));
}

/// Where text_with puts the value.
std::string place_of(const SceneKey& key) {
  return fmt::format("{}:{}", key.table == "scene" ? 2 : 9, key.name.size() + 4);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(scene_keys_test)

BOOST_AUTO_TEST_CASE(the_keys_are_those_of_the_specification) {
  std::set<std::string> scene, run;
  for (const SceneKey& key : scene_keys()) (key.table == "scene" ? scene : run).emplace(key.name);
  const std::set<std::string> wanted_scene{"geometry",
                                           "particles",
                                           "area_fraction",
                                           "width_over_diameter",
                                           "length_over_width",
                                           "normal_restitution",
                                           "wall_normal_restitution",
                                           "wall_tangential_restitution",
                                           "tc_time",
                                           "gravity",
                                           "lattice",
                                           "seed"};
  const std::set<std::string> wanted_run{"start_up", "duration", "collisions_per_particle", "sample_interval",
                                         "bins",     "detail",   "density_modes",           "snapshots"};
  BOOST_TEST((scene == wanted_scene));
  BOOST_TEST((run == wanted_run));
  BOOST_TEST(scene_keys().size() == 20u);
}

BOOST_AUTO_TEST_CASE(the_help_says_all_about_every_key) {
  const std::string help = scene_key_help();
  BOOST_TEST(help.find("[scene]\n") == 0u);
  BOOST_TEST(help.find("\n[run]\n") != std::string::npos);
  for (const SceneKey& key : scene_keys())
    for (const std::string& part :
         {std::string(key.name), key.range(), std::string(key.meaning), std::string(key.otherwise)}) {
      BOOST_TEST(!part.empty());
      BOOST_TEST(help.find(part) != std::string::npos, key.name << ": the help lacks '" << part << "'");
    }
}

BOOST_AUTO_TEST_CASE(ranges_are_written_as_they_are_meant) {
  const auto range_of = [](std::string_view name) {
    for (const SceneKey& key : scene_keys())
      if (key.name == name) return key.range();
    return std::string();
  };
  BOOST_TEST(range_of("geometry") == "\"channel\" | \"periodic\"");
  BOOST_TEST(range_of("particles") == "1 ... 10000000");
  BOOST_TEST(range_of("normal_restitution") == "[0, 1]");
  BOOST_TEST(range_of("wall_tangential_restitution") == "[-1, 1]");
  BOOST_TEST(range_of("area_fraction") == "(0, 0.9068996821]");
  BOOST_TEST(range_of("seed") == "0 ... 2^63 - 1");
}

// The table is what the parser enforces: for every number both ends of the range, and the same message grammar.
BOOST_AUTO_TEST_CASE(every_number_is_refused_outside_its_range) {
  for (const SceneKey& key : scene_keys()) {
    if (key.kind == KeyKind::word) continue;
    const std::string name(key.name), at = place_of(key);
    const bool integer = key.kind == KeyKind::integer;
    const std::string below = integer ? fmt::format("{:.0f}", key.least - 1) : fmt::format("{:.17g}", key.least - 1e-3);
    BOOST_TEST_CONTEXT(name) {
      check_refused(text_with(key, below), at, {name, "out of range", key.range(), key.range_reason});
      if (name != "seed") {
        const std::string above =
            integer ? fmt::format("{:.0f}", key.most + 1) : fmt::format("{:.17g}", key.most * 1.001);
        check_refused(text_with(key, above), at, {name, "out of range", key.range(), key.range_reason});
      }
      if (key.least_excluded) check_refused(text_with(key, "0"), at, {name, "out of range", key.range()});
    }
  }
}

BOOST_AUTO_TEST_CASE(every_key_is_refused_in_a_wrong_type) {
  for (const SceneKey& key : scene_keys()) {
    const std::string name(key.name), at = place_of(key);
    BOOST_TEST_CONTEXT(name) {
      check_refused(text_with(key, "true"), at, {name + " is true or false", "it must be", "write"});
      check_refused(text_with(key, "1979-05-27"), at, {name + " is a date or time"});
      check_refused(text_with(key, "{ a = 1 }"), at, {name + " is a table"});
      if (key.kind != KeyKind::word) check_refused(text_with(key, "\"1\""), at, {name + " is a string"});
      if (key.kind == KeyKind::word) check_refused(text_with(key, "1"), at, {name + " is an integer"});
      if (key.kind == KeyKind::integer)
        check_refused(text_with(key, "2.0"), at, {name + " is a real number", "without a point"});
      if (key.kind == KeyKind::real) check_refused(text_with(key, "[1]"), at, {name + " is an array"});
      if (key.kind != KeyKind::word && key.kind != KeyKind::integer)
        for (const std::string value : {"nan", "inf", "-inf"})
          check_refused(text_with(key, value), at,
                        {name, value == "nan" ? "nan" : "inf", "not a finite number", key.range()});
    }
  }
}

BOOST_AUTO_TEST_CASE(a_misspelt_key_is_told_the_nearest_one) {
  for (const SceneKey& key : scene_keys()) {
    const std::string misspelt = fmt::format("{}q{}", key.name.substr(0, 2), key.name.substr(2));
    const std::string text =
        with(channel_text, fmt::format("[{}]", key.table), fmt::format("[{}]\n{} = 1", key.table, misspelt));
    check_refused(
        text, key.table == "scene" ? "2:1" : "9:1",
        {fmt::format("unknown key '{}' in [{}]", misspelt, key.table), fmt::format("did you mean '{}'?", key.name)});
  }
}

BOOST_AUTO_TEST_SUITE_END()
