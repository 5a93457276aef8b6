#include "verify/export/states.hpp"

#include <fmt/format.h>

namespace gpf {

std::vector<Snapshot> kept_states(const ViewSource& source) {
  if (!source.record) return {source.start};
  std::vector<Snapshot> kept;
  const auto keep = [&kept](const Snapshot& state) {
    if (kept.empty() || kept.back().time < state.time) kept.push_back(state);
  };
  for (const Snapshot& snapshot : source.record->snapshots) keep(snapshot);
  keep({source.record->time, source.record->final_state});
  return kept;
}

ExportedStates::ExportedStates(const ViewSource& source, const FramePlan& plan) : source_(source), plan_(plan) {
  if (plan.count == 0) kept_ = kept_states(source);
  count_ = plan.count > 0 ? static_cast<std::size_t>(plan.count) : kept_.size();
}

std::string ExportedStates::origin() const {
  return plan_.count > 0 ? fmt::format("{}: simulated anew from time {}", source_.name, source_.start.time)
                         : fmt::format("{}: its own states", source_.name);
}

void ExportedStates::show_all(const std::function<void(const Snapshot&)>& show) const {
  if (plan_.count > 0)
    run_frames(source_.scene, source_.start, plan_, show);
  else
    for (const Snapshot& state : kept_) show(state);
}

}  // namespace gpf
