// Methods as text.
#include "gpf/flow/method_setting.hpp"

#include <boost/test/unit_test.hpp>

#include "gpf/base/error.hpp"

using namespace gpf;

namespace {

std::string refusal(const char* text) {
  try {
    static_cast<void>(parse_method(text));
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

}  // namespace

BOOST_AUTO_TEST_SUITE(method_setting)

BOOST_AUTO_TEST_CASE(a_text_holds_every_number_of_its_method_and_reads_back) {
  BOOST_TEST(text_of({}) == "event_driven");
  BOOST_TEST(text_of(parse_method("soft_disks")) == "soft_disks contact=0.05 steps=50");
  BOOST_TEST(text_of(parse_method(" monte_carlo   particles=12 cells=8")) ==
             "monte_carlo cells=8 particles=12 step=0.1");
  BOOST_TEST(text_of(parse_method("monte_carlo along=1")) == "monte_carlo cells=40 particles=200 step=0.1");
  const MethodSetting along = parse_method("monte_carlo along=62 cells=31");
  BOOST_TEST(along.monte_carlo.cells_along == 62);
  BOOST_TEST(text_of(along) == "monte_carlo cells=31 particles=200 step=0.1 along=62");
  BOOST_TEST(text_of(parse_method(text_of(along))) == text_of(along));
  const MethodSetting soft = parse_method("soft_disks steps=20 contact=0.125");
  BOOST_TEST((soft.method == Method::soft_disks));
  BOOST_TEST(soft.steps == 20);
  BOOST_TEST(soft.contact == 0.125);
  for (const char* text : {"event_driven", "all_pairs", "soft_disks", "monte_carlo", "hydrodynamics"}) {
    const std::string full = text_of(parse_method(text));
    BOOST_TEST(full.starts_with(text));
    BOOST_TEST(text_of(parse_method(full)) == full);
  }
}

BOOST_AUTO_TEST_CASE(what_cannot_be_read_is_refused_with_what_there_is) {
  BOOST_TEST(refusal("").find("hydrodynamics") != std::string::npos);
  BOOST_TEST(refusal("molecular_dynamics").find("no method is called 'molecular_dynamics'") != std::string::npos);
  for (const char* bad : {"monte_carlo cells", "monte_carlo cells=", "monte_carlo cells=4x", "monte_carlo cells=4.5",
                          "monte_carlo contact=1", "monte_carlo =3", "monte_carlo along=1.5"})
    BOOST_TEST(refusal(bad).find("cells=40") != std::string::npos, bad);
  BOOST_TEST(refusal("event_driven cells=3").find("no numbers to set") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
