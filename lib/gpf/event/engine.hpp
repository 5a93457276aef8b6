// The event-driven engine: Lubachevsky's algorithm (thesis sec. 2.3) in the falling frame.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "gpf/base/error.hpp"
#include "gpf/base/hash.hpp"
#include "gpf/event/after_contact.hpp"
#include "gpf/event/calendar_queue.hpp"
#include "gpf/event/cells.hpp"
#include "gpf/event/contact_time.hpp"
#include "gpf/event/disk.hpp"
#include "gpf/event/engine_state.hpp"
#include "gpf/event/fetch.hpp"
#include "gpf/event/huge_pages.hpp"
#include "gpf/event/observer.hpp"
#include "gpf/event/plan.hpp"
#include "gpf/event/position_grid.hpp"
#include "gpf/event/rules.hpp"
#include "gpf/scene/scene.hpp"
#include "gpf/scene/state.hpp"

namespace gpf {

/// Moves the disks of a scene from contact to contact.
///
/// Each disk has one scheduled event: its next contact or its exit from its cell, whichever comes first. A contact is
/// scheduled by the disk that finds it; when its partner has collided in between it is stale and the disk looks again.
/// Time runs in epochs of a power-of-two length: at the start of each all disks are brought to one time, the frame is
/// boosted to the mean flow and everything is predicted anew. Within an epoch a disk's state changes only at contacts
/// (and where it goes round the box), and contact times are a function of states; contacts at equal times have an
/// order of their own. So a trajectory - and its trace_hash() - is a function of (scene, start) alone: not of the
/// queue, the cells, the compiler, or where a run was stopped and resumed.
template <class Queue = CalendarQueue, class Physics = GranularPhysics>
class GPF_LANES Engine {
 public:
  /// Starts from a laboratory-frame state at time 0.
  /// `disks_per_cell` decides about speed only; 0 takes the best. Throws PhysicsError if disks overlap, InputError
  /// if a disk is outside the box or a period is too short.
  Engine(const Scene& scene, const State& start, double disks_per_cell = 0);

  /// Goes on from a checkpoint of the same scene.
  Engine(const Scene& scene, const EngineState& state, double disks_per_cell = 0);

  /// Executes all contacts up to `time` (since the start of the run). Throws PhysicsError on an overlap that round-off
  /// cannot explain, on inelastic collapse, and when time would run backwards.
  template <class Observer = NoObserver>
  void advance(double time, Observer&& observer = {});

  [[nodiscard]] double time() const { return epoch_start() + now_; }
  [[nodiscard]] double epoch_length() const { return epoch_length_; }
  [[nodiscard]] double epoch_end() const { return static_cast<double>(epoch_ + 1) * epoch_length_; }
  [[nodiscard]] bool at_epoch_start() const { return now_ == 0; }
  /// Laboratory frame, at time().
  [[nodiscard]] State state() const;
  /// For a resume to the same bits; only at_epoch_start().
  [[nodiscard]] EngineState checkpoint() const;
  [[nodiscard]] TraceHash trace_hash() const { return trace_; }
  [[nodiscard]] const EventCounts& counts() const { return counts_; }
  /// Most that two disks ever overlapped at their contact, a length (round-off).
  [[nodiscard]] double deepest_overlap() const { return std::max(0.0, deepest_) / (2 * scene_.diameter()); }

  /// Length of an epoch: the power of two next below 32 mean free times and below 2 W/velocity_scale(). Times within it
  /// are then so fine that a thermal disk moves less than 2^-52 W in the last bit of one.
  static double epoch_length(const Scene& scene);

 private:
  /// Larger cells are left less often, smaller ones hold fewer disks out of reach. Measured at area fractions .05, .30
  /// and .70 (N = 10^3) and in channels: 0.8 and 1.0 differ by less than noise, 1.25 is up to 6 % slower.
  static constexpr double best_disks_per_cell = 1;
  /// Cells shrink by the square of crowding(), which is right where nearly all collisions happen in waves or clumps
  /// and leaves a gas as it is; by no more than this, for empty cells take memory too (640 bytes per disk then).
  static constexpr double most_shrinking = 20;
  /// From so many disks on the loop waits for memory rather than for arithmetic, and it pays to fetch ahead: at N =
  /// 10^4 that makes it 1.2 times slower, at 3 10^4 1.06 times, at 10^5 faster (nu .30).
  static constexpr std::int32_t fits_near_memory = 50'000;

  /// What an epoch begins with, by the numbers of the one before. Kept, because memory that is fresh every time costs a
  /// page fault for each 4 kB of it.
  struct Start {
    std::vector<Flight> flights;
    std::vector<Plan> plans;
    std::vector<Index> ids;
  };

