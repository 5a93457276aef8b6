// Functions of the distance between two disks of a bin, normalised: g(r) and the velocity correlations.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "gpf/io/plot.hpp"
#include "gpf/io/record.hpp"
#include "verify/estimators/scene_values.hpp"

namespace gpf {

/// A strip of a channel, periodic along x with period `length`, that holds uniformly random points: all lengths in one
/// unit.
struct Strip {
  double height, length;

  /// Probability that two of the points lie at most r apart, for r <= length/2. Its derivative is
  /// 4 r/(w^2 L) * integral over 0 <= a <= pi/2 of max(w - r sin a, 0), w the height and L the length: the arc of
  /// radius r about one point, as far as it lies in the strip, averaged over the point's height.
  [[nodiscard]] double within(double r) const;
};

/// Which mean the streamwise fluctuation velocity is taken about.
enum class Mean {
  instantaneous,  ///< of the bin (eq. 2.10). The sum of u over the bin is zero, hence the mean of C_xx over all pairs
                  ///< is -1/(n - 1)
  long_time       ///< of the bin, over the whole measurement: it keeps the motion of the bin as a whole
};

enum class Component { xx, yy, xy };

/// The arrays pair/* of a record (correlations.hpp) of one bin, or of a bin and its mirror image added together.
/// Distances are in diameters; cell k of every result is centred at distance(k).
class PairFunctions {
 public:
  /// Adds up the pairs of the bins; every velocity is about the mean of its own bin. Bins of the upper half are seen in
  /// the mirror at the centre plane, which turns c_y and C_xy round. Throws InputError when the record has no such
  /// arrays.
  PairFunctions(const Record& record, const std::vector<int>& bins);

  /// Centre of a cell.
  static double distance(std::size_t cell);

  /// Pairs at that distance over what uniformly random disks in the same strip would make (Strip), 1 at large distances
  /// without long-range order. Centres do not enter the wall bins' outermost d/2: their strip is that much narrower.
  /// NaN beyond L/2.
  [[nodiscard]] std::vector<double> pair_correlation() const;

  /// Eq. 3.4, read as a mean over pairs: C_xx(r) = <u_x u_x'>/<u_x^2>, C_yy = <c_y c_y'>/<c_y^2>, and
  /// C_xy = <u_x c_y' + u_x' c_y>/2/(<u_x^2><c_y^2>)^(1/2) - eq. 3.4 divides by <u_x c_y>, which may vanish. One-disk
  /// means are over the same bins. C_yy and C_xy know only one mean. NaN where there is no pair.
  [[nodiscard]] std::vector<double> velocity_correlation(Component component, Mean mean = Mean::instantaneous) const;

  /// Mean of a correlation over the pairs at distances from `from` to `to`.
  [[nodiscard]] double mean_correlation(Component component, double from, double to,
                                        Mean mean = Mean::instantaneous) const;

  /// The mean of C_xx over all pairs of a bin that eq. 2.10 forces, -sum u_x^2/(sum over samples n(n - 1)) in units of
  /// <u_x^2>: -1/(n - 1) for a bin of n disks.
  [[nodiscard]] double forced_offset() const { return forced_; }

  /// <u_x c_y>/(<u_x^2><c_y^2>)^(1/2) of one disk, u and c about the long-time mean: what eq. 3.4 divides C_xy by.
  [[nodiscard]] double one_disk_xy() const;

  /// Mean of |psi_6| over the disks, and of the number of neighbours nearer than 1.5 d; the neighbours may lie in any
  /// bin.
  [[nodiscard]] double hexatic() const { return hexatic_; }
  [[nodiscard]] double neighbours() const { return neighbours_; }

 private:
  [[nodiscard]] const std::vector<double>& products(Component component, Mean mean) const;
  [[nodiscard]] double one_disk(Component component, Mean mean) const;

  double length_;                                            // in diameters
  std::vector<double> count_, expected_;                     // by cell
  std::vector<double> ux_, uy_, uxy_, v_;                    // sums of products; v_ about the long-time mean
  double disks_ = 0, ux2_ = 0, cy2_ = 0, v2_ = 0, vcy_ = 0;  // one-disk sums, over all samples
  double forced_ = 0, hexatic_ = 0, neighbours_ = 0;
};

/// One for each replica, of `bin` and its mirror image.
std::vector<PairFunctions> pair_functions(const SceneValues& scene, int bin);

/// One point for each cell: mean over the replicas with its error bar. `curve` makes the values of one replica.
Series curve_of(std::string label, const std::vector<PairFunctions>& replicas,
                const std::function<std::vector<double>(const PairFunctions&)>& curve);

/// "nu 0.56, e_n 0.80, beta_w 0.9", with N where it is not 900.
std::string label_of(const Scene& scene);

}  // namespace gpf
