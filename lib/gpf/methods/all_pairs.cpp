#include "gpf/methods/all_pairs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "gpf/base/error.hpp"

namespace gpf {
namespace {

template <class Real>
constexpr Real infinite = std::numeric_limits<Real>::infinity();

// Overlap up to this is round-off. Positions gather about the square root of (contacts between a prediction and its
// execution) ulp: below 1000 for 10^6 contacts.
constexpr double tolerance_ulp = 4096;

// The start state comes in double, so that no Real is finer than that.
template <class Real>
constexpr double coarsest_ulp = std::max<double>(std::numeric_limits<double>::epsilon(),
                                                 static_cast<double>(std::numeric_limits<Real>::epsilon()));

// A system whose disks never meet is looked at again for ever; step() gives up after this many looks.
constexpr std::int64_t most_looks = 1'000'000;

void require(bool ok, const char* problem, const char* why, const char* remedy) {
  if (!ok) throw InputError(problem, why, remedy);
}

[[noreturn]] void throw_overlap(std::int32_t i, std::int32_t partner, double depth, double d, double time) {
  const auto with = partner == AllPairsEvent::lower_wall   ? std::string("the lower wall")
                    : partner == AllPairsEvent::upper_wall ? std::string("the upper wall")
                                                           : fmt::format("disk {}", partner);
  throw PhysicsError(
      fmt::format("disk {} overlaps {} by {:.3g} ({:.3g} d) at time {:.17g}", i, with, depth, depth / d, time),
      "deeper than round-off, so a contact was missed or the start overlaps",
      "check the start state; if it is sound, report this as a bug");
}

}  // namespace

template <class Real>
AllPairs<Real>::AllPairs(const Scene& scene, const State& start)
    : scene_(scene),
      periodic_y_(scene.geometry == Geometry::periodic),
      diameter_(static_cast<Real>(scene.diameter())),
      length_(static_cast<Real>(scene.length())),
      gravity_(static_cast<Real>(scene.gravity)),
      tolerance_(static_cast<Real>(tolerance_ulp * coarsest_ulp<Real> * std::max(1.0, scene.length()))),
      closest_square_((diameter_ - tolerance_) * (diameter_ - tolerance_)) {
  const auto count = static_cast<std::size_t>(std::max(0, scene.particles));
  require(count > 0 && start.position.size() == count && start.velocity.size() == count,
          "the start state does not fit the scene", "it must hold a position and a velocity for each disk",
          "give as many of both as the scene has particles, at least one");
  require(length_ > 2 * diameter_ && (!periodic_y_ || 1 > 2 * diameter_), "a period is too short",
          "with two diameters or less the nearest image of a disk is not unique", "use a longer or wider scene");
  disks_.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Vec2 r = start.position[i], u = start.velocity[i];
    require(std::isfinite(r.x) && std::isfinite(r.y) && std::isfinite(u.x) && std::isfinite(u.y),
            "the start state holds a number that is not finite", "nothing can be predicted from it",
            "check how the state was made");
    Disk disk{static_cast<Real>(r.x),
              static_cast<Real>(r.y),
              static_cast<Real>(u.x),
              static_cast<Real>(u.y),
              0,
              0,
              -infinite<long double>,
              0};
    wrap(disk);
    disk.turns = 0;
    disk.start_x = disk.x;
    disks_.push_back(disk);
  }
  candidates_.resize(count);
  predict_all();
}

template <class Real>
AllPairsEvent AllPairs<Real>::step() {
  return *execute_next(infinite<long double>);
}

template <class Real>
void AllPairs<Real>::advance(double until) {
  require(std::isfinite(until) && until >= clock_, "cannot advance to that time", "it is past or not finite",
          "give a finite time that is not before time()");
  while (execute_next(until)) {
  }
}