  /// An event that is coming, and where it will look.
  struct Coming {
    Index disk = 0, partner = 0;  ///< the same where there is no partner
    bool touches = false;         ///< its partner or a wall; else it leaves its cell
    Cells::Around around{}, partner_around{};
  };

  Disk& disk(Index i) { return disks_[static_cast<std::size_t>(i)]; }
  [[nodiscard]] const Disk& disk(Index i) const { return disks_[static_cast<std::size_t>(i)]; }
  [[nodiscard]] Index count() const { return static_cast<Index>(disks_.size()) - 1; }
  Plan& plan(Index i) { return queue_.plan(i); }
  [[nodiscard]] const Plan& plan(Index i) const { return queue_.plan(i); }
  /// Whether the contact that a disk has found is off, because its partner has had another.
  [[nodiscard]] bool is_stale(const Disk& a) const { return disk(a.partner).events != a.partner_events; }
  [[nodiscard]] bool exits_to_wall(Index i) const { return cells_.is_wall(plan(i).place(), plan(i).side); }
  [[nodiscard]] double epoch_start() const { return static_cast<double>(epoch_) * epoch_length_; }
  [[nodiscard]] double frame_velocity_at(double t) const { return frame_velocity_ + gravity_ * t; }

  /// Into the best cell for the flight that a disk begins.
  void settle(Index i, const Flight& f) {
    Place place = plan(i).place();
    if (cells_.settle(place, i, f)) plan(i).move_to(place);
  }

  template <class Observer>
  void run_until(double until, Observer& observer);
  template <class Observer>
  void collide(Index i, Index j, double t, Observer& observer);
  // Three that stay out of the loop, which has no registers to spare for them.
  template <class Observer>
  [[gnu::noinline]] void bounce(Index i, double t, Observer& observer);
  [[gnu::noinline]] void cross(Index i);
  [[gnu::noinline]] void enter(Index i);
  [[nodiscard]] std::uint64_t rank(Index i) const;
  template <bool are_latest, std::size_t how_many>  // whether the askers have just begun their flights: none is later
  void look(const std::array<Index, how_many>& askers, Block block);
  [[nodiscard]] Flight flown(const Flight& f, double t) const;
  [[gnu::noinline]] void foresee();
  void next_epoch();
  void boost();
  void begin_epoch();
  void settle();
  void watch_for_collapse(double t);
  [[nodiscard]] Vec2 lab_position(const Flight& f, double t) const;
  [[nodiscard]] std::string describe(Index i) const;
  [[noreturn]] void fail_overlap(Index i) const;
  [[noreturn]] void fail_backwards(Index i) const;

