#include "gpf/measure/quantities.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "gpf/base/vec2.hpp"
#include "gpf/stats/jackknife.hpp"
#include "gpf/theory/finite_size.hpp"

namespace gpf {

namespace {

constexpr double not_measured = std::numeric_limits<double>::quiet_NaN();

double ratio(double a, double b) { return b > 0 ? a / b : not_measured; }

/// Central moments 2, 3, 4 from the first four raw ones.
struct Central {
  double second, third, fourth;
};
Central central(double m1, double m2, double m3, double m4) {
  return {m2 - m1 * m1, m3 - 3 * m1 * m2 + 2 * m1 * m1 * m1,
          m4 - 4 * m1 * m3 + 6 * m1 * m1 * m2 - 3 * m1 * m1 * m1 * m1};
}

class Derivation {
 public:
  Derivation(const Scene& scene, const TallyLayout& layout, std::span<const double> totals)
      : scene_(scene), layout_(layout), totals_(totals) {}

  std::vector<Quantity> all() {
    profiles();
    collisions();
    if (layout_.density_modes() > 0) density_modes();
    if (scene_.geometry == Geometry::periodic)
      equation_of_state();
    else
      channel();
    return std::move(quantities_);
  }

 private:
  [[nodiscard]] double total(Tally t, int k = 0) const { return totals_[layout_.at(t, k)]; }
  void put(std::string name, double value) { quantities_.push_back({std::move(name), false, {value}}); }

  template <class F>
  void profile(std::string name, F&& of_bin) {
    Quantity q{std::move(name), true, {}};
    for (int b = 0; b < layout_.bins(); ++b) q.values.push_back(of_bin(b));
    quantities_.push_back(std::move(q));
  }

  void profiles() {
    using enum Tally;
    const double area = scene_.length() / layout_.bins(), time = total(measured_time), looks = total(samples);
    const auto mean = [this](Tally t, int b) { return ratio(total(t, b), total(count, b)); };
    const auto mean_velocity = [=](int b) { return mean(cx, b); };
    const auto variance_x = [this](int b) { return ratio(total(ux2, b), total(freedom, b)); };
    const auto variance_y = [=](int b) { return mean(cy2, b); };
    const auto y_moments = [=](int b) { return central(mean(cy, b), mean(cy2, b), mean(cy3, b), mean(cy4, b)); };
    const auto x_moments = [=](int b) { return central(mean(cx, b), mean(cx2, b), mean(cx3, b), mean(cx4, b)); };
    const double disk_area = std::numbers::pi / 4 * square(scene_.diameter());

    profile("area_fraction", [&](int b) { return disk_area * ratio(total(count, b), looks * area); });
    profile("mean_velocity", mean_velocity);
    profile("velocity_variance_x", variance_x);
    profile("velocity_variance_y", variance_y);
    profile("granular_temperature", [&](int b) { return 0.5 * (variance_x(b) + variance_y(b)); });
    profile("granular_temperature_long_time", [&](int b) { return 0.5 * (x_moments(b).second + mean(cy2, b)); });

    const auto kinetic_xx = [&](int b) { return ratio(total(count, b), looks * area) * variance_x(b); };
    const auto kinetic_yy = [&](int b) { return ratio(total(cy2, b), looks * area); };
    const auto kinetic_xy = [&](int b) {
      return ratio(total(cxcy, b) - mean_velocity(b) * total(cy, b), looks * area);
    };
    const auto collisional = [&](Tally t) { return [&, t](int b) { return ratio(total(t, b), time * area); }; };
    const auto collisional_xx = collisional(stress_xx), collisional_yy = collisional(stress_yy),
               collisional_xy = collisional(stress_xy);
    profile("kinetic_stress_xx", kinetic_xx);
    profile("kinetic_stress_yy", kinetic_yy);
    profile("kinetic_stress_xy", kinetic_xy);
    profile("collisional_stress_xx", collisional_xx);
    profile("collisional_stress_yy", collisional_yy);
    profile("collisional_stress_xy", collisional_xy);
    profile("pressure_xx", [&](int b) { return kinetic_xx(b) + collisional_xx(b); });
    profile("pressure_yy", [&](int b) { return kinetic_yy(b) + collisional_yy(b); });
    profile("pressure_xy", [&](int b) { return kinetic_xy(b) + collisional_xy(b); });

    profile("kurtosis_x", [&](int b) { return ratio(mean(ux4, b), square(mean(ux2, b))); });
    profile("skewness_x", [&](int b) { return ratio(mean(ux3, b), std::pow(mean(ux2, b), 1.5)); });
    profile("kurtosis_y", [&](int b) { return ratio(y_moments(b).fourth, square(y_moments(b).second)); });
    profile("skewness_y", [&](int b) { return ratio(y_moments(b).third, std::pow(y_moments(b).second, 1.5)); });
    profile("kurtosis_x_long_time", [&](int b) { return ratio(x_moments(b).fourth, square(x_moments(b).second)); });
    profile("skewness_x_long_time",
            [&](int b) { return ratio(x_moments(b).third, std::pow(x_moments(b).second, 1.5)); });
    profile("collision_frequency", [&](int b) { return ratio(total(contacts, b), time * area); });
    profile("dissipation_rate", [&](int b) { return ratio(total(loss, b), time * area); });
  }

