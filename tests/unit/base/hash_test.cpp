// Hashes: texts, hexadecimal, and the trace hash: blind to order, sharp to one ulp.
#include "gpf/base/hash.hpp"

#include <algorithm>
#include <bit>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "gpf/base/random.hpp"

namespace {

using namespace gpf;

struct Collision {
  std::int64_t epoch;
  double time;
  std::int32_t a, b;
};

/// Collisions at times that are not round numbers.
std::vector<Collision> some_collisions() {
  std::vector<Collision> list;
  for (std::int32_t k = 0; k < 1000; ++k) {
    list.push_back({k / 100, std::sqrt(1.0 + k), k % 37, k % 5 == 0 ? -1 : 40 + k % 11});
  }
  return list;
}

std::uint64_t trace(const std::vector<Collision>& list) {
  TraceHash hash;
  for (const Collision& c : list) hash.add(c.epoch, c.time, c.a, c.b);
  return hash.value();
}

BOOST_AUTO_TEST_SUITE(hash)

BOOST_AUTO_TEST_CASE(hexadecimal_has_sixteen_digits) {
  BOOST_TEST(hexadecimal(0) == "0000000000000000");
  BOOST_TEST(hexadecimal(0x0123456789abcdefu) == "0123456789abcdef");
  BOOST_TEST(hexadecimal(~std::uint64_t{0}) == "ffffffffffffffff");
}

BOOST_AUTO_TEST_CASE(mix_is_splitmix64) {
  // The published first outputs of SplitMix64 from state 1234567: the state grows by the golden ratio and is mixed.
  std::uint64_t state = 1234567;
  for (const std::uint64_t expected : {6457827717110365317u, 3203168211198807973u, 9817491932198370423u}) {
    state += 0x9e3779b97f4a7c15u;
    BOOST_TEST(mix(state) == expected);
  }
}

BOOST_AUTO_TEST_CASE(mix_moves_half_of_the_bits) {
  // Each of 64 input bits flipped in 256 inputs: 2^20 output bits, each moved with probability 1/2. Its standard
  // deviation is 512; 5 of them allow one false alarm in 1.7 million programs (fixed inputs: it either holds or not).
  long moved = 0;
  for (std::uint64_t k = 0; k < 256; ++k) {
    const std::uint64_t input = k * 0x9e3779b97f4a7c15u;
    for (int bit = 0; bit < 64; ++bit) moved += std::popcount(mix(input) ^ mix(input ^ (std::uint64_t{1} << bit)));
  }
  BOOST_TEST(std::abs(moved - (1L << 19)) < 5 * 512);
}

BOOST_AUTO_TEST_CASE(texts_are_fnv_1a_mixed) {
  // FNV-1a test vectors of its authors (isthe.com): "" and "foobar".
  BOOST_TEST(hash_text("") == mix(0xcbf29ce484222325u));
  BOOST_TEST(hash_text("foobar") == mix(0x85944171f73967e8u));
  BOOST_TEST(hash_text("e_n = 0.9") != hash_text("e_n = 0.8"));
}

BOOST_AUTO_TEST_CASE(trace_does_not_depend_on_order_or_on_who_comes_first) {
  std::vector<Collision> list = some_collisions();
  const std::uint64_t forward = trace(list);
  std::reverse(list.begin(), list.end());
  std::rotate(list.begin(), list.begin() + 333, list.end());
  BOOST_TEST(trace(list) == forward);
  for (Collision& c : list) std::swap(c.a, c.b);
  BOOST_TEST(trace(list) == forward);
}

BOOST_AUTO_TEST_CASE(trace_sees_one_ulp) {
  const std::vector<Collision> list = some_collisions();
  const std::uint64_t original = trace(list);
  for (std::size_t k = 0; k < list.size(); ++k) {
    std::vector<Collision> changed = list;
    changed[k].time = std::nextafter(changed[k].time, std::numeric_limits<double>::infinity());
    BOOST_TEST(trace(changed) != original);
  }
}

BOOST_AUTO_TEST_CASE(trace_sees_partner_epoch_loss_and_repetition) {
  const std::vector<Collision> list = some_collisions();
  const std::uint64_t original = trace(list);
  std::vector<Collision> changed = list;
  changed[7].b += 1;
  BOOST_TEST(trace(changed) != original);
  changed = list;
  changed[7].epoch += 1;
  BOOST_TEST(trace(changed) != original);
  changed = list;
  changed.pop_back();
  BOOST_TEST(trace(changed) != original);
  changed = list;
  changed.push_back(list.back());
  BOOST_TEST(trace(changed) != original);
  changed.push_back(list.back());  // three times is not once: repetitions do not cancel
  BOOST_TEST(trace(changed) != original);
  changed = list;  // two collisions exchange their partners
  std::swap(changed[1].b, changed[2].b);
  BOOST_TEST(trace(changed) != original);
}

BOOST_AUTO_TEST_CASE(walls_differ_from_disks_and_from_each_other) {
  TraceHash lower, upper, disk;
  lower.add(0, 1.5, 3, -1);
  upper.add(0, 1.5, 3, -2);
  disk.add(0, 1.5, 3, 1);
  BOOST_TEST(lower.value() != upper.value());
  BOOST_TEST(lower.value() != disk.value());
}

BOOST_AUTO_TEST_CASE(trace_goes_on_from_a_stored_value) {
  TraceHash whole, first;
  whole.add(0, 0.25, 1, 2);
  first = whole;
  whole.add(1, 0.75, 3, 4);
  TraceHash resumed(first.value());
  resumed.add(1, 0.75, 3, 4);
  BOOST_CHECK(resumed == whole);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
