// Error of the mean of a correlated series, by blocking.
#pragma once

#include <cstddef>
#include <span>

namespace gpf {

/// Fewer blocks than this are never used: the error of the error, 1/sqrt(2(n-1)), would exceed 27 %.
inline constexpr std::size_t fewest_blocks = 8;

struct BlockError {
  double mean = 0;         ///< of the whole series
  double error = 0;        ///< standard error of the mean; NaN with fewer than fewest_blocks values
  int blocking_level = 0;  ///< the error is that of blocks of 2^blocking_level values
  std::size_t blocks = 0;  ///< number of those blocks
  bool plateau = false;    ///< false: the series is too short for its correlation, and the error probably too small
};

/// Blocking analysis of Flyvbjerg & Petersen, J. Chem. Phys. 91, 461 (1989): neighbours are averaged in pairs
/// again and again, and the naive error grows until the blocks are independent.
///
/// The level is the first that meets both conditions:
/// - no longer blocks give an error larger by more than its own uncertainty, error/sqrt(2(n-1)). Looking at
///   all levels above, not only at the next, finds a slow mode that is hidden under fast noise;
/// - blocks are at least 4(g - 1) values long, where g = (error/naive error)^2 is the statistical inefficiency
///   that they show. Correlation between neighbouring blocks then hides at most about g/(2 length) = 1/8 of the
///   squared error.
/// When none does, the longest blocks (of which there are at least fewest_blocks) are used, and plateau is false.
///
/// A series that contains NaN gives NaN; an empty one too.
BlockError block_error(std::span<const double> series);

}  // namespace gpf
