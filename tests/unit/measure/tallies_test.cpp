#include "gpf/measure/tallies.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <set>

using namespace gpf;

BOOST_AUTO_TEST_CASE(every_place_of_a_row_has_one_name) {
  const TallyLayout layout(18);
  const auto labels = layout.labels();
  BOOST_TEST(labels.size() == layout.size());
  BOOST_TEST(std::set<std::string>(labels.begin(), labels.end()).size() == labels.size());
  BOOST_TEST(labels[layout.at(Tally::measured_time)] == "measured_time");
  BOOST_TEST(labels[layout.at(Tally::wall_loss, 1)] == "wall_loss[1]");
  BOOST_TEST(labels[layout.at(Tally::stress_yy, 17)] == "stress_yy[17]");
  BOOST_TEST(layout.at(Tally::stress_yy, 17) + 1 == layout.size());
}

BOOST_AUTO_TEST_CASE(density_modes_only_add_to_the_end_of_a_row) {
  const TallyLayout without(18), with(18, 4);
  const auto few = without.labels(), many = with.labels();
  BOOST_TEST(with.size() == without.size() + 3 * 4 + 5);
  BOOST_TEST(std::equal(few.begin(), few.end(), many.begin()));
  BOOST_TEST(many[with.at(Tally::mode_even)] == "mode_even[0]");
  BOOST_TEST(many[with.at(Tally::mode_odd, 3)] == "mode_odd[3]");
  BOOST_TEST(many[with.at(Tally::mode_noise_even)] == "mode_noise_even");
  BOOST_TEST(many.back() == "band_sin");
  BOOST_TEST(std::set<std::string>(many.begin(), many.end()).size() == many.size());
  BOOST_TEST(without.extent(Tally::mode_noise_even) == 0u);
  BOOST_TEST(TallyLayout(18, 1).labels()[with.at(Tally::mode_even)] == "mode_even[0]");
}