  Scene scene_;
  Physics physics_;
  bool channel_, foresees_;
  PositionGrid grid_;
  double length_, lower_, upper_, gravity_, epoch_length_, disks_per_cell_;
  ContactTime contact_time_;
  double most_depth_;  // of an overlap that round-off explains, as deepest_
  Cells cells_;
  Queue queue_;
  std::vector<Disk, HugePages<Disk>> disks_;  // in Cells::order(); the last is nobody
  Start start_;
  std::array<Coming, 8> coming_;  // the last that were named, of named_
  std::uint32_t named_ = 0;
  std::int64_t epoch_ = 0;
  double now_ = 0;  // within the epoch
  double frame_velocity_ = 0, frame_offset_ = 0;
  double deepest_ = 0, watched_ = -1, events_per_time_;
  std::uint64_t events_before_ = 0;
  TraceHash trace_;
  EventCounts counts_;
};

// ---- the loop: next - advance - resolve - observe - predict ----

template <class Queue, class Physics>
template <class Observer>
void Engine<Queue, Physics>::run_until(double until, Observer& observer) {
  const auto first = [this](Index a, Index b) { return rank(a) < rank(b); };
  for (Index i = queue_.earliest(first); i >= 0 && queue_.time(i) <= until; i = queue_.earliest(first)) {
    if (queue_.time(i) < now_) fail_backwards(i);
    now_ = queue_.time(i);
    if (foresees_) foresee();
    const Disk& mine = disk(i);
    if (now_ < mine.contact) {
      if (exits_to_wall(i))
        bounce(i, now_, observer);
      else
        cross(i);
    } else if (is_stale(mine)) {
      ++counts_.stale;
      disk(i).forget();
      look<false>(std::array{i}, Block::all);
    } else {
      collide(i, mine.partner, now_, observer);
    }
  }
  now_ = until;
}

/// Of events at equal times the lowest rank comes first: disks that look again, then pairs by their lower and their
/// higher number, then walls. It knows contacts only, so that a tie cannot let the queue or the cells decide.
template <class Queue, class Physics>
std::uint64_t Engine<Queue, Physics>::rank(Index i) const {
  const Disk& mine = disk(i);
  if (queue_.time(i) < mine.contact)
    return exits_to_wall(i) ? (std::uint64_t{1} << 63) + static_cast<std::uint64_t>(mine.id) : 0;
  if (is_stale(mine)) return 0;
  const auto [low, high] = std::minmax(mine.id, disk(mine.partner).id);
  return (static_cast<std::uint64_t>(low) << 32) + static_cast<std::uint64_t>(high);
}

template <class Queue, class Physics>
template <class Observer>
void Engine<Queue, Physics>::collide(Index i, Index j, double t, Observer& observer) {
  // Observers see the lower number first, whichever of the two found the contact.
  if (disk(i).id > disk(j).id) std::swap(i, j);
  Disk &mine = disk(i), &other = disk(j);
  Flight a = flown(mine.flight, t), b = flown(other.flight, t);
  const auto nearest = [](double r, double period) {
    return 2 * r > period ? r - period : 2 * r < -period ? r + period : r;
  };
  const Vec2 r_12{nearest(b.x - a.x, length_), channel_ ? b.y - a.y : nearest(b.y - a.y, 1)};
  const double depth = square(scene_.diameter()) - dot(r_12, r_12);
  deepest_ = std::max(deepest_, depth);
  if (depth > most_depth_) [[unlikely]]
    fail_overlap(i);
  const double quiet = t - std::max(plan(i).last_contact, plan(j).last_contact);
  const PairOutcome outcome = physics_.pair(r_12, {a.vx - b.vx, a.vy - b.vy}, quiet);
  a.vx -= outcome.impulse.x, a.vy -= outcome.impulse.y;
  b.vx += outcome.impulse.x, b.vy += outcome.impulse.y;
  mine.begin(a), other.begin(b);
  ++mine.events, ++other.events;
  plan(i).last_contact = plan(j).last_contact = t;
  trace_.add(epoch_, t, mine.id, other.id);
  if ((++counts_.pair_contacts & 0xffff) == 0) watch_for_collapse(t);
  const double frame = frame_velocity_at(t);
  observer.on_pair(PairContact{epoch_start() + t,
                               mine.id,
                               other.id,
                               lab_position(a, t),
                               r_12,
                               {a.vx + frame, a.vy},
                               {b.vx + frame, b.vy},
                               outcome.impulse,
                               outcome.energy_loss});
  settle(i, a);
  settle(j, b);
  look<true>(std::array{i, j}, Block::all);
}

template <class Queue, class Physics>
template <class Observer>
void Engine<Queue, Physics>::bounce(Index i, double t, Observer& observer) {
  Disk& mine = disk(i);
  Flight a = flown(mine.flight, t);
  const Wall wall = plan(i).side == Side::lower ? Wall::lower : Wall::upper;
  a.y = wall == Wall::lower ? lower_ : upper_;
  const double frame = frame_velocity_at(t);
  const Vec2 before{a.vx + frame, a.vy};
  const Vec2 after = physics_.wall(before, wall, t - plan(i).last_contact);
  a.vx = after.x - frame, a.vy = after.y;
  mine.begin(a);
  ++mine.events;
  plan(i).last_contact = t;
  trace_.add(epoch_, t, mine.id, wall == Wall::lower ? -1 : -2);
  ++counts_.wall_contacts;
  observer.on_wall(WallContact{epoch_start() + t, mine.id, wall, lab_position(a, t), before, after});
  settle(i, a);
  look<true>(std::array{i}, Block::all);
}

/// Moves the disk into the next cell and looks at the cells that came into reach - or, when the contact that it knew of
/// has become stale, at all of them.
template <class Queue, class Physics>
void Engine<Queue, Physics>::cross(Index i) {
  ++counts_.crossings;
  Disk& mine = disk(i);
  const Side side = plan(i).side;
  Place place = plan(i).place();
  const bool goes_round = cells_.cross(place, i, side, mine.flight);
  plan(i).move_to(place);
  if (goes_round) return enter(i);
  const bool stale = mine.partner >= 0 && is_stale(mine);
  if (stale) mine.forget();
  look<false>(std::array{i}, stale ? Block::all : ahead(side));
}

/// A disk that goes round the box begins a new flight where it enters, because coordinates far outside would not be
/// exact. What was predicted for it is stale.
template <class Queue, class Physics>
void Engine<Queue, Physics>::enter(Index i) {
  const Side side = plan(i).side;
  Disk& mine = disk(i);
  const Flight& f = mine.flight;
  const double x = side == Side::left ? length_ : 0, y = side == Side::lower ? 1 : 0;
  const bool sideways = side == Side::left || side == Side::right;
  mine.begin(flown(f, f.time + (sideways ? (x - f.x) / f.vx : (y - f.y) / f.vy)));
  ++mine.events;
  look<false>(std::array{i}, Block::all);
}

// ---- prediction ----

/// Schedules for each the earliest of the contact known, the contacts with disks of the block of cells (equal times:
/// the lower number first) and the exit from the cell. Those that look together do not see what the others find.
template <class Queue, class Physics>
template <bool are_latest, std::size_t how_many>
void Engine<Queue, Physics>::look(const std::array<Index, how_many>& askers, Block block) {
  std::array<Cells::Question, how_many> questions;
  std::array<double, how_many> exits;
  for (std::size_t k = 0; k < how_many; ++k) {
    const Disk& mine = disk(askers[k]);
    questions[k] = {plan(askers[k]).place(), mine.flight, {mine.contact, mine.partner}};
    const auto exit = cells_.exit(questions[k].place, mine.flight);
    exits[k] = exit.time;
    plan(askers[k]).side = exit.side;
  }
  cells_.template answer<are_latest>(questions, block, disks_.data(), count(), contact_time_);
  for (std::size_t k = 0; k < how_many; ++k) {
    const FoundContact& found = questions[k].contact;
    Disk& mine = disk(askers[k]);
    mine.contact = found.time;
    mine.partner = found.partner;
    if (found.partner >= 0) mine.partner_events = disk(found.partner).events;
    queue_.schedule(askers[k], std::min(exits[k], found.time));
  }
}

/// Free flight to time t of the epoch; displacements are rounded to the grid, so that reflections commute with it.
template <class Queue, class Physics>
Flight Engine<Queue, Physics>::flown(const Flight& f, double t) const {
  const double lapse = t - f.time;
  return {f.x + grid_.round(f.vx * lapse), f.y + grid_.round(f.vy * lapse), f.vx, f.vy, t};
}

/// Asks for the memory that the coming events will read: it takes longer to come than many events last. Each event goes
/// through five stages, one or two events from one to the next. Nothing is repeated an unknown number of times, and
/// little is done or not: guesses that are wrong would cost more than all of this.
template <class Queue, class Physics>
void Engine<Queue, Physics>::foresee() {
  queue_.foresee([this](Index i) {
    const auto named = [this](std::uint32_t events_ago) -> Coming& {
      return coming_[(named_ - events_ago) % coming_.size()];
    };
    ++named_;
    named(0).disk = i;
    fetch(&disk(i));

    Coming& first = named(2);
    const Disk& mine = disk(first.disk);
    const bool meets = queue_.time(first.disk) >= mine.contact;
    const Index partner = std::max(mine.partner, 0);  // who tells whether that contact is stale
    first.touches = meets || exits_to_wall(first.disk);
    first.partner = meets ? partner : first.disk;
    fetch(&disk(partner));
    queue_.fetch_entry(first.partner);

    Coming& second = named(4);
    const Place place = plan(second.disk).place();
    cells_.fetch_cell(place);
    if (second.touches) {
      Place mine_then = place, partner_then = plan(second.partner).place();
      if (cells_.are_roomy()) {
        const double t = std::min(queue_.time(second.disk), epoch_length_);  // it may have none to come any more
        const auto [a, b] = after_contact(disk(second.disk).flight, disk(second.partner).flight, t, scene_.diameter());
        mine_then = cells_.locate(a);
        partner_then = cells_.locate(b);
      }
      second.around = cells_.around(mine_then, Block::all);
      second.partner_around = cells_.around(partner_then, Block::all);
    } else {
      const Side side = plan(second.disk).side;
      second.around = cells_.around(cells_.beyond(place, side).place, ahead(side));
    }

    const Coming& third = named(5);  // so soon: what was just computed is only stored, and nothing waits for it
    if (third.touches) {
      cells_.fetch_cells<9>(third.around);
      cells_.fetch_cells<9>(third.partner_around);
    } else {
      cells_.fetch_cells<3>(third.around);
    }

    const Coming& fourth = named(7);
    if (fourth.touches) {
      cells_.fetch_disks<9>(fourth.around, disks_.data());
      cells_.fetch_disks<9>(fourth.partner_around, disks_.data());
    } else {
      cells_.fetch_disks<3>(fourth.around, disks_.data());
    }
  });
}

}  // namespace gpf

#include "gpf/event/engine_epochs.hpp"
#include "gpf/event/engine_setup.hpp"
