#include "verify/quantity_expression.hpp"

#include <fmt/format.h>

#include <charconv>

#include "gpf/base/error.hpp"
#include "gpf/measure/quantities.hpp"
#include "gpf/scene/nearest_word.hpp"

namespace gpf {
namespace {

InputError not_an_expression(std::string_view text, std::string why) {
  return {fmt::format("value \"{}\" cannot be read", text), std::move(why),
          "write QUANTITY at PLACE, or two of them with ' / ' or ' - ' between; PLACE is centre, walls, lower wall, "
          "upper wall or bin N, and is left out for quantities that have one value"};
}

/// N of "bin N", from 1; 0: the place is another one.
int bin_of(std::string_view place) {
  int bin = 0;
  if (!place.starts_with("bin ")) return 0;
  const auto [end, failure] = std::from_chars(place.data() + 4, place.data() + place.size(), bin);
  return failure == std::errc() && end == place.data() + place.size() && bin > 0 ? bin : 0;
}

bool is_place(std::string_view place) {
  return place == "centre" || place == "walls" || place == "lower wall" || place == "upper wall" || bin_of(place) > 0;
}

QuantityExpression::Term parse_term(std::string_view term, std::string_view text) {
  const std::size_t at = term.find(" at ");
  QuantityExpression::Term result{std::string(term.substr(0, at)), {}};
  if (at != std::string_view::npos) result.place = term.substr(at + 4);
  if (result.quantity.empty() || result.quantity.find(' ') != std::string::npos)
    throw not_an_expression(text, fmt::format("'{}' is no name of a quantity", result.quantity));
  if (at != std::string_view::npos && !is_place(result.place))
    throw not_an_expression(text, fmt::format("'{}' is no place", result.place));
  return result;
}

std::vector<double> values_of(const QuantityExpression::Term& term, const SceneValues& scene) {
  const int last = scene.bins() - 1;
  if (term.place.empty()) return scene.of(term.quantity);
  if (term.place == "centre") return scene.mirrored(term.quantity, scene.half() - 1);
  if (term.place == "walls") return scene.mirrored(term.quantity, 0);
  if (term.place == "lower wall") return scene.of(term.quantity, 0);
  if (term.place == "upper wall") return scene.of(term.quantity, last);
  return scene.of(term.quantity, bin_of(term.place) - 1);
}

void require(const QuantityExpression::Term& term, const std::vector<Quantity>& measured, int bins,
             const std::string& scene) {
  std::vector<std::string_view> names;
  for (const Quantity& q : measured) {
    names.push_back(q.name);
    if (q.name != term.quantity) continue;
    if (q.several == term.place.empty())
      throw InputError(fmt::format("{} of scene {}", q.name, scene),
                       q.several ? fmt::format("it has {} values, and no place is named", q.values.size())
                                 : fmt::format("it is one value, and '{}' is asked of it", term.place),
                       q.several ? "say where: 'at centre', 'at walls', 'at bin 3'" : "leave out the place");
    if (bin_of(term.place) == 0 && !term.place.empty() && static_cast<int>(q.values.size()) != bins)
      throw InputError(fmt::format("{} at {} of scene {}", q.name, term.place, scene),
                       "it has one value per wavenumber, not per bin", "write 'at bin K' for wavenumber K");
    if (bin_of(term.place) > static_cast<int>(q.values.size()))
      throw InputError(fmt::format("{} at {} of scene {}", q.name, term.place, scene),
                       fmt::format("it has {} values", q.values.size()), "name one of them");
    return;
  }
  throw InputError(fmt::format("no quantity '{}' in scene {}", term.quantity, scene),
                   fmt::format("there are {}", fmt::join(names, ", ")),
                   fmt::format("did you mean '{}'?", nearest_word(term.quantity, names)));
}

}  // namespace

QuantityExpression parse_quantity_expression(std::string_view text) {
  for (const char operation : {'/', '-'}) {
    const std::string between{' ', operation, ' '};
    const std::size_t at = text.find(between);
    if (at == std::string_view::npos) continue;
    return {parse_term(text.substr(0, at), text), operation, parse_term(text.substr(at + 3), text)};
  }
  return {parse_term(text, text), 0, {}};
}

std::vector<double> values_of(const QuantityExpression& expression, const SceneValues& scene) {
  std::vector<double> values = values_of(expression.first, scene);
  if (expression.operation == 0) return values;
  const std::vector<double> others = values_of(expression.second, scene);
  for (std::size_t r = 0; r < values.size(); ++r)
    values[r] = expression.operation == '/' ? values[r] / others[r] : values[r] - others[r];
  return values;
}

void require_quantities(const Claim& claim, const std::string& scene_name, const Scene& scene, const Run& run) {
  if (claim.checks.empty()) return;
  const TallyLayout layout(run);
  const std::vector<Quantity> measured = derive_quantities(scene, layout, std::vector<double>(layout.size(), 0.0));
  for (const ClaimCheck& check : claim.checks) {
    const QuantityExpression expression = parse_quantity_expression(check.value);
    require(expression.first, measured, run.bins, scene_name);
    if (expression.operation != 0) require(expression.second, measured, run.bins, scene_name);
  }
}

}  // namespace gpf
