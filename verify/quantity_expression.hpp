// What a claim file may ask of the measured quantities without a line of C++: a quantity at a place, or two of them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "verify/claim.hpp"
#include "verify/estimators/scene_values.hpp"

namespace gpf {

/// QUANTITY [at PLACE], or two of them with " / " or " - " between. QUANTITY: a name of gpf/measure/quantities.hpp.
/// PLACE, of quantities that have one value per bin (or wavenumber): "centre" (the bin at the centre plane, or the
/// two), "walls" (the mean of the bins next to them), "lower wall", "upper wall", or "bin N", from 1.
struct QuantityExpression {
  struct Term {
    std::string quantity, place;
  };
  Term first;
  char operation = 0;  ///< '/', '-', or 0: there is no second
  Term second;
};

/// Throws InputError for a text that is not of that form.
QuantityExpression parse_quantity_expression(std::string_view text);

/// One value per replica. Throws InputError when the scene has no such quantity or place.
std::vector<double> values_of(const QuantityExpression& expression, const SceneValues& scene);

/// Throws InputError when what a claim's [[check]]s ask for is not measured in a run of this scene.
void require_quantities(const Claim& claim, const std::string& scene_name, const Scene& scene, const Run& run);

}  // namespace gpf
