#include "verify/estimators/scene_values.hpp"

#include <boost/test/unit_test.hpp>

#include "gpf/base/error.hpp"
#include "unit/verify/estimators/made_record.hpp"

namespace gpf::test {

BOOST_AUTO_TEST_SUITE(scene_values)

/// Disk counts 10, 20, ... in bins 1, 2, ..., the replica's number added to the first.
Record counted(double extra, std::size_t blocks = 1) {
  return made_record(
      channel_text(0.2),
      [&](const SetTally& set) {
        for (int b = 0; b < 6; ++b) set(Tally::count, b, 10 * (b + 1) + (b == 0 ? extra : 0));
      },
      blocks);
}

BOOST_AUTO_TEST_CASE(totals_add_up_blocks) {
  const Record record = counted(0, 3);
  const std::vector<double> totals = totals_of(record);
  const TallyLayout layout(6);
  BOOST_TEST(totals.size() == layout.size());
  BOOST_TEST(totals[layout.at(Tally::samples)] == 3);
  BOOST_TEST(totals[layout.at(Tally::count, 5)] == 180);
}

BOOST_AUTO_TEST_CASE(one_value_per_replica_and_mirror_images_averaged) {
  const std::vector<Record> records{counted(0), counted(7)};
  const SceneValues scene("s", records);
  BOOST_TEST(scene.replicas() == 2u);
  BOOST_TEST(scene.half() == 3);
  // Area fraction of a bin = disks x area of a disk / (L/6), a third quantity by hand.
  const double unit = scene.scene().area_fraction() / 180 * 6;
  BOOST_TEST(scene.of("area_fraction", 0)[1] == 17 * unit, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(scene.mirrored("area_fraction", 0)[0] == 35 * unit, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(scene.mirrored("area_fraction", 1, Parity::odd)[0] == -15 * unit, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(scene.mean_profile("area_fraction")[0] == (35 + 38.5) / 2 * unit, boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(the_middle_bin_of_an_odd_number_is_its_own_image) {
  const std::string text =
      "[scene]\ngeometry = \"channel\"\nparticles = 180\nwidth_over_diameter = 12\n"
      "area_fraction = 0.2\nnormal_restitution = 0.9\nwall_tangential_restitution = 0.5\n"
      "[run]\nduration = 8\nbins = 5\n";
  const std::vector<Record> records{made_record(text, [](const SetTally& set) {
    for (int b = 0; b < 5; ++b) set(Tally::count, b, b);
  })};
  const SceneValues scene("s", records);
  BOOST_TEST(scene.half() == 3);
  BOOST_TEST(scene.mirrored("area_fraction", 2)[0] == scene.of("area_fraction", 2)[0]);
}

BOOST_AUTO_TEST_CASE(scenes_stand_by_area_fraction) {
  SceneRecords records;
  records["a"] = {made_record(channel_text(0.4), [](const SetTally&) {})};
  records["b"] = {made_record(channel_text(0.1), [](const SetTally&) {})};
  const std::vector<SceneValues> scenes = by_area_fraction(records);
  BOOST_TEST(scenes[0].name() == "b");
  BOOST_TEST(scenes[1].name() == "a");
}

BOOST_AUTO_TEST_CASE(points_carry_the_standard_error_over_replicas) {
  Series series;
  add_point(series, 0.5, {1, 3});  // deviation sqrt(2), error sqrt(2)/sqrt(2) = 1
  BOOST_TEST(series.x[0] == 0.5);
  BOOST_TEST(series.y[0] == 2);
  BOOST_TEST(series.yerr[0] == 1, boost::test_tools::tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(refuses_what_is_not_there) {
  const std::vector<Record> none, records{counted(0)};
  BOOST_CHECK_THROW(SceneValues("s", none), InputError);
  const SceneValues scene("s", records);
  BOOST_CHECK_THROW((void)scene.of("compressibility"), InputError);  // of periodic scenes only
  BOOST_CHECK_THROW((void)scene.of("area_fraction", 6), InputError);
  std::vector<Record> mixed{counted(0), counted(0)};
  mixed[1].scene.particles = 7;
  BOOST_CHECK_THROW(SceneValues("s", mixed), InputError);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace gpf::test
