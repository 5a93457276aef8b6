// Records whose tallies a test sets, so that the truth is known; and claims with given numbers.
#pragma once

#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "gpf/io/record.hpp"
#include "gpf/measure/tallies.hpp"
#include "verify/claim.hpp"
#include "verify/evidence.hpp"

namespace gpf::test {

/// Sets tally (wall or bin k) of every block.
using SetTally = std::function<void(Tally tally, int k, double value)>;

/// A record of the scene file `text` with `blocks` equal blocks of length 1 and one sample each; the rest is what
/// `fill` sets.
Record made_record(const std::string& text, const std::function<void(const SetTally&)>& fill, std::size_t blocks = 1);

inline Claim made_claim(double tolerance, std::map<std::string, double, std::less<>> parameters = {}) {
  Claim claim;
  claim.id = "made.claim";
  claim.tolerance.push_back({"all of it", tolerance, "the test"});
  claim.parameters = std::move(parameters);
  return claim;
}

inline std::string channel_text(double area_fraction, std::string_view more = {}) {
  return "[scene]\ngeometry = \"channel\"\nparticles = 180\nwidth_over_diameter = 12\narea_fraction = " +
         std::to_string(area_fraction) + "\nnormal_restitution = 0.9\nwall_tangential_restitution = 0.5\n" +
         std::string(more) + "[run]\nstart_up = 2\nduration = 8\nbins = 6\n";
}

/// The check whose label contains `part`; throws std::out_of_range (a failed test) unless there is exactly one.
inline const Check& check_with(const Evidence& evidence, std::string_view part) {
  const Check* found = nullptr;
  for (const Check& check : evidence.checks) {
    if (check.label.find(part) == std::string::npos) continue;
    if (found != nullptr) throw std::out_of_range("two checks: " + found->label + "; " + check.label);
    found = &check;
  }
  if (found == nullptr) throw std::out_of_range("no check with " + std::string(part));
  return *found;
}

/// Whether every value of every check lies in its band.
inline bool all_inside(const Evidence& evidence) {
  for (const Check& check : evidence.checks)
    for (const double value : check.values)
      if (!check.band.contains(value)) return false;
  return true;
}

/// Labels of the checks that have a value outside their band.
inline std::vector<std::string> outside(const Evidence& evidence) {
  std::vector<std::string> labels;
  for (const Check& check : evidence.checks)
    for (const double value : check.values)
      if (!check.band.contains(value)) {
        labels.push_back(check.label);
        break;
      }
  return labels;
}

}  // namespace gpf::test
