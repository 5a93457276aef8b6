// How much denser than the mean it is where disks meet.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "gpf/event/disk.hpp"

namespace gpf {

/// The density in which two disks meet over the mean density, from counts n of disks in boxes of about eight: over all
/// pairs that share a box, the mean number of third disks in it, in units of what a gas without structure has,
/// sum n (n - 1) (n - 2) / sum n (n - 1) / (N/boxes). 1 in a gas, less in packed disks, which leave no gaps, above 10
/// in clumps. A sum of whole numbers, the same in any order of the disks. Boxes from 0 to `length` and `lower` to
/// `upper`; disks a little outside belong to the nearest.
inline double crowding(const std::vector<Flight>& flights, double length, double lower, double upper) {
  const double height = upper - lower, side = std::sqrt(8 * length * height / static_cast<double>(flights.size()));
  const auto boxes = [=](double extent) { return std::max(1.0, std::round(extent / side)); };
  const double columns = boxes(length), rows = boxes(height);
  std::vector<std::uint32_t> disks(static_cast<std::size_t>(columns * rows));
  for (const Flight& f : flights) {
    const double column = std::clamp(std::floor(f.x / length * columns), 0.0, columns - 1);
    const double row = std::clamp(std::floor((f.y - lower) / height * rows), 0.0, rows - 1);
    ++disks[static_cast<std::size_t>(row * columns + column)];
  }
  std::uint64_t pairs = 0, triples = 0;
  for (const std::uint64_t n : disks)
    if (n > 1) pairs += n * (n - 1), triples += n * (n - 1) * (n - 2);
  if (pairs == 0) return 1;
  const double mean = static_cast<double>(flights.size()) / static_cast<double>(disks.size());
  return static_cast<double>(triples) / static_cast<double>(pairs) / mean;
}

}  // namespace gpf
