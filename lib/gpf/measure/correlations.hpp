// Correlations: between the disks of a bin (g, C_xx, C_yy, C_xy), of their order, and of their velocities in time.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "gpf/measure/bins.hpp"
#include "gpf/measure/named_array.hpp"
#include "gpf/scene/scene.hpp"
#include "gpf/scene/state.hpp"

namespace gpf {

/// Sums over pairs and over times, of a channel. Arrays, with B bins across the width:
///
/// pair/count [B][distance_cells]: pairs of disks that lie in the same bin, by their distance in diameters, 0 to 12.
/// pair/ux, pair/uy: sums of u_x u_x' and c_y c_y' over those pairs; pair/uxy: of (u_x c_y' + u_x' c_y)/2;
///   pair/cx: of v v', and pair/cx_sum: of (v + v')/2, with v = c_x less pair/frame: u about the instantaneous mean of
///   the bin, and what any other mean needs.
/// pair/frame [B]: U of each bin when measurement began. pair/total [B]: sum of n (n - 1)/2 over samples; pair/samples
/// [1]. order/psi6, order/neighbours, order/disks [B]: sums over disks of |psi_6| (psi_6 the mean of exp(6 i theta)
/// over the
///   neighbours nearer than 1.5 d), of the number of those neighbours, and of one.
/// time/ux, time/uy, time/count [B][lags]: sums of u_x(0) u_x(t) and c_y(0) c_y(t) over disks that were in the bin at
///   time 0, t in sample intervals. time/origin [1 + 3 N]: what a resumed run needs.
class Correlations {
 public:
  static constexpr std::size_t distance_cells = 240, lags = 33, stride = 4;  ///< pairs: every stride-th sample
  static constexpr double distance_range = 12, neighbour_range = 1.5;        ///< in diameters

  Correlations(const Scene& scene, int bins);

  void begin(const State& state);
  void sample(const State& state, std::span<const double> ux);

  [[nodiscard]] const NamedArrays& arrays() const { return arrays_; }
  [[nodiscard]] NamedArrays& arrays() { return arrays_; }

 private:
  enum Name : std::size_t {
    pairs,
    pair_ux,
    pair_uy,
    pair_uxy,
    pair_cx,
    pair_cx_sum,
    frame,
    total,
    samples,
    psi6,
    neighbours,
    disks,
    time_ux,
    time_uy,
    time_count,
    origin
  };
  NamedArray& array(Name name) { return arrays_[name]; }
  [[nodiscard]] std::size_t bin(double y) const { return static_cast<std::size_t>(bins_.at(y)); }
  void add_pairs(const State& state, std::span<const double> ux);
  void add_times(const State& state, std::span<const double> ux);

  Bins bins_;
  double diameter_, length_;
  NamedArrays arrays_;
};

}  // namespace gpf
