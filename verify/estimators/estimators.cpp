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

constexpr std::array<std::pair<std::string_view, Estimator>, 19> estimators{
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
     {"plug_tails", estimate_plug_tails},
     {"dense_tails", estimate_dense_tails},
     {"same_distributions", estimate_same_distributions},
     {"rough_wall_peak", estimate_rough_wall_peak},
     {"hump", estimate_hump},
     {"cx_wall", estimate_cx_wall},
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
