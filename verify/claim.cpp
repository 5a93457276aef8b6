#include "verify/claim.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "gpf/base/error.hpp"

namespace gpf {
namespace {

constexpr std::array<std::string_view, 3> tiers{"quick", "standard", "full"};
constexpr std::array<std::string_view, 10> kinds{"value", "band",          "profile", "exponent", "sign",
                                                 "order", "zero-crossing", "class",   "same",     "shape"};
constexpr std::array<std::string_view, 3> expectations{"reproduced", "refuted", "unresolved"};

template <class Enum, std::size_t n>
Enum named(std::string_view what, std::string_view name, const std::array<std::string_view, n>& names) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    throw InputError(fmt::format("unknown {} '{}'", what, name), fmt::format("it is one of {}", fmt::join(names, ", ")),
                     "write one of these");
  return static_cast<Enum>(found - names.begin());
}

/// The entry of the tier or of the next one below that has one.
template <class Value>
const Value* at_or_below(const std::map<Tier, Value>& entries, Tier tier) {
  const auto above = entries.upper_bound(tier);
  return above == entries.begin() ? nullptr : &std::prev(above)->second;
}

}  // namespace

double Claim::tolerance_total() const {
  double total = 0;
  for (const ToleranceTerm& term : tolerance) total += term.value;
  return total;
}

double Claim::parameter(std::string_view name) const {
  const auto found = parameters.find(name);
  if (found == parameters.end())
    throw InputError(fmt::format("claim '{}' has no parameter '{}'", id, name),
                     fmt::format("its estimator '{}' needs it", estimator),
                     fmt::format("add it to [parameters] in {}.toml", id));
  return found->second;
}

bool Claim::judged_in(Tier tier) const { return scenes.empty() || at_or_below(scenes, tier) != nullptr; }

std::vector<std::string> Claim::scenes_in(Tier tier) const {
  const auto* found = at_or_below(scenes, tier);
  return found == nullptr ? std::vector<std::string>{} : *found;
}

int Claim::replicas_in(Tier tier) const {
  const int* found = at_or_below(replicas, tier);
  return found == nullptr ? 1 : *found;
}

std::string_view name_of(Tier tier) { return tiers[static_cast<std::size_t>(tier)]; }
std::string_view name_of(Kind kind) { return kinds[static_cast<std::size_t>(kind)]; }
std::string_view name_of(Expectation expectation) { return expectations[static_cast<std::size_t>(expectation)]; }

Tier tier_named(std::string_view name) { return named<Tier>("tier", name, tiers); }
Kind kind_named(std::string_view name) { return named<Kind>("kind", name, kinds); }
Expectation expectation_named(std::string_view name) { return named<Expectation>("expectation", name, expectations); }

}  // namespace gpf
