// Records whose histograms of velocities come from known distributions, by way of Distributions::sample.
#pragma once

#include <cstdint>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "gpf/io/record.hpp"

namespace gpf::test {

using Generator = std::mt19937_64;

/// Draws the velocity of a disk in bin `bin`: x about the mean flow, y.
using Draw = std::function<Vec2(Generator&, int bin)>;

/// A record of the scene file `text` with `samples` samples of its disks, evenly spread over the bins; the mean flow
/// is `flow` everywhere.
Record sampled_record(const std::string& text, int samples, std::uint64_t seed, const Draw& draw, double flow = 3);

/// So many of them, with seeds of their own.
std::vector<Record> sampled_records(std::size_t count, const std::string& text, int samples, const Draw& draw);

/// channel_text with the e_n and beta_w of that scene, and so many bins.
std::string channel_scene(double area_fraction, double restitution, double wall_restitution, int bins = 6);

inline double gaussian(Generator& g, double sigma = 1) { return std::normal_distribution<double>(0, sigma)(g); }
/// Two humps at +-1.
double two_humps(Generator& g);
/// ~ |u|^-exponent for |u| > 1 and narrower within, with sigma about .5: a power law from two sigma on.
double power_tail(Generator& g, double exponent);
/// One peak, below 0, and a long tail above; mean 0.
double skewed(Generator& g);

}  // namespace gpf::test
