#include "verify/view/frames.hpp"

#include <algorithm>
#include <cmath>

#include "gpf/base/error.hpp"
#include "gpf/event/engine.hpp"

namespace gpf {

double default_interval(const State& state) {
  double squares = 0;
  for (const Vec2 v : state.velocity) squares += dot(v, v);
  if (!(squares > 0)) return 0x1p-6;  // nothing moves
  return std::ldexp(1.0, std::ilogb(1 / (32 * std::sqrt(squares / static_cast<double>(state.velocity.size())))));
}

std::uint64_t run_frames(const Scene& scene, const Snapshot& start, const FramePlan& plan,
                         const std::function<void(const Snapshot&)>& show) {
  Engine<> engine(scene, start.state);
  const auto heed_stop = [&plan] {
    if (plan.stop != nullptr && *plan.stop != 0)
      throw Error(ExitStatus::interrupted, "stopped by a signal before all frames were there", "",
                  "the same command begins anew");
  };
  for (int frame = 0; frame < plan.count; ++frame) {
    const double time = frame * plan.interval;
    while (engine.epoch_end() <= time) {
      engine.advance(engine.epoch_end());
      heed_stop();
    }
    engine.advance(time);
    heed_stop();
    show({start.time + time, engine.state()});
  }
  return engine.trace_hash().value();
}

}  // namespace gpf
