// Equations of state against published simulations, against each other and against their own derivatives.
#include "gpf/theory/equation_of_state.hpp"

#include <algorithm>
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "gpf/base/error.hpp"
#include "unit/theory/reference_table.hpp"

namespace {

using namespace gpf;
using std::numbers::pi;

/// Best values of Z in the fluid, with half a unit of the last digit given.
struct Best {
  double nu, z, half_digit;
};
constexpr std::array<Best, 13> best = {{{.05, 1.108388, 5e-7},
                                        {.10, 1.236144, 5e-7},
                                        {.15, 1.388036, 5e-7},
                                        {.20, 1.570366, 5e-7},
                                        {.25, 1.791589, 5e-7},
                                        {.30, 2.063261, 5e-7},
                                        {.35, 2.401501, 5e-7},
                                        {.40, 2.82933, 5e-6},
                                        {.45, 3.38054, 5e-6},
                                        {.50, 4.10636, 5e-6},
                                        {.55, 5.08744, 5e-6},
                                        {.60, 6.45535, 5e-6},
                                        {.65, 8.40805, 5e-6}}};

BOOST_AUTO_TEST_SUITE(equation_of_state)

BOOST_AUTO_TEST_CASE(virial_coefficients_are_those_of_the_table) {
  for (const auto& row : reference_table("Clisby_2006/virial.csv")) {
    const auto k = static_cast<std::size_t>(row[0]);
    const VirialCoefficient b = virial_coefficients()[k - 1];
    BOOST_TEST(b.value == row[3], boost::test_tools::tolerance(1e-14));
    BOOST_TEST(b.value == row[1] * std::pow(2.0, row[0] - 1), boost::test_tools::tolerance(1e-14));
    BOOST_TEST(b.error == row[2] * std::pow(2.0, row[0] - 1), boost::test_tools::tolerance(1e-12));
    BOOST_TEST(b.error == row[4], boost::test_tools::tolerance(1e-12));
  }
  // The decimals that are printed for the closed forms.
  BOOST_TEST(std::abs(virial_coefficients()[2].value - 3.1280178) < 5e-8);
  BOOST_TEST(std::abs(virial_coefficients()[3].value - 4.2578545) < 5e-8);
}

BOOST_AUTO_TEST_CASE(virial_series_by_hand) {
  BOOST_TEST(virial_series(0) == 1.0);
  double sum = 0;
  for (std::size_t k = 0; k < 10; ++k) sum += virial_coefficients()[k].value * std::pow(0.3, static_cast<double>(k));
  BOOST_TEST(virial_series(0.3) == sum, boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(virial_series_falls_short_by_what_it_leaves_out) {
  // b_11 nu^10 and on, with b_k growing by .93 ... 1.1 a step: between 11 nu^10 and 11.5 nu^10/(1 - 1.1 nu); best
  // values from the fit of Kolafa and Rottner, good to 1e-6 here.
  for (const double nu : {0.20, 0.25, 0.30, 0.35, 0.40}) {
    const double missing = kolafa_rottner(nu) - virial_series(nu);
    BOOST_TEST(missing > 11 * std::pow(nu, 10) - 1e-6);
    BOOST_TEST(missing < 11.5 * std::pow(nu, 10) / (1 - 1.1 * nu) + 1e-6);
  }
}

BOOST_AUTO_TEST_CASE(kolafa_rottner_meets_the_simulations_it_was_fitted_to) {
  int rows = 0;
  for (const auto& row : reference_table("Kolafa_2006/table.csv")) {
    if (row[0] > 0.881) continue;  // beyond the fit
    ++rows;
    BOOST_TEST(std::abs(kolafa_rottner(pi * row[0] / 4) - row[1]) < row[2]);  // the fit's residuals: at most .85 errors
  }
  BOOST_TEST(rows == 15);
}

BOOST_AUTO_TEST_CASE(kolafa_rottner_is_the_best_value_in_the_fluid) {
  // Table rounded to its last digit; the fit itself is good to 1e-6.
  for (const Best& b : best) BOOST_TEST(std::abs(kolafa_rottner(b.nu) - b.z) < b.half_digit + 1e-10);
}

BOOST_AUTO_TEST_CASE(kolafa_rottner_expands_to_the_virial_series) {
  // Its x = nu/(1 - nu) gives b_3 = 2 + a_2, and so on: difference from the virial series below nu^4 x 1e-5 at small
  // nu, where b_5 agrees to 1e-5 and b_3, b_4 to the 8 decimals of a_2 and a_3.
  for (const double nu : {0.001, 0.01, 0.05}) {
    BOOST_TEST(std::abs(kolafa_rottner(nu) - virial_series(nu)) < 1e-8 * nu * nu + 1e-5 * std::pow(nu, 4) + 1e-15);
  }
}

BOOST_AUTO_TEST_CASE(derivatives_are_those_of_the_function) {
  // Central differences with h = 1e-4: truncation h^2/6 Z''' (relative to Z' < 1e-7 Z'''/Z' with Z'''/Z' < 3000 up to
  // .68), rounding 1e-16 Z/h^2 = 1e-7 for the second.
  const double h = 1e-4;
  for (const double nu : {0.05, 0.3, 0.5, 0.6, 0.65, 0.68}) {
    const Derivatives z = kolafa_rottner_derivatives(nu);
    const double up = kolafa_rottner(nu + h), down = kolafa_rottner(nu - h);
    BOOST_TEST(z.value == kolafa_rottner(nu));
    BOOST_TEST(z.first == (up - down) / (2 * h), boost::test_tools::tolerance(1e-5));
    BOOST_TEST(z.second == (up - 2 * z.value + down) / (h * h), boost::test_tools::tolerance(1e-4));
  }
  BOOST_TEST(kolafa_rottner_derivatives(0).first == 2.0);                   // b_2
  BOOST_TEST(kolafa_rottner_derivatives(0).second == 2 * (2 + 1.12801775),  // 2 b_3
             boost::test_tools::tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(henderson_errs_as_stated) {
  // Z against the best values, in per cent, rounded to two digits.
  const auto error = [](double nu) { return 100 * (henderson(nu) / kolafa_rottner(nu) - 1); };
  BOOST_TEST(std::abs(error(0.3) - 0.025) < 0.0005);
  BOOST_TEST(std::abs(error(0.5) - 0.45) < 0.005);
  BOOST_TEST(std::abs(error(0.6) - 1.2) < 0.05);
  BOOST_TEST(std::abs(error(0.65) - 2.2) < 0.05);
}

BOOST_AUTO_TEST_CASE(luding_errs_as_stated) {
  for (const Best& b : best) {
    if (b.nu < 0.625) BOOST_TEST(std::abs(luding_global(b.nu) / b.z - 1) < 0.75e-3);
  }
  const auto error = [](double nu) { return 100 * (luding_global(nu) / kolafa_rottner(nu) - 1); };
  BOOST_TEST(std::abs(error(0.65) + 0.13) < 0.005);
  BOOST_TEST(std::abs(error(0.67) + 0.27) < 0.005);
  BOOST_TEST(std::abs(error(0.68) + 0.71) < 0.005);
  BOOST_TEST(std::abs(error(0.69) + 1.55) < 0.005);
  // In the transition, against 1024^2 disks: between -1.81 % (nu .698) and +2.04 % (.72).
  double lowest = 0, highest = 0;
  for (const auto& row : reference_table("Bernard_2011/pressure.csv")) {
    const double relative = luding_global(row[1]) / (pi * row[2] / (4 * row[1])) - 1;
    lowest = std::min(lowest, relative);
    highest = std::max(highest, relative);
  }
  BOOST_TEST(std::abs(100 * lowest + 1.81) < 0.01);
  BOOST_TEST(std::abs(100 * highest - 2.04) < 0.01);
}

BOOST_AUTO_TEST_CASE(luding_has_the_limits_of_a_gas_and_of_a_crystal) {
  BOOST_TEST(luding_global(0) == 1.0, boost::test_tools::tolerance(1e-15));
  BOOST_TEST((luding_global(1e-6) - 1) / 1e-6 == 2.0, boost::test_tools::tolerance(1e-5));  // b_2
  // Free volume: Z (nu_c - nu) -> 2 nu_c, with the first correction -.04 x; the merging function is 8e-9 short of 1.
  const double x = 1e-4;
  BOOST_TEST(luding_global(close_packing - x) * x == 2 * close_packing * (1 - 0.04 * x),
             boost::test_tools::tolerance(1e-8));
  BOOST_TEST(close_packing == 0.9068996821171089, boost::test_tools::tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(luding_parameters_are_those_of_the_file) {
  // The merging function is 1/2 at nu_c = .70: Z - 1 half way between the branches.
  const double x = close_packing - 0.70;
  const double g4 = (1 - 7 * 0.70 / 16) / 0.09 - std::pow(0.70, 3) / (128 * 0.0081);
  const double dense = 2 * close_packing / x * (1 - 0.04 * x + 3.25 * x * x * x) - 1;
  BOOST_TEST(luding_global(0.70) == 1 + (1.4 * g4 + dense) / 2, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(refusals) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  BOOST_CHECK_THROW(virial_series(-0.1), InputError);
  BOOST_CHECK_THROW(kolafa_rottner(-0.001), InputError);
  BOOST_CHECK_THROW(kolafa_rottner(0.6912), InputError);
  BOOST_CHECK_THROW(kolafa_rottner(nan), InputError);
  BOOST_CHECK_NO_THROW(kolafa_rottner(kolafa_rottner_limit));
  BOOST_CHECK_THROW(luding_global(close_packing), InputError);
  BOOST_CHECK_THROW(luding_global(-0.1), InputError);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
