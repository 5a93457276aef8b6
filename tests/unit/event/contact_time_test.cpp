// Contact times against closed forms and long double; grazing, overlap, symmetry and lanes to the bit.
#include "gpf/event/contact_time.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstring>

#include "gpf/base/random.hpp"
#include "gpf/event/position_grid.hpp"

using namespace gpf;

namespace {

constexpr double d = 0.25;
const ContactTime contact_time(d);

bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

double contact(const Flight& a, const Flight& b, const ContactTime& rule = contact_time) {
  return rule.contact(rule.encounter(a, b, 0, 0), a.time, b.time);
}

/// Random flights on a grid; `reach` is the side of the box, and times differ.
Flight random_flight(std::uint64_t k, double reach) {
  const PositionGrid grid(reach, 1);
  const Vec2 r = gaussian_pair(11, k), v = gaussian_pair(12, k), t = gaussian_pair(13, k);
  return {grid.round(std::fmod(r.x, reach)), grid.round(std::fmod(r.y, reach)), v.x, v.y, std::abs(t.x)};
}

/// Impact parameter and contact time since the later of the two times, in long double, of a pair on collision course.
struct Exact {
  long double distance, speed, impact, time;
};

Exact exact(const Flight& a, const Flight& b, double diameter) {
  using Long = long double;
  const Long later = std::max(a.time, b.time);
  const Long rx = Long{b.x} + Long{b.vx} * (later - b.time) - Long{a.x} - Long{a.vx} * (later - a.time);
  const Long ry = Long{b.y} + Long{b.vy} * (later - b.time) - Long{a.y} - Long{a.vy} * (later - a.time);
  const Long ux = Long{b.vx} - a.vx, uy = Long{b.vy} - a.vy;
  const Long u2 = ux * ux + uy * uy, moment = rx * uy - ry * ux;
  const Long half_chord2 = Long{diameter} * diameter - moment * moment / u2;
  const Long time = half_chord2 > 0 ? (-(rx * ux + ry * uy) - std::sqrt(u2 * half_chord2)) / u2 : -1;
  return {std::sqrt(rx * rx + ry * ry), std::sqrt(u2), std::abs(moment) / std::sqrt(u2), time};
}

}  // namespace

BOOST_AUTO_TEST_SUITE(contact_times)

BOOST_AUTO_TEST_CASE(head_on_by_hand) {
  // 1.25 apart, contact at .25, closing at 2: half a unit of time.
  const Flight a{0, 0, 1, 0, 0}, b{1.25, 0, -1, 0, 0};
  BOOST_TEST(contact_time.encounter(a, b, 0, 0).meet());
  BOOST_TEST(contact(a, b) == 0.5);
}

BOOST_AUTO_TEST_CASE(oblique_by_hand) {
  // Impact parameter .15 = 3/5 d, so the centres are 4/5 d = .2 apart along the flight at contact: (1.2 - .2)/4.
  const Flight a{0, 0, 0, 0, 0}, b{0.15, 1.2, 0, -4, 0};
  BOOST_TEST(contact(a, b) == 0.25, boost::test_tools::tolerance(4e-16));
}

BOOST_AUTO_TEST_CASE(disks_at_different_times_are_brought_to_the_later_one) {
  // As head_on_by_hand, but a was last seen 1/4 earlier, 1/4 further left, and b half a unit later, further on.
  const Flight a{-0.25, 0, 1, 0, 3.75}, b{0.75, 0, -1, 0, 4.5};
  BOOST_TEST(contact(a, b) == 4.5);
  BOOST_TEST(contact(b, a) == 4.5);
  const Flight early{0, 0, 1, 0, 4}, late{1, 0, -1, 0, 4.125};
  BOOST_TEST(contact(early, late) == 4.4375);
}

BOOST_AUTO_TEST_CASE(disks_that_part_or_rest_do_not_meet) {
  const Flight a{0, 0, 0, 0, 0};
  BOOST_TEST(!contact_time.encounter(a, Flight{1, 0, 1, 0, 0}, 0, 0).meet());
  BOOST_TEST(!contact_time.encounter(a, Flight{1, 0, 0, 0, 0}, 0, 0).meet());
  BOOST_TEST(!contact_time.encounter(a, Flight{1, 0, 0, 3, 0}, 0, 0).meet());  // abreast
  BOOST_TEST(!contact_time.encounter(a, Flight{1, 0.5, -1, 0, 0}, 0, 0).meet());
  BOOST_TEST(!contact_time.encounter(a, a, 0, 0).meet());  // a disk and itself
}

