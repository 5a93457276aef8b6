// Scene texts for tests: a valid one to alter, and the error that a text gives.
#pragma once

#include <boost/test/unit_test.hpp>
#include <initializer_list>
#include <string>
#include <string_view>

#include "gpf/base/error.hpp"
#include "gpf/scene/scene_file.hpp"

namespace gpf::test {

/// A valid channel; line 1 is [scene], line 8 [run].
inline const std::string channel_text = R"([scene]
geometry = "channel"
particles = 900
area_fraction = 0.3
width_over_diameter = 31
normal_restitution = 0.9
wall_tangential_restitution = 0.5
[run]
duration = 10
)";

/// A valid periodic scene; line 1 is [scene], line 7 [run].
inline const std::string periodic_text = R"([scene]
geometry = "periodic"
particles = 1000
area_fraction = 0.3
length_over_width = 1
normal_restitution = 1
[run]
collisions_per_particle = 100
)";

/// `text` with the first `from` replaced by `to`.
inline std::string with(std::string text, std::string_view from, std::string_view to) {
  const auto place = text.find(from);
  BOOST_REQUIRE_MESSAGE(place != std::string::npos, "no '" << from << "' in the text");
  return text.replace(place, from.size(), to);
}

/// Checks that `text` is refused at `place` ("line:column") with a message that has a problem, a reason and a remedy
/// and holds each of `fragments`.
inline void check_refused(const std::string& text, std::string_view place,
                          std::initializer_list<std::string_view> fragments) {
  try {
    static_cast<void>(parse_scene(text, "test.toml"));
    BOOST_ERROR("accepted:\n" << text);
  } catch (const InputError& error) {
    const std::string message = error.what();
    BOOST_TEST_CONTEXT(message) {
      const std::string expected = "test.toml:" + std::string(place) + ": ";
      BOOST_TEST(message.substr(0, expected.size()) == expected);
      BOOST_TEST(!error.why().empty());
      BOOST_TEST(!error.remedy().empty());
      BOOST_TEST((error.status() == ExitStatus::bad_input));
      for (const std::string_view fragment : fragments)
        BOOST_TEST(message.find(fragment) != std::string::npos, "lacks '" << fragment << "'");
    }
  }
}

}  // namespace gpf::test
