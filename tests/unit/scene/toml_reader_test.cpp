#include "gpf/scene/toml_reader.hpp"

#include <fmt/format.h>

#include <boost/test/unit_test.hpp>
#include <string>

using namespace gpf;

namespace {

std::string message_of(std::string_view text) {
  try {
    static_cast<void>(read_toml(text, "t.toml"));
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

bool begins(const std::string& text, std::string_view with) { return text.substr(0, with.size()) == with; }

std::string repeated(std::string_view piece, int times) {
  std::string text;
  for (int k = 0; k < times; ++k) text += piece;
  return text;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(toml_reader_test)

BOOST_AUTO_TEST_CASE(every_kind_of_value_arrives_with_its_position) {
  const TomlTable table =
      read_toml("z = 1\n  b.c = [2.5, \"x\"]\n[a]\nyes = true\n  day = 1979-05-27\n\"\u00e9 k\" = inf\n", "t.toml");
  BOOST_REQUIRE_EQUAL(table.size(), 3u);  // in the order of the text, not of the alphabet
  BOOST_TEST(table[0].key == "z");
  BOOST_TEST(std::get<std::int64_t>(table[0].value.data) == 1);
  BOOST_TEST(table[0].position.line == 1u);
  BOOST_TEST(table[0].value.position.column == 5u);

  const auto& b = std::get<TomlTable>(table[1].value.data);
  const auto& c = std::get<TomlArray>(b.at(0).value.data);
  BOOST_TEST(table[1].position.column == 3u);
  BOOST_TEST(std::get<double>(c.at(0).data) == 2.5);
  BOOST_TEST(std::get<std::string>(c.at(1).data) == "x");
  BOOST_TEST(c.at(1).position.line == 2u);
  BOOST_TEST(c.at(1).position.column == 15u);

  const auto& a = std::get<TomlTable>(table[2].value.data);
  BOOST_REQUIRE_EQUAL(a.size(), 3u);
  BOOST_TEST(std::get<bool>(a[0].value.data));
  BOOST_TEST(kind_of(a[1].value) == "a date or time");
  BOOST_TEST(a[2].key == "\u00e9 k");
  BOOST_TEST(a[2].value.position.column == 9u);  // characters, not bytes: "\u00e9" is two bytes
}

BOOST_AUTO_TEST_CASE(kinds_have_names) {
  const TomlTable table = read_toml("a=1\nb=1.5\nc=''\nd=[]\ne={}\nf=true\ng=10:00:00\n", "t.toml");
  const std::string_view names[]{"an integer", "a real number", "a string",      "an array",
                                 "a table",    "true or false", "a date or time"};
  for (std::size_t k = 0; k < table.size(); ++k) BOOST_TEST(kind_of(table[k].value) == names[k]);
}

BOOST_AUTO_TEST_CASE(text_that_is_not_toml_is_refused_where_it_breaks) {
  BOOST_TEST(begins(message_of("a = 1\nb = = 2\n"), "t.toml:2:"));
  BOOST_TEST(begins(message_of("a = 1\na = 2\n"), "t.toml:2:"));
  BOOST_TEST(begins(message_of("a = \"open"), "t.toml:1:"));
  BOOST_TEST(begins(message_of("a = '\xff'"), "t.toml:1:"));
  BOOST_TEST(begins(message_of("\n\na = 9223372036854775808"), "t.toml:3:"));
  BOOST_TEST(begins(message_of("a = 1e999"), "t.toml:1:"));
  BOOST_TEST(message_of("a = \"open").find("correct this line") != std::string::npos);
}

// toml++ 3.3.0 stops at these by an assertion, without a position.
BOOST_AUTO_TEST_CASE(what_trips_the_parsers_assertions_is_refused_with_its_line) {
  BOOST_TEST(begins(message_of("[("), "t.toml:1:1: this is not TOML"));
  BOOST_TEST(begins(message_of("a = 1\n\n# note\n[(\nb = 2\n"), "t.toml:4:1: this is not TOML"));
  BOOST_TEST(begins(message_of("a = 1\r\n[("), "t.toml:2:1: this is not TOML"));
}

// toml++ 3.3.0 takes these for a branch that cannot be reached.
BOOST_AUTO_TEST_CASE(letters_beyond_ascii_outside_quotes_are_refused) {
  for (const char* letter : {"\u00e9", "\u00a7", "\u1681", "\u2010", "\u3001", "\ufefb"}) {
    BOOST_TEST(begins(message_of(fmt::format("a = 1\nb{} = 2\n", letter)), "t.toml:2:2: this is not TOML"));
    BOOST_TEST(message_of(fmt::format("a = \"\"\"\\\n{}\"\"\" # {}", letter, letter)) == "accepted");
  }
}

BOOST_AUTO_TEST_CASE(depth_is_bounded) {
  BOOST_TEST(message_of(std::string("a = ") + repeated("[", 15) + repeated("]", 15)) == "accepted");
  BOOST_TEST(message_of(std::string("a = ") + repeated("[", 17) + repeated("]", 17)).find("nested more than 16 deep") !=
             std::string::npos);
  BOOST_TEST(message_of(repeated("a.", 15) + "a = 1") == "accepted");
  BOOST_TEST(message_of(repeated("a.", 17) + "a = 1").find("nested more than 16 deep") != std::string::npos);
  // The deepest that fits the longest text: must be refused, not overflow the stack.
  BOOST_TEST(message_of(repeated("a.", 8189) + "a = 1").find("nested more than 16 deep") != std::string::npos);
  BOOST_TEST(message_of(std::string("[") + repeated("a.", 8189) + "a]").find("nested more than 16 deep") !=
             std::string::npos);
}

BOOST_AUTO_TEST_CASE(length_is_bounded) {
  std::string text(longest_toml_text, '#');
  BOOST_TEST(message_of(text) == "accepted");
  text += '#';
  BOOST_TEST(message_of(text).find("the file has 16385 bytes") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(an_empty_text_is_an_empty_table) {
  BOOST_TEST(read_toml("", "t.toml").empty());
  BOOST_TEST(read_toml("# only a comment", "t.toml").empty());
  BOOST_TEST(read_toml("\xef\xbb\xbf"
                       "a = 1",
                       "t.toml")
                 .size() == 1u);
}

BOOST_AUTO_TEST_CASE(quoted_text_is_fit_for_a_message) {
  BOOST_TEST(gpf::quoted("abc") == "'abc'");
  BOOST_TEST(gpf::quoted("a\nb\x1b[1m") == "'a?b?[1m'");
  BOOST_TEST(gpf::quoted(std::string(41, 'x')) == std::string("'") + std::string(40, 'x') + "...'");
  BOOST_TEST(gpf::quoted(std::string(40, 'x')) == std::string("'") + std::string(40, 'x') + "'");
}

BOOST_AUTO_TEST_SUITE_END()