// The event loop: next - flow - resolve - predict. Returns nothing when no contact comes up to `until`.
template <class Real>
std::optional<AllPairsEvent> AllPairs<Real>::execute_next(long double until) {
  for (std::int64_t looks = 0;; ++looks) {
    const auto first = std::min_element(next_.begin(), next_.end(), [](auto& p, auto& q) { return p.in < q.in; });
    const auto [in, partner] = *first;
    const auto i = static_cast<std::int32_t>(first - next_.begin());
    if (until == infinite<long double> && (in == infinite<Real> || looks == most_looks))
      throw PhysicsError("no contact is to come", "the disks move on tracks that never meet", "use advance() instead");
    if (clock_ + in > until) {
      flow(static_cast<Real>(until - clock_));
      clock_ = until;
      return {};
    }
    flow(in);
    if (partner == look_again) {
      next_[static_cast<std::size_t>(i)] = prediction(i);
      continue;
    }
    if (partner >= 0)
      collide_pair(disk(i), disk(partner));
    else
      collide_wall(disk(i), partner == AllPairsEvent::lower_wall ? lower : upper);
    // Anew: the two disks and all who were to meet one of them. A pair (i, k) with neither stays right, as it is in
    // the entry of whichever of the two was predicted last.
    for (std::int32_t k = 0; k < size(); ++k) {
      auto& next = next_[static_cast<std::size_t>(k)];
      const bool involved = k == i || k == partner || next.partner == i || (partner >= 0 && next.partner == partner);
      if (involved) next = prediction(k);
    }
    const bool ordered = partner < 0 || i < partner;
    return AllPairsEvent{time(), ordered ? i : partner, ordered ? partner : i};
  }
}

// Earliest contact of disk i, or the time to look again. Only nearest images are examined: as long as no pair has moved
// half a period less a diameter, no farther image can have come into contact.
template <class Real>
typename AllPairs<Real>::Next AllPairs<Real>::prediction(std::int32_t i) const {
  const Disk& a = disk(i);
  Next next = periodic_y_ ? Next{infinite<Real>, look_again} : wall_contact(i);
  Real fastest_x = 0, fastest_y = 0;
  std::size_t candidates = 0;
  // Without branches, which nothing could guess: twice as fast.
  for (std::int32_t j = 0; j < size(); ++j) {
    const Approach s = approach(a, disk(j));
    fastest_x = std::max(fastest_x, std::abs(s.ux));
    fastest_y = std::max(fastest_y, std::abs(s.uy));
    candidates_[candidates] = j;
    candidates += static_cast<std::size_t>(((s.rate < 0) & (s.discriminant >= 0)) | (s.square < closest_square_));
  }
  for (std::size_t c = 0; c < candidates; ++c) {
    const std::int32_t j = candidates_[c];
    if (j == i) continue;
    const Real in = pair_contact(i, j);
    if (in < next.in) next = {in, j};
  }
  const Real reach_x = length_ / 2 - diameter_, reach_y = Real(0.5) - diameter_;
  if (fastest_x > 0 && reach_x < next.in * fastest_x) next = {reach_x / fastest_x, look_again};
  if (periodic_y_ && fastest_y > 0 && reach_y < next.in * fastest_y) next = {reach_y / fastest_y, look_again};
  return next;
}

// How a and the nearest image of b move towards each other. Gravity moves both alike and drops out.
template <class Real>
typename AllPairs<Real>::Approach AllPairs<Real>::approach(const Disk& a, const Disk& b) const {
  const Offset r = nearest_image(a, b);
  const Real ux = b.ux - a.ux, uy = b.uy - a.uy;
  const Real square = r.x * r.x + r.y * r.y, gap = square - diameter_ * diameter_, rate = r.x * ux + r.y * uy;
  return {ux, uy, square, gap, rate, rate * rate - (ux * ux + uy * uy) * gap};
}

// Eq. 2.6e in the form that does not cancel, for disks that come closer and meet.
template <class Real>
Real AllPairs<Real>::pair_contact(std::int32_t i, std::int32_t j) const {
  const Approach s = approach(disk(i), disk(j));
  if (s.square < closest_square_)
    throw_overlap(std::min(i, j), std::max(i, j), static_cast<double>(diameter_ - std::sqrt(s.square)),
                  scene_.diameter(), time());
  if (s.gap <= 0) return 0;  // in contact, or a few ulp inside it, and still approaching
  return s.gap / (std::sqrt(s.discriminant) - s.rate);
}

