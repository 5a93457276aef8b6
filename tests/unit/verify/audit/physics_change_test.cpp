#include "verify/audit/physics_change.hpp"

#include <boost/test/unit_test.hpp>

#include "gpf/base/error.hpp"

using namespace gpf;

BOOST_AUTO_TEST_SUITE(physics_change)

BOOST_AUTO_TEST_CASE(every_way_of_writing_a_class_is_understood) {
  for (const char* name : {"same physics", "same_physics", "same-physics", "Same Physics"})
    BOOST_CHECK(physics_change_named(name) == PhysicsChange::same_physics);
  BOOST_CHECK(physics_change_named("round-off") == PhysicsChange::roundoff);
  for (const auto change : {PhysicsChange::bitwise, PhysicsChange::roundoff, PhysicsChange::new_physics})
    BOOST_CHECK(physics_change_named(name_of(change)) == change);
  BOOST_CHECK_THROW(physics_change_named("harmless"), InputError);
  BOOST_CHECK_THROW(physics_change_named(""), InputError);
}

BOOST_AUTO_TEST_CASE(of_several_trailers_the_strongest_counts_and_of_none_bitwise) {
  BOOST_CHECK(strongest_declared("") == PhysicsChange::bitwise);
  BOOST_CHECK(strongest_declared("\n\n") == PhysicsChange::bitwise);
  BOOST_CHECK(strongest_declared("roundoff\n\n  new physics \nbitwise\n") == PhysicsChange::new_physics);
  BOOST_CHECK_THROW(strongest_declared("roundoff\nno idea\n"), InputError);
}

BOOST_AUTO_TEST_SUITE_END()
