// Claims and verdicts made up for tests of the report.
#pragma once

#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "verify/judge.hpp"
#include "verify/report_data.hpp"

namespace gpf::test {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// Four values with this mean and standard error: +-a twice has the deviation a sqrt(4/3), the standard error
/// a/sqrt(3).
inline std::vector<double> four_values(double mean, double standard_error) {
  const double a = standard_error * std::sqrt(3.0);
  return {mean - a, mean + a, mean - a, mean + a};
}

inline Check check(std::string label, double mean, double standard_error, Interval band) {
  return {std::move(label), four_values(mean, standard_error), band, false, 0, band.centre()};
}

inline std::string synthetic_claim_text(std::string_view id, std::string_view expected = "reproduced") {
  std::string text = "id = \"" + std::string(id) + "\"\n" +
                     "title = \"A title\"\nchapter = 2\nsource = \"fig. 2.8\"\nstatement = \"Z equals the reference\"\n"
                     "method = \"the virial of the contacts\"\nkind = \"profile\"\nestimator = \"none\"\n"
                     "tolerance_unit = \"relative\"\ncatches = [\"restitution applied twice\"]\n"
                     "expected = \"" +
                     std::string(expected) + "\"\n";
  if (expected != "reproduced") text += "expected_because = \"theory of first order, ref. 12\"\n";
  return text +
         "[[tolerance]]\nname = \"finite N\"\nvalue = 0.01\nevidence = \"measured at two N\"\n"
         "[[tolerance]]\nname = \"reference\"\nvalue = 0.02\nevidence = \"table 3\"\n";
}

/// A claim that reads no run, judged on these checks in tier quick at the only look.
inline JudgedClaim judged(std::string_view id, std::vector<Check> checks, std::string_view expected = "reproduced") {
  const Claim claim = parse_claim(synthetic_claim_text(id, expected), std::string(id) + ".toml");
  Evidence evidence;
  evidence.checks = std::move(checks);
  evidence.extra_cpu_seconds = 2;
  return {claim, judge(claim, Tier::quick, evidence, 4, 1, 1)};
}

/// One that passes, fails, or cannot be decided: the band is [-1, 1], the 99 % interval 4.54 standard errors long each
/// way (t with 3 degrees of freedom).
inline JudgedClaim passing(std::string_view id) { return judged(id, {check("value", 0.2, 0.1, {-1, 1})}); }
inline JudgedClaim failing(std::string_view id, std::string_view expected = "reproduced") {
  return judged(id, {check("value", 5, 0.1, {-1, 1})}, expected);
}
inline JudgedClaim undecided(std::string_view id) { return judged(id, {check("value", 0.9, 0.1, {-1, 1})}); }

}  // namespace gpf::test