  void collisions() {
    using enum Tally;
    const double rate = ratio(2 * total(pair_contacts), total(measured_time) * scene_.particles);
    const double peculiar = ratio(ratio(total(peculiar_speed), total(samples) * scene_.particles), rate);
    const double lab = ratio(total(free_path), total(free_paths));
    put("collision_rate", rate);
    put("mean_free_path", peculiar);
    put("mean_free_path_lab", lab);
    put("knudsen_number", peculiar);  // W = 1
    put("knudsen_number_lab", lab);
    if (scene_.geometry == Geometry::channel) {
      const double flights = 2 * total(pair_contacts) + total(wall_contacts, lower) + total(wall_contacts, upper);
      const double speeds = ratio(total(speed), total(samples));
      put("knudsen_number_any_contact", ratio(speeds * total(measured_time), flights));
    }
  }

  void density_modes() {
    using enum Tally;
    const auto shape = [this](const std::string& name, Tally power, Tally noise) {
      const double floor = ratio(total(noise), total(samples));
      Quantity q{"density_power_" + name, true, {}};
      for (int k = 0; k < layout_.density_modes(); ++k)
        q.values.push_back(ratio(total(power, k), total(samples)) - floor);
      quantities_.push_back(std::move(q));
      put("density_noise_" + name, floor);
    };
    shape("even", mode_even, mode_noise_even);
    shape("odd", mode_odd, mode_noise_odd);
    shape("varicose", mode_varicose, mode_noise_varicose);
    const double cosine = ratio(total(band_cos), total(samples)), sine = ratio(total(band_sin), total(samples));
    put("band_strength", std::hypot(cosine, sine));
    put("band_shift", std::atan2(sine, cosine) / (2 * std::numbers::pi));
  }

  /// p A = KE + (1/2) sum of r.J per time; with zero total momentum T = KE/(N - 1) and p A/(N T) = Z_N - 1/N.
  void equation_of_state() {
    using enum Tally;
    const double n = scene_.particles;
    const double kinetic = ratio(total(energy), total(samples)), temperature = ratio(kinetic, n - 1);
    const double finite = ratio(kinetic + 0.5 * ratio(total(virial), total(measured_time)), n * temperature);
    put("temperature", temperature);
    put("compressibility_finite", finite);
    put("compressibility", scene_.particles < 2
                               ? not_measured
                               : infinite_system_compressibility(finite, scene_.area_fraction(), scene_.particles));
  }

