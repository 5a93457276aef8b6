#include "verify/estimators/departure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "gpf/event/engine.hpp"
#include "gpf/methods/all_pairs.hpp"
#include "gpf/stats/fit.hpp"
#include "verify/estimators/onset.hpp"

namespace gpf {

double distance_between(const Scene& scene, const State& a, const State& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.position.size(); ++i) {
    Vec2 r = a.position[i] - b.position[i];
    r.x -= scene.length() * std::round(r.x / scene.length());
    if (scene.geometry == Geometry::periodic) r.y -= std::round(r.y);
    sum += dot(r, r);
  }
  return std::sqrt(sum / static_cast<double>(a.position.size())) / scene.diameter();
}

namespace {

/// To the 24 bits of a float, by Veltkamp's splitting. (Of a conversion to float and back two at a time gcc 12 makes
/// nothing at all.)
double to_24_bits(double a) {
  const double c = a * (0x1p29 + 1);
  return c - (c - a);
}

}  // namespace

State rounded_to_float(State state) {
  for (auto* vectors : {&state.position, &state.velocity})
    for (Vec2& v : *vectors) v = {to_24_bits(v.x), to_24_bits(v.y)};
  return state;
}

double Departure::contacts_to(double threshold, const std::vector<double>& distance) const {
  // On a logarithmic scale, as distances grow by factors.
  std::vector<double> logarithm;
  for (const double d : distance) logarithm.push_back(std::log(d));
  return onset(contacts, logarithm, std::log(threshold));
}

double Departure::rate(const std::vector<double>& distance, const std::vector<double>& guide, double from,
                       double to) const {
  std::vector<double> x;
  std::vector<Estimate> y;
  for (std::size_t k = 0; k < distance.size(); ++k)
    if (guide[k] > from && guide[k] < to) x.push_back(contacts[k]), y.push_back({std::log(distance[k]), 1});
  return x.size() < 3 ? std::numeric_limits<double>::quiet_NaN() : fit_line(x, y).slope;
}

Departure departure_from(const Scene& scene, const State& start, double threshold, int most) {
  AllPairs<float> single(scene, start);
  AllPairs<double> twofold(scene, start);
  AllPairs<long double> reference(scene, start);
  Engine<> engine(scene, start);
  constexpr int samples = 4;  // per mean free time
  const double step = 1 / (samples * scene.reference_collision_rate());
  Departure d;
  for (int k = 1; k <= most * samples; ++k) {
    const double time = k * step;
    single.advance(time), twofold.advance(time), reference.advance(time), engine.advance(time);
    const State truth = reference.state();
    d.contacts.push_back(2 * static_cast<double>(reference.sums().pair_contacts) / scene.particles);
    d.single.push_back(distance_between(scene, single.state(), truth));
    d.twofold.push_back(distance_between(scene, twofold.state(), truth));
    d.engine.push_back(distance_between(scene, engine.state(), truth));
    if (std::min({d.single.back(), d.twofold.back(), d.engine.back()}) > threshold) break;
  }
  return d;
}

}  // namespace gpf