BOOST_AUTO_TEST_CASE(grazing_is_no_contact_and_a_hair_closer_is_one) {
  const Flight a{0, 0, 0, 0, 0};
  for (const double side : {-1.0, 1.0}) {
    const Flight grazing{4, side * d, -1, 0, 0}, closer{4, side * (d - 0x1p-50), -1, 0, 0};
    BOOST_TEST(contact_time.encounter(a, grazing, 0, 0).discriminant == 0);
    BOOST_TEST(!contact_time.encounter(a, grazing, 0, 0).meet());
    BOOST_TEST(contact_time.encounter(a, closer, 0, 0).meet());
    // Half the chord is sqrt(2 d 2^-50) = 2.1e-8; the sagitta 2^-50 itself is exact here.
    BOOST_TEST(contact(a, closer) == 4 - std::sqrt(2 * d * 0x1p-50), boost::test_tools::tolerance(1e-15));
  }
}

BOOST_AUTO_TEST_CASE(touching_disks_that_approach_meet_at_once) {
  const Flight a{0, 0, 0, 0, 2}, b{d, 0, -1, 0, 2};
  BOOST_TEST(contact(a, b) == 2);
  BOOST_TEST(!contact_time.encounter(a, Flight{d, 0, 1, 0, 2}, 0, 0).meet());
  BOOST_TEST(!contact_time.encounter(a, Flight{d, 0, 0, 1, 2}, 0, 0).meet());  // rolling past
}

BOOST_AUTO_TEST_CASE(disks_inside_each_other_meet_at_once_if_they_approach) {
  const Flight a{0, 0, 0, 0, 2};
  for (const double depth : {0x1p-52, 1e-10, 0.1, 0.2}) {
    BOOST_TEST(contact_time.encounter(a, Flight{d - depth, 0, -1, 0, 2}, 0, 0).meet());
    BOOST_TEST(contact(a, Flight{d - depth, 0, -1, 0, 2}) == 2);
    BOOST_TEST(!contact_time.encounter(a, Flight{d - depth, 0, 1, 0, 2}, 0, 0).meet());
  }
}

BOOST_AUTO_TEST_CASE(near_and_far_pairs_against_long_double) {
  // Both cross product and velocities are rounded to a few epsilon; an impact parameter b is then off by epsilon r, and
  // the time by epsilon (r/u)(1 + b/sqrt(d^2 - b^2)). Times before the later of the two flights add epsilon of them.
  constexpr double epsilon = 0x1p-53;
  int met = 0;
  for (const double diameter : {0.25, 0.03, 0.001})
    for (const double reach : {0.5, 2.0, 14.0}) {
      const ContactTime rule(diameter);
      for (std::uint64_t k = 0; k < 20000; ++k) {
        const Flight a = random_flight(2 * k, reach);
        Flight b = random_flight(2 * k + 1, reach);
        // Aim b at a, off its centre by up to 1.1 diameters, so that small disks meet too.
        const double later = std::max(a.time, b.time), impact = 1.1 * diameter * std::sin(static_cast<double>(k));
        b.time = later;
        const Vec2 r{b.x - (a.x + a.vx * (later - a.time)), b.y - (a.y + a.vy * (later - a.time))};
        const double distance = std::sqrt(dot(r, r)), speed = std::sqrt(b.vx * b.vx + b.vy * b.vy);
        if (distance < 1.2 * diameter) continue;
        const Vec2 n = (1 / distance) * r;
        b.vx = a.vx - speed * n.x + speed * impact / distance * n.y;
        b.vy = a.vy - speed * n.y - speed * impact / distance * n.x;
        const Exact truth = exact(a, b, diameter);
        const bool meet = rule.encounter(a, b, 0, 0).meet();
        const long double moved = std::abs(a.vx) + std::abs(a.vy) + std::abs(b.vx) + std::abs(b.vy);
        const long double off = 8 * epsilon * (reach + truth.distance * (1 + moved / truth.speed));
        if (std::abs(truth.impact - static_cast<long double>(diameter)) < off) continue;  // grazing: either answer
        BOOST_REQUIRE(meet == (truth.impact < static_cast<long double>(diameter)));
        if (!meet) continue;
        ++met;
        const long double half_chord =
            std::sqrt(static_cast<long double>(diameter) * diameter - truth.impact * truth.impact);
        const long double bound = off / truth.speed * (1 + truth.impact / half_chord) +
                                  4 * epsilon * (static_cast<long double>(later) + truth.time);
        const long double error = std::abs(contact(a, b, rule) - (later + truth.time));
        BOOST_REQUIRE(error <= bound);
      }
    }
  BOOST_TEST(met > 100000);
}

