// Which method is the cheapest that is accurate enough, by what was measured on like scenes.
#pragma once

#include <string>
#include <vector>

#include "verify/methods/chart.hpp"

namespace gpf {

/// A method for a scene, and what is expected of it.
struct Candidate {
  std::string method;                 ///< as parse_method() reads it
  double bias_at_most = 0;            ///< the largest on the like scenes
  double noise = 0;                   ///< of a run of this duration
  double duration = 0;                ///< measured time, the scene's unit
  double cpu_seconds = 0;             ///< start-up included, on the machine of the chart
  std::vector<std::string> evidence;  ///< like scenes: "channel-smooth-nu15-e99: bias 0.012 (0.003), 0.011 CPU s"
  std::string why_not;                ///< empty: it may be used

  [[nodiscard]] bool usable() const { return why_not.empty(); }
  /// Bias and twice the noise: what is promised.
  [[nodiscard]] double error_at_most() const { return bias_at_most + 2 * noise; }
};

struct Advice {
  std::vector<Candidate> candidates;  ///< those that may be used first, the cheapest first
  [[nodiscard]] const Candidate& best() const { return candidates.front(); }
};

/// Is what was measured on `known` evidence for `scene`? nu and 1 - e_n + .01 within a factor 2, W/d within 1.7, the
/// slip of each wall, (1 + beta)/(1 - beta), within 3.5, e_w alike; the same sort of walls (alike or not).
bool alike(const Scene& known, const Scene& scene);

/// Every method of the table without varied N, t_c or start. A method may be used when at least two like scenes were
/// tried and `scene` lies between them in nu, e_n, W/d and slip, with L/W at most 1.5 times theirs, it gave up on none,
/// and the largest bias that any of them leaves possible is within `tolerance`; its run is as long as it takes for
/// twice the noise to fit into the rest, where noise is taken to fall with the square root of time from the largest
/// that any like run had. The engine may always be used: its bias is taken as none, and its duration is the scene's own
/// when no like scene tells its noise. `tolerance`: relative, or absolute for an observable that may vanish. Throws
/// InputError for a tolerance that is not between 1e-4 and 1, a run without duration, a scene that is no channel under
/// gravity, and walls with |beta_w| = 1.
Advice advise(const std::vector<ChartPoint>& points, const Scene& scene, const Run& run, const Observable& observable,
              double tolerance);

}  // namespace gpf