template <class Real>
typename AllPairs<Real>::Next AllPairs<Real>::wall_contact(std::int32_t i) const {
  const Disk& a = disk(i);
  const Real above = a.y - diameter_ / 2, below = 1 - diameter_ / 2 - a.y;
  if (above < -tolerance_)
    throw_overlap(i, AllPairsEvent::lower_wall, static_cast<double>(-above), scene_.diameter(), time());
  if (below < -tolerance_)
    throw_overlap(i, AllPairsEvent::upper_wall, static_cast<double>(-below), scene_.diameter(), time());
  if (a.uy < 0) return {std::max(above, Real(0)) / -a.uy, AllPairsEvent::lower_wall};
  if (a.uy > 0) return {std::max(below, Real(0)) / a.uy, AllPairsEvent::upper_wall};
  return {infinite<Real>, look_again};
}

template <class Real>
void AllPairs<Real>::predict_all() {
  next_.clear();
  for (std::int32_t i = 0; i < size(); ++i) next_.push_back(prediction(i));
}

// From a to the nearest image of b; both lie in the period, so that one shift is enough.
template <class Real>
typename AllPairs<Real>::Offset AllPairs<Real>::nearest_image(const Disk& a, const Disk& b) const {
  const auto fold = [](Real s, Real period) {  // without branches: a quarter faster
    return s - period * static_cast<Real>((s > period / 2) - (s < -period / 2));
  };
  return {fold(b.x - a.x, length_), periodic_y_ ? fold(b.y - a.y, Real(1)) : b.y - a.y};
}

// Eq. 2.8.
template <class Real>
void AllPairs<Real>::flow(Real dt) {
  const bool clock_moves = clock_ + dt > clock_;
  clock_ += dt;
  for (Disk& a : disks_) {
    a.x += (a.ux + gravity_ * dt / 2) * dt;
    a.ux += gravity_ * dt;
    a.y += a.uy * dt;
    wrap(a);
    if (clock_moves) a.contacts_now = 0;
  }
  for (Next& next : next_) next.in -= dt;
}

template <class Real>
void AllPairs<Real>::wrap(Disk& a) const {
  if (a.x < 0 || a.x >= length_) {
    const Real turns = std::floor(a.x / length_);
    a.x -= turns * length_;
    a.turns += static_cast<std::int64_t>(turns);
    if (a.x < 0) a.x = 0;  // both only by round-off
    if (a.x >= length_) a.x = 0, ++a.turns;
  }
  if (periodic_y_ && (a.y < 0 || a.y >= 1)) {
    a.y -= std::floor(a.y);
    if (a.y >= 1) a.y = 0;
  }
}

// Eqs. 2.3 to 2.5, the normal n from a to b.
template <class Real>
void AllPairs<Real>::collide_pair(Disk& a, Disk& b) {
  const Offset r = nearest_image(a, b);
  const Real distance = std::sqrt(r.x * r.x + r.y * r.y), nx = r.x / distance, ny = r.y / distance;
  const Real e = recent(a) || recent(b) ? 1 : static_cast<Real>(scene_.normal_restitution);
  const Real approach = (a.ux - b.ux) * nx + (a.uy - b.uy) * ny;
  const Real impulse = (1 + e) / 2 * approach;
  a.ux -= impulse * nx, a.uy -= impulse * ny;
  b.ux += impulse * nx, b.uy += impulse * ny;
  stamp(a, e == 1), stamp(b, e == 1);
  ++sums_.pair_contacts;
  sums_.pair_loss += static_cast<double>((1 - e * e) * approach * approach / 4);
  sums_.virial += static_cast<double>(impulse * distance);
  if (watcher_ == nullptr) return;
  const auto vec2 = [](Real x, Real y) { return Vec2{static_cast<double>(x), static_cast<double>(y)}; };
  PairContact shown{time(),
                    number(a),
                    number(b),
                    vec2(a.x, a.y),
                    vec2(r.x, r.y),
                    vec2(a.ux, a.uy),
                    vec2(b.ux, b.uy),
                    vec2(impulse * nx, impulse * ny),
                    static_cast<double>((1 - e * e) * approach * approach / 4)};
  if (shown.first > shown.second) {
    std::swap(shown.first, shown.second);
    std::swap(shown.velocity_1, shown.velocity_2);
    shown.position = vec2(b.x, b.y);
    shown.r_12 = -shown.r_12;
    shown.impulse = -shown.impulse;
  }
  watcher_->on_pair(shown);
}

