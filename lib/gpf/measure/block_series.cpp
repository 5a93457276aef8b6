#include "gpf/measure/block_series.hpp"

#include <algorithm>

#include "gpf/base/error.hpp"

namespace gpf {

void BlockSeries::add(std::span<const double> row) {
  for (std::size_t k = 0; k < tallies_; ++k) open_[k] += row[k];
  if (++in_open_ < per_block_) return;
  sums_.insert(sums_.end(), open_.begin(), open_.end());
  std::fill(open_.begin(), open_.end(), 0.0);
  in_open_ = 0;
  if (blocks() < most_blocks) return;
  for (std::size_t b = 0; b < most_blocks / 2; ++b)
    for (std::size_t k = 0; k < tallies_; ++k)
      sums_[b * tallies_ + k] = sums_[2 * b * tallies_ + k] + sums_[(2 * b + 1) * tallies_ + k];
  sums_.resize(most_blocks / 2 * tallies_);
  per_block_ *= 2;
}

std::vector<double> block_totals(std::span<const double> sums, std::size_t tallies) {
  std::vector<double> totals(tallies, 0.0);
  for (std::size_t k = 0; k < sums.size(); ++k) totals[k % tallies] += sums[k];
  return totals;
}

void BlockSeries::restore(const Memory& memory) {
  if (memory.open.size() != tallies_ || memory.sums.size() % tallies_ != 0 || memory.per_block == 0)
    throw InputError("a checkpoint's sums do not fit this run", "it was written for other bins or another version",
                     "start the run anew, without --resume");
  per_block_ = memory.per_block;
  in_open_ = memory.in_open;
  sums_ = memory.sums;
  open_ = memory.open;
}

}  // namespace gpf
