#include "verify/audit/first_difference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <tuple>

namespace gpf {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

bool same_bits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }
bool same_partners(const TracedContact& a, const TracedContact& b) {
  return a.first == b.first && a.second == b.second;
}
bool same_event(const TracedContact& a, const TracedContact& b) {
  return same_partners(a, b) && same_bits(a.time, b.time) &&
         std::equal(a.velocity.begin(), a.velocity.end(), b.velocity.begin(), same_bits);
}

void sort_by_time(std::vector<TracedContact>& contacts) {
  std::sort(contacts.begin(), contacts.end(), [](const TracedContact& a, const TracedContact& b) {
    return std::tie(a.time, a.first, a.second) < std::tie(b.time, b.first, b.second);
  });
}

/// A velocity near zero, or a time just after the start of the epoch, has last places far finer than the round-off that
/// it inherits: what counts are those of `scale`.
void add(std::vector<NumberDifference>& numbers, std::string name, double before, double after, double scale) {
  if (same_bits(before, after)) return;
  const double place = std::nextafter(scale, infinite) - scale;
  numbers.push_back({std::move(name), before, after, std::abs(after - before) / place,
                     before == 0 ? infinite : std::abs((after - before) / before)});
}

/// What differs between two events of the same partners.
std::vector<NumberDifference> differing_numbers(const TracedContact& a, const TracedContact& b, double epoch_length) {
  std::vector<NumberDifference> numbers;
  add(numbers, "time in the epoch", a.time, b.time, epoch_length);
  double scale = std::numeric_limits<double>::min();
  for (const TracedContact* c : {&a, &b})
    for (const double v : c->velocity) scale = std::max(scale, std::abs(v));
  for (std::size_t k = 0; k < a.velocity.size(); ++k)
    add(numbers, fmt::format("v_{} of disk {}", k % 2 == 0 ? 'x' : 'y', k < 2 ? a.first : a.second), a.velocity[k],
        b.velocity[k], scale);
  return numbers;
}

double largest(const std::vector<NumberDifference>& numbers) {
  double most = 0;
  for (const NumberDifference& n : numbers) most = std::max(most, n.ulps);
  return most;
}

}  // namespace

std::optional<std::size_t> first_differing(std::span<const EpochMark> before, std::span<const EpochMark> after) {
  const std::size_t both = std::min(before.size(), after.size());
  for (std::size_t k = 0; k < both; ++k)
    if (before[k] != after[k]) return k;
  return std::nullopt;
}

std::optional<EventDifference> first_differing(std::vector<TracedContact> before, std::vector<TracedContact> after,
                                               double epoch_length) {
  sort_by_time(before);
  sort_by_time(after);
  std::size_t k = 0;
  while (k < before.size() && k < after.size() && same_event(before[k], after[k])) ++k;
  if (k == before.size() && k == after.size()) return std::nullopt;
  EventDifference found;
  found.event = k + 1;
  if (k < before.size()) found.before = before[k];
  if (k < after.size()) found.after = after[k];
  found.kind = EventDifference::Kind::partners;
  found.largest_ulps = infinite;
  if (k == before.size() || k == after.size()) return found;
  if (same_partners(before[k], after[k])) {
    found.kind = EventDifference::Kind::numbers;
    found.numbers = differing_numbers(before[k], after[k], epoch_length);
  } else if (k + 1 < before.size() && k + 1 < after.size() && same_partners(before[k], after[k + 1]) &&
             same_partners(before[k + 1], after[k])) {
    found.kind = EventDifference::Kind::exchange;
    found.numbers = differing_numbers(before[k], after[k + 1], epoch_length);
    for (NumberDifference& n : differing_numbers(before[k + 1], after[k], epoch_length))
      found.numbers.push_back(std::move(n));
  } else {
    return found;
  }
  found.largest_ulps = largest(found.numbers);
  return found;
}

std::string partners_text(const TracedContact& c) {
  if (c.second >= 0) return fmt::format("disks {} and {}", c.first, c.second);
  return fmt::format("disk {} and the {} wall", c.first, c.second == -1 ? "lower" : "upper");
}

}  // namespace gpf