// Eq. 2.9.
template <class Real>
void AllPairs<Real>::collide_wall(Disk& a, Wall wall) {
  const auto side = static_cast<std::size_t>(wall);
  const Real beta = static_cast<Real>(scene_.wall_tangential_restitution[side]);
  const Real e = recent(a) ? 1 : static_cast<Real>(scene_.wall_normal_restitution);
  AllPairsWall& sums = sums_.wall[side];
  ++sums.contacts;
  sums.loss += static_cast<double>(((1 - beta * beta) * a.ux * a.ux + (1 - e * e) * a.uy * a.uy) / 2);
  sums.normal_impulse += static_cast<double>((1 + e) * std::abs(a.uy));
  sums.tangential_impulse += static_cast<double>((1 - beta) * a.ux);
  const auto velocity = [&a] { return Vec2{static_cast<double>(a.ux), static_cast<double>(a.uy)}; };
  const Vec2 before = velocity();
  a.ux = beta * a.ux;
  a.uy = -e * a.uy;
  stamp(a, e == 1);
  if (watcher_ != nullptr)
    watcher_->on_wall(
        {time(), number(a), wall, {static_cast<double>(a.x), static_cast<double>(a.y)}, before, velocity()});
}

template <class Real>
bool AllPairs<Real>::recent(const Disk& a) const {
  return scene_.tc_time > 0 && clock_ - a.last_contact <= scene_.tc_time;
}

// Contacts of one disk in one instant. Elastic disks that meet on a line need at most 2 (N - 1) each (as points that
// pass through each other). Inelastic ones that come ever faster are a collapse: when gaps have shrunk to round-off the
// clock stands still, while velocities have 8 decades to go; three disks in a line then make about 25 more contacts.
template <class Real>
void AllPairs<Real>::stamp(Disk& a, bool elastic) {
  a.last_contact = clock_;
  if (++a.contacts_now > (elastic ? 2 * size() + 100 : 8))
    throw PhysicsError(
        fmt::format("disk {} had {} contacts while time stood still at {:.17g}", number(a), a.contacts_now, time()),
        "inelastic collapse", "set tc_time in the scene, or a longer one");
}

template <class Real>
void AllPairs<Real>::reverse() {
  for (Disk& a : disks_) {
    a.ux = -a.ux, a.uy = -a.uy;
    a.last_contact = -infinite<long double>;
  }
  predict_all();
}

template <class Real>
State AllPairs<Real>::state() const {
  const auto inside = [](Real s, double period) {
    return static_cast<double>(s) < period ? static_cast<double>(s) : 0.0;
  };
  State state;
  for (const Disk& a : disks_) {
    const double y = periodic_y_ ? inside(a.y, 1) : static_cast<double>(a.y);
    state.position.push_back({inside(a.x, scene_.length()), y});
    state.velocity.push_back({static_cast<double>(a.ux), static_cast<double>(a.uy)});
  }
  return state;
}

template <class Real>
double AllPairs<Real>::energy() const {
  Real sum = 0;
  for (const Disk& a : disks_) sum += (a.ux * a.ux + a.uy * a.uy) / 2;
  return static_cast<double>(sum);
}

template <class Real>
double AllPairs<Real>::gravity_work() const {
  Real sum = 0;
  for (const Disk& a : disks_) sum += a.x - a.start_x + static_cast<Real>(a.turns) * length_;
  return static_cast<double>(gravity_ * sum);
}

template class AllPairs<float>;
template class AllPairs<double>;
template class AllPairs<long double>;

}  // namespace gpf
