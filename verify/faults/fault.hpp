// A physics fault: what goes wrong, at which point of policy, and how badly.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "gpf/event/observer.hpp"
#include "gpf/event/rules.hpp"
#include "gpf/io/record.hpp"
#include "gpf/scene/scene.hpp"
#include "gpf/scene/state.hpp"

namespace gpf {

/// What a fault knows while a run goes on: its dose, the scene as it is simulated, chance, and what it remembers.
struct FaultState {
  double dose = 0;
  Scene scene;
  std::uint64_t drawn = 0;
  std::optional<Vec2> last_u_12;      ///< of the contact before
  std::optional<State> last_sampled;  ///< as the engine gave it

  /// True with probability `dose`. The numbers are the fault's own: the run's are not touched.
  bool happens();
};

/// A rule of the engine about to be applied.
struct PairCall {
  const SmoothDisks& rule;
  Vec2 r_12, u_12;
  double quiet;  ///< time since the last contact of either
};
struct WallCall {
  const FlatWalls& rule;
  Vec2 velocity;
  Wall wall;
  double quiet;
};

/// The points of policy at which real rules stand, in the order of a run; null: left as it is. Nothing of this is part
/// of the engine: faults take the place of its Physics and of its observer (faulty_simulation.hpp).
struct FaultPoints {
  void (*scene)(Scene&, Run&, double dose) = nullptr;  ///< what is simulated instead of what the record says
  PairOutcome (*pair)(const PairCall&, FaultState&) = nullptr;
  Vec2 (*wall)(const WallCall&, FaultState&) = nullptr;
  int (*seen_pair)(PairContact&, FaultState&) = nullptr;  ///< changes what is measured; how often it is counted
  int (*seen_wall)(WallContact&, FaultState&) = nullptr;
  void (*sampled)(State&, FaultState&) = nullptr;    ///< the state that is measured
  void (*recorded)(Record&, double dose) = nullptr;  ///< sums of the finished run

  /// Nothing but the sums of a run that went right is touched.
  [[nodiscard]] bool only_recorded() const { return !scene && !pair && !wall && !seen_pair && !seen_wall && !sampled; }
};

struct Fault {
  std::string_view name;        ///< as claims name it in `catches`
  std::string_view what;        ///< in words
  std::string_view dose_means;  ///< what the dose counts
  double dose;                  ///< at which the matrix tries it; at 0 nothing is wrong
  std::string_view shows_in;    ///< which scenes can reveal it
  FaultPoints points;
};

/// All faults, in the order of the points of policy.
std::span<const Fault> faults();

/// The fault of that name. Throws InputError that names the nearest.
const Fault& fault_named(std::string_view name);

/// The largest dose that makes sense: 1 for a part, a probability or a width of the channel, else a hundred times the
/// fault's own.
double largest_dose(const Fault& fault);

/// The name as that of a folder.
std::string folder_of(const Fault& fault);

}  // namespace gpf
