// Rheology of a channel as chapter 4 of the thesis reads it: normal stress differences, and stresses beside theory.
#pragma once

#include <string>
#include <vector>

#include "verify/estimators/scene_values.hpp"

namespace gpf {

/// Which stress tallies: what disks carry between contacts (eq. 4.2), what contacts transfer (eq. 4.3), or their sum.
enum class StressPart { kinetic, collisional, both };
inline constexpr StressPart stress_parts[] = {StressPart::both, StressPart::kinetic, StressPart::collisional};
std::string symbol_of(StressPart part);  ///< "N_1", "N_1^k", "N_1^c"

/// Long-time mean or instantaneous mean of the bin (eq. 2.10), subtracted from c_x in the kinetic stress; c_y has mean
/// zero either way.
enum class MeanFlow { instantaneous, long_time };

/// N_1 = (P_xx - P_yy)/p (eq. 4.6) of `bin` and its mirror image, one value per replica; of a part: its share of the
/// numerator over the whole p = (P_xx + P_yy)/2, so that N_1 = N_1^k + N_1^c. P is compressive positive: N_1 > 0 means
/// that more momentum flows along the channel than across.
std::vector<double> first_normal_stress_difference(const SceneValues& scene, int bin, StressPart part,
                                                   MeanFlow mean = MeanFlow::instantaneous);

/// dU/dy of the half of `bin` in which it is positive, one value per replica: slope at the bin's centre of the parabola
/// fitted to U of the bin and two neighbours on each side, one where the second would be the wall's bin, whose disks do
/// not have their mean height at its centre. The third bin from the wall is the first that has it.
inline constexpr int first_bin_with_shear_rate = 2;
std::vector<double> shear_rate(const SceneValues& scene, int bin);

/// What theory and measurement say of a bin and its mirror image, one value per replica, in the thesis' units: stresses
/// in rho_p g W, viscosities in rho_p g^(1/2) W^(3/2) (eq. 4.1). Theory uses the measured area fraction and T of each
/// bin and the measured shear rate. Shear stress: -P_xy where dU/dy > 0.
struct Rheology {
  std::vector<double> pressure, theory_pressure;
  std::vector<double> shear_stress, theory_shear_stress;
  std::vector<double> viscosity, theory_viscosity;  ///< measured: shear stress over shear rate (eq. 4.5)
};
enum class Constitutive { jenkins_richman, garzo_dufty };
Rheology rheology(const SceneValues& scene, int bin, Constitutive theory = Constitutive::jenkins_richman);

/// Indices of the first bin and the one after the last, on the lower side, in which a local theory can hold: from the
/// third bin on (nearer to the wall disks are layered), and at least one Enskog mean free path from the wall.
struct BinRange {
  int first = 0, end = 0;
};
BinRange bulk_bins(const SceneValues& scene);

/// The scenes of one restitution between one kind of walls, by area fraction.
struct SceneRow {
  double restitution = 1, wall_restitution = 1;  ///< e_n, and beta_w of both walls
  std::vector<const SceneValues*> scenes;

  [[nodiscard]] std::string label() const;  ///< "e_n 0.9, beta_w 0.1"
};

/// The rows of the scenes, which must stand by area fraction: beta_w falling, within it e_n falling.
std::vector<SceneRow> rows_of(const std::vector<SceneValues>& scenes);

/// The scene of the row with this area fraction, or null.
const SceneValues* find_scene(const SceneRow& row, double area_fraction);

}  // namespace gpf
