#include "verify/audit/trace.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "gpf/base/error.hpp"
#include "gpf/base/hash.hpp"
#include "gpf/event/engine.hpp"
#include "gpf/scene/scene_file.hpp"
#include "gpf/scene/start.hpp"

using namespace gpf;

namespace {

Scene small_channel() {
  return parse_scene(
             "[scene]\ngeometry = \"channel\"\nparticles = 60\narea_fraction = 0.3\nwidth_over_diameter = 8\n"
             "normal_restitution = 0.9\nwall_tangential_restitution = 0.5\nseed = 3\n[run]\nduration = 10\n",
             "small")
      .scene;
}

std::vector<EpochMark> marks_of(const Scene& scene, const std::optional<EngineState>& from, std::int64_t epochs) {
  std::vector<EpochMark> marks;
  trace_epochs(scene, from, epochs, [&](const EpochMark& mark) { marks.push_back(mark); });
  return marks;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(traces)

BOOST_AUTO_TEST_CASE(the_contacts_of_all_epochs_are_those_that_the_hash_is_taken_over) {
  const Scene scene = small_channel();
  const auto marks = marks_of(scene, {}, 4);
  BOOST_REQUIRE(marks.size() == 5U);
  BOOST_TEST(marks[0].contacts == 0U);
  TraceHash hash;
  std::uint64_t contacts = 0;
  for (std::int64_t epoch = 1; epoch <= 4; ++epoch) {
    for (const TracedContact& c : trace_contacts(scene, {}, epoch)) {
      hash.add(epoch - 1, c.time, c.first, c.second);
      ++contacts;
    }
    const EpochMark& mark = marks[static_cast<std::size_t>(epoch)];
    BOOST_TEST(mark.epoch == epoch);
    BOOST_TEST(mark.trace_hash == hash.value());
    BOOST_TEST(mark.contacts == contacts);
  }
  BOOST_TEST(contacts > 100U);
}

BOOST_AUTO_TEST_CASE(a_checkpoint_goes_on_with_the_same_marks_and_contacts) {
  const Scene scene = small_channel();
  Engine<> engine(scene, start_state(scene));
  engine.advance(2 * engine.epoch_length());
  const EngineState checkpoint = engine.checkpoint();
  const auto whole = marks_of(scene, {}, 4), rest = marks_of(scene, checkpoint, 2);
  BOOST_REQUIRE(rest.size() == 3U);
  for (std::size_t k = 0; k < rest.size(); ++k) BOOST_CHECK(rest[k] == whole[k + 2]);
  BOOST_CHECK(trace_contacts(scene, checkpoint, 4) == trace_contacts(scene, {}, 4));
  BOOST_CHECK_THROW(trace_contacts(scene, checkpoint, 2), InputError);
  BOOST_CHECK_THROW(trace_contacts(scene, {}, 0), InputError);
}

BOOST_AUTO_TEST_CASE(lines_read_back_to_the_same_bits) {
  const EpochMark mark{12, 0xfedcba9876543210U, 123456789012U, 7};
  const TracedContact contact{0.1 + 0.2, 5, -2, {-1.0 / 3, 5e-324, 0, -0.0}};
  const auto marks = parse_marks(text_of(mark) + "\n" + text_of(mark) + "\n");
  BOOST_REQUIRE(marks.size() == 2U);
  BOOST_CHECK(marks[1] == mark);
  const auto contacts = parse_contacts(text_of(contact) + "\n");
  BOOST_REQUIRE(contacts.size() == 1U);
  BOOST_CHECK(contacts[0] == contact);
  BOOST_TEST(std::signbit(contacts[0].velocity[3]));
}

BOOST_AUTO_TEST_CASE(other_lines_are_refused) {
  for (const char* text : {"1 2\n", "x 0 0 0\n", "1 00ff 3 00ff more\n"})
    BOOST_CHECK_THROW(parse_marks(text), InputError);
  for (const char* text : {"0.5 1 2 0 0 0\n", "0.5 1 2 0 0 0 zero\n", "0.5 1 2 0 0 0 0 0\n"})
    BOOST_CHECK_THROW(parse_contacts(text), InputError);
}

BOOST_AUTO_TEST_SUITE_END()
