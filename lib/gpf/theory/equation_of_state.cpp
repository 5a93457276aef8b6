#include "gpf/theory/equation_of_state.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "gpf/base/error.hpp"
#include "gpf/theory/contact_value.hpp"

namespace gpf {
namespace {

[[noreturn]] void outside(const char* equation, double nu, const char* why, const char* remedy) {
  throw InputError(fmt::format("{} is not defined at area fraction {}", equation, nu), why, remedy);
}

/// Clisby & McCoy print B_k/B_2^(k-1); B_2 = 2 in units of the area of a disk.
constexpr VirialCoefficient from_ratio(double ratio, double error, double two_to_the_k_minus_1) {
  return {ratio * two_to_the_k_minus_1, error * two_to_the_k_minus_1};
}

std::array<VirialCoefficient, 10> make_virial_coefficients() {
  constexpr double pi = std::numbers::pi, sqrt3 = std::numbers::sqrt3;
  return {{{1, 0},
           {2, 0},
           {16.0 / 3 - 4 * sqrt3 / pi, 0},              // Tonks 1936
           {16 - 36 * sqrt3 / pi + 80 / (pi * pi), 0},  // Rowlinson 1964, Hemmer 1965
           from_ratio(0.33355604, 1e-8, 16),
           from_ratio(0.1988425, 42e-7, 32),
           from_ratio(0.1148728, 43e-7, 64),
           from_ratio(0.0649930, 34e-7, 128),
           from_ratio(0.0362193, 35e-7, 256),
           from_ratio(0.0199537, 80e-7, 512)}};
}

/// a_0 ... a_12 and, apart, a_19.
constexpr std::array<double, 13> a = {1,
                                      2,
                                      1.12801775,
                                      .00181895291,
                                      -.0526134737,
                                      .0504951668,
                                      -.0325433846,
                                      .0133946531,
                                      .00174265604,
                                      -.00944632202,
                                      .00851111768,
                                      -.0035963525,
                                      .000577345106};
constexpr double a_19 = -1.06399127e-7;

}  // namespace

const std::array<VirialCoefficient, 10>& virial_coefficients() {
  static const std::array<VirialCoefficient, 10> coefficients = make_virial_coefficients();
  return coefficients;
}

double virial_series(double nu) {
  if (!(nu >= 0)) outside("the virial series", nu, "no area is negative", "pass an area fraction from 0 to about 0.4");
  double sum = 0;
  for (std::size_t k = virial_coefficients().size(); k-- > 0;) sum = sum * nu + virial_coefficients()[k].value;
  return sum;
}

Derivatives kolafa_rottner_derivatives(double nu) {
  if (!(nu >= 0 && nu <= kolafa_rottner_limit)) {
    outside("Kolafa and Rottner's equation", nu, "it was fitted to the fluid up to 0.6911",
            "use luding_global for denser systems");
  }
  const double x = nu / (1 - nu);
  Derivatives z;  // of the polynomial, with respect to x, by Horner's rule
  for (std::size_t i = a.size(); i-- > 0;) {
    z.second = z.second * x + 2 * z.first;
    z.first = z.first * x + z.value;
    z.value = z.value * x + a[i];
  }
  const double x17 = std::pow(x, 17);
  z.value += a_19 * x17 * x * x;
  z.first += 19 * a_19 * x17 * x;
  z.second += 19 * 18 * a_19 * x17;
  const double slope = 1 / ((1 - nu) * (1 - nu));  // dx/dnu; d2x/dnu2 = 2 slope/(1 - nu)
  return {z.value, z.first * slope, z.second * slope * slope + z.first * 2 * slope / (1 - nu)};
}

double kolafa_rottner(double nu) { return kolafa_rottner_derivatives(nu).value; }

double luding_global(double nu) {
  if (!(nu >= 0 && nu < close_packing)) {
    outside("Luding's equation", nu, "disks fill from 0 to less than 0.9069 of the plane", "check the area fraction");
  }
  const double dilute = 2 * nu * luding_contact_value(nu);  // P4, the Z - 1 of the fluid
  const double x = close_packing - nu;
  const double dense = 2 * close_packing / x * (1 - .04 * x + 3.25 * x * x * x) - 1;  // Z - 1 of the crystal
  const double merging = 1 / (1 + std::exp(-(nu - .70) / .0111));
  return 1 + dilute + merging * (dense - dilute);
}

}  // namespace gpf
