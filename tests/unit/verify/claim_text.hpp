// A claim file that uses every key, and the means to spoil it.
#pragma once

#include <stdexcept>
#include <string>

namespace gpf::test {

inline const std::string scenes_and_replicas = R"([scenes]
quick = ["periodic-nu10", "periodic-nu30"]
full = ["channel"]
[replicas]
quick = 4
standard = 16
)";

inline const std::string tolerances = R"([[tolerance]]
name = "reference"
value = 0.002
evidence = "table 1"
[[tolerance]]
name = "finite N"
value = 0.001
evidence = "measured with 4 N"
)";

inline const std::string claim_text = R"(id = "eos.example"
title = "Pressure"
chapter = 2
source = "fig. 2.8"
statement = "Z is Luding's"
method = """
Z from the virial,
  corrected to infinite N."""
kind = "zero-crossing"
expected = "refuted"
expected_because = "the equation is 2 % off there"
estimator = "eos_example"
tolerance_unit = "relative"
transient = true
catches = ["restitution applied twice", "g off by 2 %"]
)" + scenes_and_replicas + tolerances +
                                      R"([parameters]
highest_area_fraction = 0.40
whole = 3
)";

/// `text` with the first `from` replaced; it must be there, or the test would test nothing.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::logic_error("'" + from + "' is not in the text");
  return text.replace(at, from.size(), to);
}

}  // namespace gpf::test