  void channel() {
    using enum Tally;
    const int last = layout_.bins() - 1;
    const double time = total(measured_time), length = scene_.length();
    const auto velocity = [this](int b) { return ratio(total(cx, b), total(count, b)); };
    const double centre = 0.5 * (velocity(last / 2) + velocity(last - last / 2));
    put("mean_flow", ratio(total(momentum), total(samples) * scene_.particles));
    put("centre_velocity", centre);
    put("slip_velocity", 0.5 * (velocity(0) + velocity(last)) / centre);
    put("slip_velocity_lower", velocity(0) / centre);
    put("slip_velocity_upper", velocity(last) / centre);
    near_walls(velocity, centre);
    put("wall_pressure_lower", ratio(total(wall_normal, lower), time * length));
    put("wall_pressure_upper", ratio(total(wall_normal, upper), time * length));
    put("wall_shear_lower", ratio(total(wall_tangential, lower), time * length));
    put("wall_shear_upper", ratio(total(wall_tangential, upper), time * length));
    put("gravity_power", ratio(total(gravity_work), time));
    put("pair_loss", ratio(total(Tally::pair_loss), time));
    put("wall_loss_lower", ratio(total(wall_loss, lower), time));
    put("wall_loss_upper", ratio(total(wall_loss, upper), time));
    put("energy_change", ratio(total(Tally::energy_change), time));
    put("energy_residual", ratio(total(gravity_work) - total(Tally::pair_loss) - total(wall_loss, lower) -
                                     total(wall_loss, upper) - total(Tally::energy_change),
                                 time));
  }

  /// Gradients are taken along the inward normal of each wall and averaged over the two walls; `h` is the bins' width.
  template <class Velocity>
  void near_walls(Velocity&& velocity, double centre) {
    using enum Tally;
    const int last = layout_.bins() - 1;
    const auto temperature = [this](int b) {
      return 0.5 * (ratio(total(ux2, b), total(freedom, b)) + ratio(total(cy2, b), total(count, b)));
    };
    const auto at_wall = [=](const auto& field, int b) { return 0.5 * (field(b) + field(last - b)); };
    const double per_h = layout_.bins();
    const auto difference = [=](const auto& field) {
      return last < 1 ? not_measured : (at_wall(field, 1) - at_wall(field, 0)) * per_h;
    };
    const auto extrapolated = [=](const auto& field) {
      return last < 2 ? not_measured : (-2 * at_wall(field, 0) + 3 * at_wall(field, 1) - at_wall(field, 2)) * per_h;
    };
    put("wall_gradient", difference(velocity));
    put("wall_gradient_extrapolated", extrapolated(velocity));
    put("wall_gradient_relative", difference(velocity) / centre);
    put("wall_gradient_relative_extrapolated", extrapolated(velocity) / centre);
    put("wall_temperature", at_wall(temperature, 0));
    put("wall_temperature_gradient", difference(temperature));
    put("wall_temperature_gradient_extrapolated", extrapolated(temperature));
  }

  const Scene& scene_;
  const TallyLayout& layout_;
  std::span<const double> totals_;
  std::vector<Quantity> quantities_;
};

}  // namespace

std::vector<Quantity> derive_quantities(const Scene& scene, const TallyLayout& layout, std::span<const double> totals) {
  return Derivation(scene, layout, totals).all();
}

MeasuredQuantities measure_quantities(const Scene& scene, const TallyLayout& layout, std::span<const double> sums,
                                      std::size_t blocks) {
  const auto flat = [&](std::span<const double> totals) {
    std::vector<double> values;
    for (const Quantity& q : derive_quantities(scene, layout, totals))
      values.insert(values.end(), q.values.begin(), q.values.end());
    return values;
  };
  MeasuredQuantities measured;
  if (blocks == 0) return measured;
  const std::vector<Estimate> estimates = jackknife(sums, blocks, flat);
  std::size_t at = 0;
  for (const Quantity& q : derive_quantities(scene, layout, sums.subspan(0, layout.size()))) {
    Measured& m = measured[q.name];
    m.several = q.several;
    for (std::size_t k = 0; k < q.values.size(); ++k) m.values.push_back(estimates[at++]);
  }
  return measured;
}

}  // namespace gpf
