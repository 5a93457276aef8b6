// Which states are exported: those that are kept, or a trajectory simulated anew.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "verify/view/frames.hpp"
#include "verify/view/view_source.hpp"

namespace gpf {

/// What a record keeps: its snapshots, then its final state; each time once. Of a scene file: the state at time 0.
std::vector<Snapshot> kept_states(const ViewSource& source);

/// The frames of a plan, simulated anew; when its count is 0, the states that are kept.
class ExportedStates {
 public:
  ExportedStates(const ViewSource& source, const FramePlan& plan);

  [[nodiscard]] const ViewSource& source() const { return source_; }
  [[nodiscard]] std::size_t count() const { return count_; }
  /// Where they come from, in words.
  [[nodiscard]] std::string origin() const;
  /// Shows one after the other, in the order of time. Throws what run_frames throws.
  void show_all(const std::function<void(const Snapshot&)>& show) const;

 private:
  const ViewSource& source_;
  FramePlan plan_;
  std::vector<Snapshot> kept_;
  std::size_t count_;
};

}  // namespace gpf
