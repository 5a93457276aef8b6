#include "verify/report_markdown.hpp"

#include <boost/test/unit_test.hpp>
#include <string>

using gpf::markdown_text;

BOOST_AUTO_TEST_SUITE(report_markdown)

BOOST_AUTO_TEST_CASE(plain_scientific_text_stays_as_it_is) {
  for (const std::string text : {"|z| < 3 & nu > 0.1 - 0.4", "[0.1, 0.2] (99 %)", "Kolafa & Rottner, 2006",
                                 "3 of 4 bins; 1e-12 d", "λ/W ≥ 0.1", "P_xx - P_yy of u_x"})
    BOOST_TEST(markdown_text(text) == text);
}

BOOST_AUTO_TEST_CASE(html_does_not_get_through) {
  BOOST_TEST(markdown_text("<script>alert(1)</script>") == "&lt;script>alert(1)&lt;/script>");
  BOOST_TEST(markdown_text("<!-- a --> <?b?> &amp; &#60;") == "&lt;!-- a --> &lt;?b?> &amp;amp; &amp;#60;");
  BOOST_TEST(markdown_text("<u.u>/2") == "&lt;u.u>/2");
}

BOOST_AUTO_TEST_CASE(emphasis_code_links_formulas_and_footnotes_are_escaped) {
  BOOST_TEST(markdown_text("a *b* `c` ~~d~~ $e$ _f_") == "a \\*b\\* \\`c\\` \\~\\~d\\~\\~ \\$e\\$ \\_f\\_");
  BOOST_TEST(markdown_text("[a](b) ![c](d) [e][f] [g]: h [^1]") == "[a\\](b) ![c\\](d) [e\\][f] [g\\]: h \\[^1]");
  // As an entity, because a backslash would undo the escape of a pipe that follows it in a table.
  BOOST_TEST(markdown_text("a\\b") == "a&#92;b");
}

BOOST_AUTO_TEST_CASE(no_line_starts_a_block) {
  BOOST_TEST(markdown_text("# a") == "\\# a");
  BOOST_TEST(markdown_text("- a") == "\\- a");
  BOOST_TEST(markdown_text("> a") == "\\> a");
  BOOST_TEST(markdown_text("=====") == "\\=====");
  BOOST_TEST(markdown_text("12. a") == "12\\. a");
  BOOST_TEST(markdown_text("3) a") == "3\\) a");
  BOOST_TEST(markdown_text("12.5 a") == "12.5 a");
  BOOST_TEST(markdown_text("a\n\n# b\r\n- c\t\x02z") == "a  # b  - c  z");
  BOOST_TEST(markdown_text(" \n ") == "");
}

BOOST_AUTO_TEST_SUITE_END()
