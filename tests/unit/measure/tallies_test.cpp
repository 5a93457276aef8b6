#include "gpf/measure/tallies.hpp"

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