BOOST_AUTO_TEST_CASE(who_is_named_first_does_not_matter_to_the_bit) {
  for (std::uint64_t k = 0; k < 20000; ++k) {
    const Flight a = random_flight(2 * k, 2), b = random_flight(2 * k + 1, 2);
    const double shift_x = k % 3 == 0 ? 0 : 1.3, shift_y = k % 2 == 0 ? 0 : -1;
    const Encounter<double> e = contact_time.encounter(a, b, shift_x, shift_y);
    const Encounter<double> f = contact_time.encounter(b, a, -shift_x, -shift_y);
    BOOST_REQUIRE(same_bits(e.gap, f.gap));
    BOOST_REQUIRE(same_bits(e.approach, f.approach));
    BOOST_REQUIRE(same_bits(e.discriminant, f.discriminant));
    if (!e.meet()) continue;
    BOOST_REQUIRE(same_bits(contact_time.contact(e, a.time, b.time), contact_time.contact(f, b.time, a.time)));
  }
}

BOOST_AUTO_TEST_CASE(a_disk_known_to_be_the_latest_gets_the_same_bits) {
  for (std::uint64_t k = 0; k < 20000; ++k) {
    Flight a = random_flight(2 * k, 2), b = random_flight(2 * k + 1, 2);
    a.time = k % 5 == 0 ? b.time : std::max(a.time, b.time);
    const Encounter<double> e = contact_time.encounter(a, b, 1.3, -1);
    const Encounter<double> f = contact_time.encounter<true>(a, b, 1.3, -1);
    BOOST_REQUIRE(same_bits(e.gap, f.gap));
    BOOST_REQUIRE(same_bits(e.approach, f.approach));
    BOOST_REQUIRE(same_bits(e.discriminant, f.discriminant));
  }
}

BOOST_AUTO_TEST_CASE(mirrored_pairs_meet_at_the_same_time_to_the_bit) {
  for (std::uint64_t k = 0; k < 20000; ++k) {
    Flight a = random_flight(2 * k, 2), b = random_flight(2 * k + 1, 2);
    const Encounter<double> e = contact_time.encounter(a, b, 0, 0);
    for (Flight* f : {&a, &b}) f->y = 1 - f->y, f->vy = -f->vy;
    const Encounter<double> mirrored = contact_time.encounter(a, b, 0, 0);
    BOOST_REQUIRE(same_bits(e.approach, mirrored.approach));
    BOOST_REQUIRE(same_bits(e.discriminant, mirrored.discriminant));
    if (e.meet())
      BOOST_REQUIRE(same_bits(contact_time.contact(e, a.time, b.time), contact_time.contact(mirrored, a.time, b.time)));
  }
}

BOOST_AUTO_TEST_CASE(the_image_in_which_a_pair_is_seen_does_not_matter_to_the_bit) {
  const PositionGrid grid(2, 1);
  const double period = grid.round(1.7320508);
  for (std::uint64_t k = 0; k < 20000; ++k) {
    const Flight a = random_flight(2 * k, 2), b = random_flight(2 * k + 1, 2);
    Flight image = b;
    image.x += period, image.y -= 1;
    const Encounter<double> e = contact_time.encounter(a, b, period, -1), f = contact_time.encounter(a, image, 0, 0);
    BOOST_REQUIRE(same_bits(e.gap, f.gap));
    BOOST_REQUIRE(same_bits(e.approach, f.approach));
    BOOST_REQUIRE(same_bits(e.discriminant, f.discriminant));
  }
}

BOOST_AUTO_TEST_CASE(a_lane_gives_each_disk_the_bits_of_the_scalar_form) {
  for (std::uint64_t k = 0; k < 5000; ++k) {
    const Flight a = random_flight(k, 2);
    FlightOf<Lane> lane{};
    for (unsigned i = 0; i < lane_width; ++i) {
      const Flight b = random_flight(100000 + 4 * k + i, 2);
      lane.x[i] = b.x, lane.y[i] = b.y, lane.vx[i] = b.vx, lane.vy[i] = b.vy, lane.time[i] = b.time;
    }
    const Encounter<Lane> together = contact_time.encounter(a, lane, 1.3, -1);
    const Lane contacts = contact_time.contact(together, a.time, lane.time);
    const unsigned meet = bits(together.meet());
    for (unsigned i = 0; i < lane_width; ++i) {
      const Flight b{lane.x[i], lane.y[i], lane.vx[i], lane.vy[i], lane.time[i]};
      const Encounter<double> alone = contact_time.encounter(a, b, 1.3, -1);
      BOOST_REQUIRE(same_bits(together.gap[i], alone.gap));
      BOOST_REQUIRE(same_bits(together.approach[i], alone.approach));
      BOOST_REQUIRE(same_bits(together.discriminant[i], alone.discriminant));
      BOOST_REQUIRE(((meet >> i) & 1u) == (alone.meet() ? 1u : 0u));
      if (!alone.meet()) continue;
      BOOST_REQUIRE(same_bits(contacts[i], contact_time.contact(alone, a.time, b.time)));
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
