// Skewness and kurtosis of the fluctuation velocities: shared by the claims of chapter 3 that rest on moments.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "gpf/io/plot.hpp"
#include "verify/estimators/scene_values.hpp"
#include "verify/evidence.hpp"

namespace gpf {

/// A moment of one velocity component in a bin: skewness <u^3>/<u^2>^(3/2) (eq. 3.2; 0 for a Gaussian) or kurtosis
/// <u^4>/<u^2>^2 (3 for a Gaussian). A mirror at the centre plane turns u_y round, and with it the skewness of u_y.
struct VelocityMoment {
  std::string_view quantity;  ///< of derive_quantities
  std::string_view name;      ///< in a label
  Parity parity = Parity::even;
};

inline constexpr VelocityMoment skewness_x{"skewness_x", "skewness of u_x"};
inline constexpr VelocityMoment skewness_x_long_time{"skewness_x_long_time",
                                                     "skewness of u_x about the long-time mean"};
inline constexpr VelocityMoment skewness_y{"skewness_y", "skewness of u_y", Parity::odd};
inline constexpr VelocityMoment kurtosis_x{"kurtosis_x", "kurtosis of u_x"};
inline constexpr VelocityMoment kurtosis_x_long_time{"kurtosis_x_long_time",
                                                     "kurtosis of u_x about the long-time mean"};
inline constexpr VelocityMoment kurtosis_y{"kurtosis_y", "kurtosis of u_y"};

/// u_x about either mean that can be subtracted: the instantaneous one of the bin (eq. 2.10) and the long-time one.
inline constexpr std::array<VelocityMoment, 2> skewnesses_x{skewness_x, skewness_x_long_time};
inline constexpr std::array<VelocityMoment, 2> kurtoses_x{kurtosis_x, kurtosis_x_long_time};

/// The scenes of the evidence, from the most elastic to the most dissipative.
std::vector<SceneValues> by_restitution(const SceneRecords& records);

/// "nu 0.56, e_n 0.8, beta_w 0.9"
std::string flow_name(const SceneValues& scene);
/// "bins 5 and 14" of a bin counted from 0 and its mirror image; "bin 16" for the middle one.
std::string bin_names(const SceneValues& scene, int bin);

/// A claim's bin, counted from 1 as in the thesis, as an index. Throws InputError when it is not on the lower side.
int bin_parameter(const Claim& claim, std::string_view name, const SceneValues& scene);

/// The moment in `bin` and its mirror image taken together, as it is in `bin`; one value per replica.
std::vector<double> moment(const SceneValues& scene, const VelocityMoment& which, int bin);
/// |moment - centre|, one value per replica.
std::vector<double> departure(const SceneValues& scene, const VelocityMoment& which, int bin, double centre = 0);
/// The moment in `bin`, labelled with flow, bins and moment, against a band.
Check moment_check(const SceneValues& scene, const VelocityMoment& which, int bin, Interval band);

/// The moment against y/W from wall to wall: the measured half, and its mirror image.
Series moment_profile(const SceneValues& scene, const VelocityMoment& which, std::string label);
/// A band over the whole channel.
Series band_across(Interval band, std::string label);

/// What both definitions of the fluctuation velocity make of skewness and kurtosis of u_x: the sentence that says which
/// is which, the bias of the first by the finite number of disks in a bin, and their greatest difference in each flow.
std::vector<std::string> notes_on_definitions(const std::vector<SceneValues>& scenes);

}  // namespace gpf
