// Which states are exported, and what tables hold of a record.
#include "verify/export/states.hpp"

#include <boost/test/unit_test.hpp>

#include "gpf/scene/scene_file.hpp"
#include "gpf/scene/start.hpp"
#include "verify/export/csv.hpp"
#include "verify/simulate.hpp"

using namespace gpf;

namespace {

const char* const scene_text =
    "[scene]\ngeometry = \"channel\"\nparticles = 100\narea_fraction = 0.2\nwidth_over_diameter = 15\n"
    "normal_restitution = 0.9\nwall_tangential_restitution = 0.9\n[run]\nstart_up = 0\nduration = 1\nbins = 4\n"
    "density_modes = 2\n";

std::size_t count(const std::string& text, char c) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), c));
}

}  // namespace

BOOST_AUTO_TEST_SUITE(exported_states)

BOOST_AUTO_TEST_CASE(a_state_that_is_kept_twice_is_exported_once) {
  ViewSource source;
  source.record.emplace();
  source.record->snapshots = {{1, {}}, {1, {}}, {2, {}}};
  const auto times = [&source] {
    std::vector<double> of;
    for (const Snapshot& state : kept_states(source)) of.push_back(state.time);
    return of;
  };
  source.record->time = 3;
  BOOST_TEST(times() == (std::vector<double>{1, 2, 3}), boost::test_tools::per_element());
  source.record->time = 2;
  BOOST_TEST(times() == (std::vector<double>{1, 2}), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(frames_are_simulated_when_they_are_asked_for) {
  const SceneFile file = parse_scene(scene_text, "test");
  const ViewSource source{"scene.toml", file.scene, file.run, {7, start_state(file.scene)}, {}};
  BOOST_TEST(ExportedStates(source, {.count = 0}).count() == 1U);
  const ExportedStates frames(source, {.count = 3, .interval = 0.5});
  BOOST_TEST(frames.count() == 3U);
  BOOST_TEST(frames.origin() == "scene.toml: simulated anew from time 7");
  std::vector<double> times;
  frames.show_all([&times](const Snapshot& state) { times.push_back(state.time); });
  BOOST_TEST(times == (std::vector<double>{7, 7.5, 8}), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_table_has_a_row_per_bin_and_its_numbers_read_back) {
  const Record record = *simulate(parse_scene(scene_text, "test"));
  const CsvTables tables = csv_tables(record);
  const MeasuredQuantities quantities = quantities_of(record);
  BOOST_TEST(count(tables.profiles, '\n') == 1 + 4U);
  BOOST_TEST(tables.profiles.find("\n1,0.125,") != std::string::npos);
  BOOST_TEST(tables.modes.starts_with("k,density_power_even,density_power_even_error,density_power_odd,"));
  BOOST_TEST(count(tables.modes, '\n') == 1 + 2U);
  BOOST_TEST(count(tables.modes, ',') == 3 * 6U);  // three shapes and their errors

  const std::size_t at = tables.scalars.find("\nmean_flow,") + 11;
  BOOST_TEST(std::stod(tables.scalars.substr(at)) == quantities.at("mean_flow").values.front().mean);
}

BOOST_AUTO_TEST_SUITE_END()
