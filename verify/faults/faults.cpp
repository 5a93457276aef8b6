// The faults themselves.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "gpf/base/error.hpp"
#include "gpf/base/random.hpp"
#include "gpf/measure/tallies.hpp"
#include "gpf/scene/nearest_word.hpp"
#include "verify/faults/fault.hpp"

namespace gpf {

bool FaultState::happens() {
  const double chance = static_cast<double>(random_words(scene.seed, 0xfa17, drawn++)[0]) * 0x1p-32;
  return chance < dose;
}

namespace {

PairOutcome applied(const PairCall& c) { return c.rule(c.r_12, c.u_12, c.quiet); }
Vec2 applied(const WallCall& c) { return c.rule(c.velocity, c.wall, c.quiet); }

/// The rule of the scene with another restitution.
PairOutcome applied(const PairCall& c, const FaultState& state, double restitution) {
  Scene scene = state.scene;
  scene.normal_restitution = std::clamp(restitution, 0.0, 1.0);
  return SmoothDisks(scene)(c.r_12, c.u_12, c.quiet);
}

Vec2 rotated(Vec2 r, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * r.x - s * r.y, s * r.x + c * r.y};
}

// ---- what is simulated ----

void other_gravity(Scene& scene, Run&, double dose) { scene.gravity *= 1 + dose; }
void larger_disks(Scene& scene, Run&, double dose) { scene.width_over_diameter /= 1 + dose; }
void longer_channel(Scene& scene, Run&, double dose) { scene.length_over_width *= 1 + dose; }
void twice_restituted(Scene& scene, Run&, double dose) {
  scene.normal_restitution = std::pow(scene.normal_restitution, 1 + dose);
}
void restitution_off(Scene& scene, Run&, double dose) {
  if (scene.normal_restitution < 1) scene.normal_restitution = 1 - (1 - scene.normal_restitution) * (1 + dose);
}
void longer_tc(Scene& scene, Run&, double dose) { scene.tc_time *= 1 + dose; }
void no_tc(Scene& scene, Run&, double dose) { scene.tc_time *= 1 - dose; }
void start_up_kept(Scene&, Run& run, double dose) { run.start_up *= 1 - dose; }

// ---- rules ----

PairOutcome missed_dissipation(const PairCall& c, FaultState& state) {
  return state.happens() ? applied(c, state, 1) : applied(c);
}

/// 1 - e grows with a power of the speed of approach, as for viscoelastic disks.
PairOutcome viscoelastic(const PairCall& c, FaultState& state) {
  const double speed = std::abs(dot(c.u_12, c.r_12)) / std::sqrt(dot(c.r_12, c.r_12));
  const double loss = (1 - state.scene.normal_restitution) * std::pow(speed / state.scene.velocity_scale(), state.dose);
  return state.dose == 0 ? applied(c) : applied(c, state, 1 - loss);
}

PairOutcome stale_velocity(const PairCall& c, FaultState& state) {
  PairCall call = c;
  if (state.last_u_12 && state.happens()) {
    // The part along the normal that the disks had, with the rest of an older contact.
    const double approach = std::abs(dot(*state.last_u_12, c.r_12));
    call.u_12 = (approach / dot(c.r_12, c.r_12)) * c.r_12;
  }
  state.last_u_12 = c.u_12;
  return applied(call);
}

PairOutcome off_centre(const PairCall& c, FaultState& state) {
  PairOutcome outcome = applied(c);
  outcome.impulse = rotated(outcome.impulse, state.dose);
  return outcome;
}

PairOutcome rough_disks(const PairCall& c, FaultState& state) {
  PairOutcome outcome = applied(c);
  const Vec2 along = (dot(c.u_12, c.r_12) / dot(c.r_12, c.r_12)) * c.r_12;
  outcome.impulse = outcome.impulse + (0.5 * state.dose) * (c.u_12 - along);
  return outcome;
}

PairOutcome loss_twice(const PairCall& c, FaultState& state) {
  PairOutcome outcome = applied(c);
  outcome.energy_loss *= 1 + state.dose;
  return outcome;
}

Vec2 swapped_components(const WallCall& c, FaultState& state) {
  const double normal = state.scene.wall_normal_restitution;
  const double tangential = state.scene.wall_tangential_restitution[static_cast<std::size_t>(c.wall)];
  const Vec2 right = applied(c);
  const Vec2 wrong{normal * c.velocity.x, -std::max(0.01, tangential) * c.velocity.y};
  return (1 - state.dose) * right + state.dose * wrong;
}

Vec2 tangential_lost(const WallCall& c, FaultState& state) {
  const Vec2 after = applied(c);
  return state.happens() ? Vec2{c.velocity.x, after.y} : after;
}

Vec2 rougher_wall(const WallCall& c, FaultState& state) {
  const Vec2 after = applied(c);
  return {after.x * (1 + state.dose), after.y};
}

Vec2 gaining_wall(const WallCall& c, FaultState& state) {
  const Vec2 after = applied(c);
  return {after.x, after.y * (1 + state.dose)};
}

Vec2 moving_wall(const WallCall& c, FaultState& state) {
  const Vec2 wall{state.dose * state.scene.velocity_scale(), 0};
  return c.rule(c.velocity - wall, c.wall, c.quiet) + wall;
}

Vec2 other_wall(const WallCall& c, FaultState& state) {
  const Vec2 right = applied(c);
  const Vec2 wrong = c.rule(c.velocity, c.wall == Wall::lower ? Wall::upper : Wall::lower, c.quiet);
  return (1 - state.dose) * right + state.dose * wrong;
}

// ---- what is measured ----

int wrong_image(PairContact& c, FaultState& state) {
  const double length = state.scene.length(), beyond = c.position.x + c.r_12.x;
  if ((beyond < 0 || beyond >= length) && state.happens()) c.r_12.x = -c.r_12.x;
  return 1;
}
int no_collisional_stress(PairContact& c, FaultState& state) {
  c.impulse = (1 - state.dose) * c.impulse;
  return 1;
}
int missed_pair(PairContact&, FaultState& state) { return state.happens() ? 0 : 1; }
int doubled_pair(PairContact&, FaultState& state) { return state.happens() ? 2 : 1; }
int missed_wall(WallContact&, FaultState& state) { return state.happens() ? 0 : 1; }

void shifted_bins(State& sampled, FaultState& state) {
  for (Vec2& r : sampled.position) r.y = std::min(r.y + state.dose, std::nextafter(1.0, 0.0));
}
void moving_frame(State& sampled, FaultState& state) {
  for (Vec2& c : sampled.velocity) c.x += state.dose * state.scene.velocity_scale();
}
void old_velocities(State& sampled, FaultState& state) {
  const State now = sampled;
  if (state.last_sampled)
    for (std::size_t i = 0; i < sampled.velocity.size(); ++i)
      sampled.velocity[i] = (1 - state.dose) * sampled.velocity[i] + state.dose * state.last_sampled->velocity[i];
  state.last_sampled = now;
}
void upside_down(State& sampled, FaultState& state) {
  for (Vec2& c : sampled.velocity) c.y *= 1 - 2 * state.dose;
}
void faster(State& sampled, FaultState& state) {
  for (Vec2& c : sampled.velocity) c = (1 + state.dose) * c;
}

// ---- sums ----

/// Calls f(row of sums) for each block.
template <class F>
void each_block(Record& record, F&& f) {
  const TallyLayout layout(record.run);
  for (std::size_t block = 0; block < record.blocks; ++block) {
    const auto row = std::span(record.sums).subspan(block * layout.size(), layout.size());
    f([&](Tally tally, int k) -> double& { return row[layout.at(tally, k)]; });
  }
}

void wrong_mean(Record& record, double dose) {
  double momentum = 0, count = 0;
  each_block(record, [&](auto&& sum) {
    for (int b = 0; b < record.run.bins; ++b) momentum += sum(Tally::cx, b), count += sum(Tally::count, b);
  });
  const double mean = momentum / count;  // that of the channel instead of the bin's
  each_block(record, [&](auto&& sum) {
    for (int b = 0; b < record.run.bins; ++b) {
      const double about = sum(Tally::cx2, b) - 2 * mean * sum(Tally::cx, b) + mean * mean * sum(Tally::count, b);
      sum(Tally::ux2, b) = (1 - dose) * sum(Tally::ux2, b) + dose * about;
    }
  });
}
void biased_variance(Record& record, double dose) {
  each_block(record, [&](auto&& sum) {
    for (int b = 0; b < record.run.bins; ++b)
      sum(Tally::freedom, b) += dose * (sum(Tally::count, b) - sum(Tally::freedom, b));
  });
}
void longer_time(Record& record, double dose) {
  each_block(record, [&](auto&& sum) { sum(Tally::measured_time, 0) *= 1 + dose; });
}
void virial_twice(Record& record, double dose) {
  each_block(record, [&](auto&& sum) { sum(Tally::virial, 0) *= 1 + dose; });
}
void walls_exchanged(Record& record, double dose) {
  each_block(record, [&](auto&& sum) {
    for (const Tally tally : {Tally::wall_contacts, Tally::wall_normal, Tally::wall_tangential, Tally::wall_loss}) {
      const double lower = sum(tally, 0), upper = sum(tally, 1);
      sum(tally, 0) = (1 - dose) * lower + dose * upper;
      sum(tally, 1) = (1 - dose) * upper + dose * lower;
    }
  });
}
void stress_of_other_sign(Record& record, double dose) {
  each_block(record, [&](auto&& sum) {
    for (int b = 0; b < record.run.bins; ++b) sum(Tally::stress_xy, b) *= 1 - 2 * dose;
  });
}

// clang-format off
constexpr std::array all_faults{
    Fault{"g off by 2 %", "gravity is stronger than the scene says", "relative", 0.02, "channels",
          {.scene = other_gravity}},
    Fault{"d off by 0.1 %", "disks are larger than the scene says", "relative", 0.001, "dense scenes",
          {.scene = larger_disks}},
    Fault{"period off by 1 %", "the channel is longer than the scene says", "relative", 0.01, "all scenes",
          {.scene = longer_channel}},
    Fault{"restitution applied twice", "e_n^(1 + dose) for e_n", "how often more", 1, "dissipative scenes",
          {.scene = twice_restituted}},
    Fault{"dissipation off by 10 %", "1 - e_n is larger than the scene says", "relative", 0.1,
          "dissipative scenes", {.scene = restitution_off}},
    Fault{"TC time ten times too long", "contacts are elastic for longer after another one", "times t_c more", 9,
          "dense dissipative scenes", {.scene = longer_tc}},
    Fault{"TC model left out", "contacts dissipate however short the time since the last", "part", 1,
          "dense dissipative scenes", {.scene = no_tc}},
    Fault{"start-up not discarded", "measured from the lattice on", "part of the start-up", 1, "channels",
          {.scene = start_up_kept}},
    Fault{"missed dissipation", "now and then a pair is elastic", "probability", 0.05, "dissipative scenes",
          {.pair = missed_dissipation}},
    Fault{"restitution falls with speed", "1 - e_n grows with a power of the speed of approach", "exponent", 0.2,
          "dissipative scenes", {.pair = viscoelastic}},
    Fault{"a stale event executed", "a pair takes the approach of the contact before", "probability", 0.001,
          "all scenes", {.pair = stale_velocity}},
    Fault{"impulse not along the line of centres", "it is turned", "radians", 0.01, "all scenes",
          {.pair = off_centre}},
    Fault{"disks not smooth", "a part of the tangential velocity is taken too", "part", 0.01, "all scenes",
          {.pair = rough_disks}},
    Fault{"loss counted twice", "pairs lose less than is counted", "how often more", 1, "dissipative scenes",
          {.pair = loss_twice}},
    Fault{"wall rule components swapped", "beta_w acts along the normal, e_w along the wall", "part", 1,
          "channels", {.wall = swapped_components}},
    Fault{"tangential impulse lost", "now and then a wall lets u_x be", "probability", 0.1, "rough walls",
          {.wall = tangential_lost}},
    Fault{"wall rule off by 0.5 %", "u_x after a wall is larger", "relative", 0.005, "smooth walls",
          {.wall = rougher_wall}},
    Fault{"energy gained at walls", "u_y after a wall is larger", "relative", 0.01, "channels",
          {.wall = gaining_wall}},
    Fault{"walls move", "with the flow", "(gW)^(1/2)", 0.1, "channels", {.wall = moving_wall}},
    Fault{"walls exchanged", "each wall has the other's beta_w", "part", 1, "asymmetric scenes",
          {.wall = other_wall}},
    Fault{"image taken from the wrong side", "contacts across the period have r_x of the other sign",
          "probability", 1, "short channels", {.seen_pair = wrong_image}},
    Fault{"stress counted without its collisional part", "impulses of pairs are left out", "part", 1,
          "dense scenes", {.seen_pair = no_collisional_stress}},
    Fault{"missed collision", "now and then a pair's contact is not counted", "probability", 0.02, "all scenes",
          {.seen_pair = missed_pair}},
    Fault{"collision counted twice", "now and then", "probability", 0.02, "all scenes", {.seen_pair = doubled_pair}},
    Fault{"a missed wall event", "now and then a wall's contact is not counted", "probability", 0.02, "channels",
          {.seen_wall = missed_wall}},
    Fault{"one bin shifted", "disks are measured higher up", "W", 1.0 / 18, "channels", {.sampled = shifted_bins}},
    Fault{"frame boost lost", "velocities are measured in a frame that moves", "(gW)^(1/2)", 0.05, "channels",
          {.sampled = moving_frame}},
    Fault{"velocities of the sample before", "positions and velocities of different times", "part", 1,
          "all scenes", {.sampled = old_velocities}},
    Fault{"sign of c_y", "measured with the other sign", "part", 1, "channels", {.sampled = upside_down}},
    Fault{"velocities off by 0.5 %", "measured too large", "relative", 0.005, "all scenes",
          {.sampled = faster}},
    Fault{"fluctuation taken about the wrong mean", "about that of the channel", "part", 1, "channels",
          {.recorded = wrong_mean}},
    Fault{"variance divided by n", "instead of n - 1", "part", 1, "dilute scenes", {.recorded = biased_variance}},
    Fault{"time off by 1 %", "the measured time is counted too long", "relative", 0.01, "all scenes",
          {.recorded = longer_time}},
    Fault{"virial counted once for each disk", "instead of for each pair", "how often more", 1, "periodic scenes",
          {.recorded = virial_twice}},
    Fault{"walls' tallies exchanged", "each wall has the other's impulses", "part", 1, "asymmetric scenes",
          {.recorded = walls_exchanged}},
    Fault{"sign of the shear stress", "P_xy of contacts with the other sign", "part", 1, "channels",
          {.recorded = stress_of_other_sign}},
};
// clang-format on

}  // namespace

std::span<const Fault> faults() { return all_faults; }

const Fault& fault_named(std::string_view name) {
  std::vector<std::string_view> names;
  for (const Fault& fault : all_faults) {
    if (fault.name == name || folder_of(fault) == name) return fault;
    names.push_back(fault.name);
  }
  throw InputError(fmt::format("unknown fault '{}'", name), fmt::format("there are {}", fmt::join(names, ", ")),
                   fmt::format("did you mean '{}'?", nearest_word(std::string(name), names)));
}

double largest_dose(const Fault& fault) {
  const bool bounded =
      fault.dose_means.starts_with("part") || fault.dose_means == "probability" || fault.dose_means == "W";
  return bounded ? 1 : 100 * fault.dose;
}

std::string folder_of(const Fault& fault) {
  std::string name;
  for (const char c : fault.name) {
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    if (letter) name += c;
    if (!letter && !name.empty() && name.back() != '-') name += '-';
  }
  while (!name.empty() && name.back() == '-') name.pop_back();
  return name;
}

}  // namespace gpf
