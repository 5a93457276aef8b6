#include "gpf/scene/nearest_word.hpp"

#include <array>
#include <boost/test/unit_test.hpp>
#include <string>

using namespace gpf;

BOOST_AUTO_TEST_SUITE(nearest_word_test)

BOOST_AUTO_TEST_CASE(distances_known_from_the_literature) {
  BOOST_TEST(edit_distance("kitten", "sitting") == 3u);
  BOOST_TEST(edit_distance("saturday", "sunday") == 3u);
  BOOST_TEST(edit_distance("", "abc") == 3u);
  BOOST_TEST(edit_distance("abc", "") == 3u);
  BOOST_TEST(edit_distance("same", "same") == 0u);
  BOOST_TEST(edit_distance("ab", "ba") == 2u);  // a swap is two replacements
}

BOOST_AUTO_TEST_CASE(a_distance_is_symmetric_and_obeys_the_triangle_inequality) {
  const std::array<std::string, 6> words{"", "seed", "sed", "bins", "duration", "derivation"};
  for (const auto& a : words)
    for (const auto& b : words) {
      BOOST_TEST(edit_distance(a, b) == edit_distance(b, a));
      for (const auto& c : words) BOOST_TEST(edit_distance(a, c) <= edit_distance(a, b) + edit_distance(b, c));
    }
}

BOOST_AUTO_TEST_CASE(the_first_of_equally_near_words_is_taken) {
  constexpr std::array<std::string_view, 3> words{"cat", "bat", "house"};
  BOOST_TEST(nearest_word("hat", words) == "cat");
  BOOST_TEST(nearest_word("mouse", words) == "house");
  BOOST_TEST(nearest_word("", words) == "cat");
}

BOOST_AUTO_TEST_SUITE_END()
