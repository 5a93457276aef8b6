#include "unit/verify/estimators/made_velocities.hpp"

#include <fmt/format.h>

#include <cmath>

#include "gpf/measure/distributions.hpp"
#include "unit/verify/estimators/made_record.hpp"

namespace gpf::test {

Record sampled_record(const std::string& text, int samples, std::uint64_t seed, const Draw& draw, double flow) {
  Record record = made_record(text, [](const SetTally&) {});
  Generator generator(seed);
  State state = record.final_state;
  const std::size_t disks = state.position.size();
  std::vector<double> fluctuation(disks);
  Distributions distributions(record.scene, record.run.bins);
  for (int s = 0; s < samples; ++s) {
    for (std::size_t i = 0; i < disks; ++i) {
      state.position[i].y = (static_cast<double>(i) + 0.5) / static_cast<double>(disks);
      const Vec2 u = draw(generator, static_cast<int>(state.position[i].y * record.run.bins));
      fluctuation[i] = u.x;
      state.velocity[i] = {flow + u.x, u.y};
    }
    if (s == 0) distributions.begin(state);
    distributions.sample(state, fluctuation);
  }
  record.arrays = distributions.arrays();
  return record;
}

std::vector<Record> sampled_records(std::size_t count, const std::string& text, int samples, const Draw& draw) {
  std::vector<Record> records;
  for (std::size_t r = 0; r < count; ++r) records.push_back(sampled_record(text, samples, 1000 + 7 * r, draw));
  return records;
}

std::string channel_scene(double area_fraction, double restitution, double wall_restitution, int bins) {
  return fmt::format(
      "[scene]\ngeometry = \"channel\"\nparticles = 180\nwidth_over_diameter = 12\narea_fraction = {}\n"
      "normal_restitution = {}\nwall_tangential_restitution = {}\n[run]\nstart_up = 2\nduration = 8\nbins = {}\n",
      area_fraction, restitution, wall_restitution, bins);
}

double two_humps(Generator& g) { return gaussian(g, 0.6) + (std::bernoulli_distribution(0.5)(g) ? 1 : -1); }

double power_tail(Generator& g, double exponent) {
  if (std::bernoulli_distribution(0.6)(g)) return gaussian(g, 0.3);
  const double sign = std::bernoulli_distribution(0.5)(g) ? 1 : -1, u = std::uniform_real_distribution<double>(0, 1)(g);
  const double beyond_one = 1 / exponent;  // makes the density continuous at 1
  return sign * (u < beyond_one ? std::pow(u / beyond_one, -1 / (exponent - 1)) : (u - beyond_one) / (1 - beyond_one));
}

double skewed(Generator& g) { return std::gamma_distribution<double>(3, 1)(g) - 3; }

}  // namespace gpf::test
