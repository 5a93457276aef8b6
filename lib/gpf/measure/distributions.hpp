// Distributions: of the velocities in each bin, of free paths, of the angles at which disks touch.
#pragma once

#include <cstddef>
#include <span>

#include "gpf/event/observer.hpp"
#include "gpf/measure/bins.hpp"
#include "gpf/measure/named_array.hpp"
#include "gpf/scene/scene.hpp"
#include "gpf/scene/state.hpp"

namespace gpf {

/// Histograms of a run. Every first and last cell also holds what lies beyond. Arrays, with B bins across the width:
///
/// velocity/frame [B][3]: U, sigma_x and sigma_y of each bin when measurement began: the units of the histograms, not
///   results. velocity/ux, velocity/uy [B][velocity_cells]: counts of u_x/sigma_x (u about the instantaneous mean of
///   the bin, eq. 2.10) and c_y/sigma_y from -10 to 10; velocity/cx [B][flow_cells]: of (c_x - U)/sigma_x from -40 to
///   40, hence of c_x, and of u_x about any long-time mean.
/// contact/angle [B][angle_cells]: pair contacts by the angle of the normal to +x, 0 to pi; the bin is that of the
///   contact's middle.
/// free_path/unit [1]: Enskog's mean free path of the uniform scene, a length. free_path/lab, free_path/peculiar
///   [path_cells]: counts of the displacement of a disk between successive pair contacts, in that unit, sixteen cells
///   an octave from 2^-13 to 2^12: in the laboratory, and less the mean flow of the bin where the path ends.
/// free_path/last [N] (time of a disk's last pair contact) and free_path/flow [B][2] (sum of c_x, count) are the state
///   that a resumed run needs.
class Distributions {
 public:
  static constexpr std::size_t velocity_cells = 200, angle_cells = 36, path_cells = 400;
  static constexpr std::size_t flow_cells = 800;
  static constexpr double velocity_range = 10, flow_range = 40, path_least = 0x1p-13, path_most = 0x1p12;

  Distributions(const Scene& scene, int bins);

  void begin(const State& state);
  /// After free_path() of both disks.
  void on_pair(const PairContact& contact);
  /// `displacement`: of disk `disk` since its last pair contact, in the laboratory; the disk has had one.
  void free_path(std::int32_t disk, const PairContact& contact, Vec2 displacement);
  /// fluctuation[i]: u_x of disk i about the mean of its bin in this state.
  void sample(const State& state, std::span<const double> fluctuation);

  [[nodiscard]] const NamedArrays& arrays() const { return arrays_; }
  [[nodiscard]] NamedArrays& arrays() { return arrays_; }

 private:
  enum Name : std::size_t { frame, ux, uy, cx, angle, unit, lab, peculiar, last_time, flow };
  NamedArray& array(Name name) { return arrays_[name]; }
  [[nodiscard]] std::size_t bin(double y) const { return static_cast<std::size_t>(bins_.at(y)); }

  Bins bins_;
  NamedArrays arrays_;
};

}  // namespace gpf
