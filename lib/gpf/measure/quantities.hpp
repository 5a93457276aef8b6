// What a report shows, derived from tallies: profiles across the channel and numbers of the whole flow.
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gpf/measure/tallies.hpp"
#include "gpf/scene/scene.hpp"
#include "gpf/stats/estimate.hpp"

namespace gpf {

/// A measured quantity: one value, or several: one per bin, or one per wavenumber.
struct Quantity {
  std::string name;
  bool several = false;
  std::vector<double> values;
};

/// All quantities of a scene, from the total of its tallies. Units W = m = 1 (stresses are forces per length, energy
/// rates energies per time, of the whole scene). Not measured: NaN.
///
/// Per bin: area_fraction, mean_velocity U, granular_temperature T = <u.u>/2 and velocity_variance_x, _y (u_x about the
/// instantaneous bin mean, sums divided by n - 1; u_y about 0, its mean; eq. 2.10), granular_temperature_long_time
/// (about U), kinetic_, collisional_stress_xx, _yy, _xy and their sums pressure_xx, _yy, _xy (eqs. 4.1-4.3; compressive
/// positive; P_xy is the flux of x momentum along +y), kurtosis_x, _y (3 for a Gaussian), skewness_x, _y,
/// kurtosis_x_long_time, skewness_x_long_time, collision_frequency (contacts per area and time),
/// dissipation_rate (energy per area and time).
/// One value: collision_rate (per disk), mean_free_path (peculiar: <|u|>/rate), mean_free_path_lab (mean laboratory
/// displacement between successive pair contacts of a disk), knudsen_number and knudsen_number_lab (free path/W, the
/// two paths above; that of the thesis is the second), and for a periodic scene temperature (energy/(N - 1)),
/// compressibility_finite p A/(N T) and compressibility (corrected to infinite N); for a channel mean_flow Q,
/// centre_velocity U_0 (the two bins, or the one, at the centre plane), slip_velocity U_w/U_0 (U_w: bins next to the
/// walls), slip_velocity_lower, _upper, knudsen_number_any_contact (length of the way between contacts with disks or
/// walls), wall_gradient dU/dy and wall_gradient_relative (dU/dy)/U_0 at the walls, along the inward normal: difference
/// of bins 1 and 2 over their width, or with _extrapolated the slope at the wall itself of the parabola through bins 1,
/// 2, 3, wall_temperature (bins next to the walls), wall_temperature_gradient and _gradient_extrapolated in the same
/// way, wall_pressure_lower, _upper, wall_shear_lower, _upper (force per length on the wall), and the energy budget as
/// rates: gravity_power, pair_loss, wall_loss_lower, _upper, energy_change, energy_residual = gravity_power - losses -
/// energy_change.
/// Where density modes are measured, one value per wavenumber k = 1, 2, ...: density_power_even, _odd, _varicose, the
/// mean of |a_k|^2 (density_modes.hpp) less what independent disks of these heights have. So 0 for an ideal gas, and
/// down to -1/N for disks that exclude one another. One value: density_noise_even, _odd, _varicose, what was taken off;
/// band_strength and band_shift: size of the mean of exp(2 pi i (y - 1/2)), and the height of the band's middle less
/// 1/2.
std::vector<Quantity> derive_quantities(const Scene& scene, const TallyLayout& layout, std::span<const double> totals);

/// A quantity with its errors.
struct Measured {
  bool several = false;
  std::vector<Estimate> values;
};
using MeasuredQuantities = std::map<std::string, Measured, std::less<>>;

/// Means and jackknife errors over `blocks` rows of tallies.
MeasuredQuantities measure_quantities(const Scene& scene, const TallyLayout& layout, std::span<const double> sums,
                                      std::size_t blocks);

}  // namespace gpf
