#include "verify/estimators/estimators.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "gpf/base/error.hpp"

namespace gpf {
namespace {

constexpr std::array<std::pair<std::string_view, Estimator>, 28> estimators{
    {{"eos_global", estimate_eos_global},
     {"eos_virial", estimate_eos_virial},
     {"two_codes", estimate_two_codes},
     {"steady", estimate_steady},
     {"overhead", estimate_overhead},
     {"cost", estimate_cost},
     {"energy", estimate_energy},
     {"tc", estimate_tc},
     {"lattices", estimate_lattices},
     {"smooth_fields", estimate_smooth_fields},
     {"kurtosis", estimate_kurtosis},
     {"kn_dilute", estimate_kn_dilute},
     {"kn_restitution", estimate_kn_restitution},
     {"kn_wall", estimate_kn_wall},
     {"kn_density", estimate_kn_density},
     {"slip_restitution", estimate_slip_restitution},
     {"slip_wall", estimate_slip_wall},
     {"slip_density", estimate_slip_density},
     {"slip_knudsen", estimate_slip_knudsen},
     {"gradient_density", estimate_gradient_density},
     {"gradient_knudsen", estimate_gradient_knudsen},
     {"flow_knudsen", estimate_flow_knudsen},
     {"temp_density", estimate_temp_density},
     {"temp_restitution", estimate_temp_restitution},
     {"temp_wall", estimate_temp_wall},
     {"temp_knudsen", estimate_temp_knudsen},
     {"momentum_balance", estimate_momentum_balance},
     {"energy_balance", estimate_energy_balance}}};

}  // namespace

Estimator estimator_named(std::string_view name) {
  const auto found = std::find_if(estimators.begin(), estimators.end(), [&](const auto& e) { return e.first == name; });
  if (found != estimators.end()) return found->second;
  std::vector<std::string_view> names;
  for (const auto& [known, function] : estimators) names.push_back(known);
  throw InputError(fmt::format("unknown estimator '{}'", name), fmt::format("known are {}", fmt::join(names, ", ")),
                   "correct the claim file's key estimator");
}

}  // namespace gpf
