#include <boost/test/unit_test.hpp>
#include <cmath>

#include "gpf/base/error.hpp"
#include "unit/verify/estimators/made_record.hpp"
#include "unit/verify/estimators/made_velocities.hpp"
#include "verify/estimators/velocity_tail.hpp"

namespace gpf::test {

BOOST_AUTO_TEST_SUITE(velocity_distribution_)

const std::string scene = channel_scene(0.2, 0.9, 0.5);

std::vector<VelocityDistribution> distributions_of(Velocity velocity, int bin, std::size_t replicas, int samples,
                                                   const Draw& draw) {
  return velocity_distributions(SceneValues("made", sampled_records(replicas, scene, samples, draw)), velocity, bin);
}

/// Of u_x in the middle, 60 disks in two bins.
std::vector<VelocityDistribution> distributions_of(const std::function<double(Generator&)>& ux, int samples = 4000) {
  return distributions_of(Velocity::ux, 2, 4, samples, [&](Generator& g, int) { return Vec2{ux(g), 0.1}; });
}

BOOST_AUTO_TEST_CASE(a_gaussian_is_one) {
  const auto replicas = distributions_of([](Generator& g) { return gaussian(g, 0.7); });
  for (const VelocityDistribution& d : replicas) {
    BOOST_TEST(d.total == 240000);
    BOOST_TEST(d.sigma == 0.7, boost::test_tools::tolerance(0.01));
    BOOST_TEST(std::abs(d.kurtosis - 3) < 0.05);
    BOOST_TEST(std::abs(d.skewness) < 0.025);
    BOOST_TEST(std::abs(d.beyond(3) / 0.0027 - 1) < 0.2);
    BOOST_TEST(distance_from_gaussian(d) < 0.005);
    BOOST_TEST(std::abs(dip_at_zero(d) + 0.13) < 0.05);
    const std::vector<double> p = d.density();
    for (std::size_t i = 0; i < d.cells; ++i)
      if (const double u = d.centre(i); std::abs(u) < 2)
        BOOST_TEST(p[i] == std::exp(-0.5 * u * u), boost::test_tools::tolerance(0.1));
    const std::vector<Peak> peaks = find_peaks(d, dispersion(replicas));
    BOOST_TEST_REQUIRE(peaks.size() == 1u);
    BOOST_TEST(std::abs(peaks[0].position) < 0.25);
  }
  BOOST_TEST(dispersion(replicas) < 1.4);
}

BOOST_AUTO_TEST_CASE(two_humps_are_two_peaks) {
  const auto replicas = distributions_of(two_humps, 500);
  for (const VelocityDistribution& d : replicas) {
    const std::vector<Peak> peaks = find_peaks(d, dispersion(replicas));
    BOOST_TEST_REQUIRE(peaks.size() == 2u);
    for (const Peak& peak : peaks)
      BOOST_TEST(std::abs(peak.position) == 1 / d.sigma, boost::test_tools::tolerance(0.2));
    BOOST_TEST(dip_at_zero(d) > 0.1);
  }
}

BOOST_AUTO_TEST_CASE(a_peak_is_where_the_distribution_has_it) {
  for (const VelocityDistribution& d : distributions_of(skewed, 1000)) {
    const std::vector<Peak> peaks = find_peaks(d, 1);
    BOOST_TEST_REQUIRE(peaks.size() == 1u);
    BOOST_TEST(peaks[0].position == -1 / std::sqrt(3.0), boost::test_tools::tolerance(0.15));  // mode 2, mean 3
    BOOST_TEST(d.skewness == 2 / std::sqrt(3.0), boost::test_tools::tolerance(0.1));
  }
}

BOOST_AUTO_TEST_CASE(the_mirror_turns_u_y_and_nothing_else) {
  const Draw draw = [](Generator& g, int bin) { return Vec2{skewed(g), (bin < 3 ? 1 : -1) * skewed(g)}; };
  for (const Velocity velocity : {Velocity::ux, Velocity::uy, Velocity::cx})
    for (const VelocityDistribution& d : distributions_of(velocity, 0, 2, 500, draw))
      BOOST_TEST(d.skewness == 2 / std::sqrt(3.0), boost::test_tools::tolerance(0.15));
}

BOOST_AUTO_TEST_CASE(c_x_is_taken_about_its_own_mean) {
  const Draw draw = [](Generator& g, int) { return Vec2{gaussian(g, 0.5) + 1, gaussian(g)}; };
  for (const VelocityDistribution& d : distributions_of(Velocity::cx, 1, 2, 500, draw)) {
    BOOST_TEST(d.mean == 4, boost::test_tools::tolerance(0.01));
    BOOST_TEST(d.sigma == 0.5, boost::test_tools::tolerance(0.02));
    BOOST_TEST(d.between(-12, 12) == d.total, boost::test_tools::tolerance(1e-9));
  }
}

BOOST_AUTO_TEST_CASE(a_power_law_has_its_exponent_in_every_window_and_on_both_sides) {
  const auto replicas = distributions_of([](Generator& g) { return power_tail(g, 6); });
  for (const TailSide side : {TailSide::both, TailSide::positive, TailSide::negative})
    for (const TailFit& fit : fit_tails(replicas, side)) {
      const Estimate exponent = over_replicas(fit.exponent), bend = over_replicas(fit.bend);
      BOOST_TEST(std::abs(exponent.mean - 6) < 0.35);
      BOOST_TEST(std::abs(bend.mean) < 0.5);
      BOOST_TEST(over_replicas(fit.against_power).mean < 1);
    }
  const TailExponent all = tail_exponent(fit_tails(replicas, TailSide::both));
  BOOST_TEST(std::abs(all.estimate.mean - 6) < 0.2);
  BOOST_TEST(all.estimate.error > all.half_spread);
}

BOOST_AUTO_TEST_CASE(student_t_has_its_local_exponents) {
  // -d ln P/d ln u = 4 u^2/(3 + u^2) = 4 x^2/(1 + x^2) with x = u/sigma, sigma^2 = 3. The fourth moment is infinite.
  const auto local = [](double x) { return 4 * x * x / (1 + x * x); };
  const auto replicas = distributions_of([](Generator& g) { return std::student_t_distribution<double>(3)(g); });
  for (const TailFit& fit : fit_tails(replicas, TailSide::both)) {
    const double exponent = over_replicas(fit.exponent).mean;
    BOOST_TEST(exponent > local(fit.window.from) - 0.1);
    BOOST_TEST(exponent < local(fit.window.to) + 0.1);
  }
}

BOOST_AUTO_TEST_CASE(a_stretched_exponential_is_known_from_a_power_law) {
  const auto replicas = distributions_of([](Generator& g) {
    return std::exponential_distribution<double>(1)(g) * (std::bernoulli_distribution(0.5)(g) ? 1 : -1);
  });
  for (const TailFit& fit : fit_tails(replicas, TailSide::both)) {
    const Estimate bend = over_replicas(fit.bend), gain = over_replicas(fit.against_power);
    BOOST_TEST(std::abs(bend.mean - 1) < 0.25);
    BOOST_TEST(gain.mean > 3 * gain.error);
    // Laplace: ln P = -sqrt(2) x
    BOOST_TEST(over_replicas(fit.end_slope).mean == std::sqrt(2.0) * (fit.window.to - fit.window.from),
               boost::test_tools::tolerance(0.35));
  }
}

BOOST_AUTO_TEST_CASE(a_gaussian_tail_has_power_two_and_exponents_that_grow_with_the_window) {
  const auto fits = fit_tails(distributions_of([](Generator& g) { return gaussian(g); }), TailSide::both);
  BOOST_TEST(std::abs(over_replicas(fits[0].bend).mean - 2) < 0.3);
  BOOST_TEST(over_replicas(fits[1].exponent).mean > over_replicas(fits[0].exponent).mean + 1);
  BOOST_TEST(tail_exponent(fits).half_spread > 1);
}

BOOST_AUTO_TEST_CASE(an_empty_tail_has_no_exponent) {
  const auto uniform = [](Generator& g) { return std::uniform_real_distribution<double>(-1, 1)(g); };
  const std::vector<TailFit> fits = fit_tails(distributions_of(uniform, 50), TailSide::both);
  for (const double exponent : fits[0].exponent) BOOST_TEST(std::isnan(exponent));
}

BOOST_AUTO_TEST_CASE(a_record_without_histograms_is_refused) {
  const Record record = made_record(scene, [](const SetTally&) {});
  BOOST_CHECK_THROW(velocity_distribution(record, Velocity::ux, 0), InputError);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace gpf::test
