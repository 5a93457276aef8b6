// Gas, liquid or crystal: what the disks of a bin look like, from g(r) and the bond angles to their neighbours.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gpf/stats/interval.hpp"
#include "verify/estimators/pair_functions.hpp"

namespace gpf {

enum class Order { gas, liquid, crystal };

/// The numbers that tell the classes apart.
struct LocalOrder {
  double shell;  ///< second shell: mean of g over 1.95 < r/d < 2.35 less that over 1.4 < r/d < 1.7. A gas has no
                 ///< second maximum and falls from the first (shell < 0)
  double split;  ///< of the second maximum, which a crystal divides into one near sqrt(3) and one near 2: the lower of
                 ///< the two maxima over the minimum between them, 1 for a single hump
  double hexatic;  ///< mean of |psi_6| over the disks
};

/// One inequality of a class.
struct OrderCriterion {
  std::string name;
  double LocalOrder::*value;
  Interval range;
};

LocalOrder local_order(const PairFunctions& pairs);
/// From g(r) in the cells of PairFunctions, and <|psi_6|>.
LocalOrder local_order(const std::vector<double>& pair_correlation, double hexatic);

/// The ranges of a class. They come from equilibrium hard disks (e_n 1, N 900, periodic, engine of this program), seen
/// through strips as high as a bin of the channel, 31 d/18:
///
///   nu       .30   .40  .45*  .50   .55   .60   .65   .68   .70   .72   .74   .76   .80
///   shell  -.095  .004  .13   .26   .42   .67   .90  1.06  1.22  1.42  1.53  1.25  1.29   (* interpolated)
///   hexatic  .67   .61   -    .55   .54   .55   .58   .63   .70   .80   .84   .89   .95
///   split      -     -   -   1.12  1.10  1.05  1.01  1.00  1.00  1.00  1.06  1.23  3.05
///
/// Gas: no second shell (below nu .40). Liquid: a second shell (above nu .45) that is one hump, and no more hexatic
/// than at freezing (nu .70). Crystal: at least as hexatic as at melting (nu .72), and the second shell split. What
/// lies between is in no class. <|psi_6|> of a gas is large because its disks have few neighbours: it is no criterion
/// there.
std::vector<OrderCriterion> criteria_of(Order order);

/// The class whose criteria all hold; nothing between the classes.
std::optional<Order> classify(const LocalOrder& order);

std::string name_of(const std::optional<Order>& order);  ///< "gas", "liquid", "crystal" or "between the classes"

}  // namespace gpf
