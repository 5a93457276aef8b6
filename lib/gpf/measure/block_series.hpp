// Sums over consecutive blocks of a run, in bounded memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gpf {

/// Rows of tallies are added one sample interval at a time; when `most_blocks` blocks are full, neighbours are merged
/// and blocks become twice as long. Every complete block covers the same number of intervals.
class BlockSeries {
 public:
  static constexpr std::size_t most_blocks = 256;

  explicit BlockSeries(std::size_t tallies) : tallies_(tallies), open_(tallies, 0.0) {}

  void add(std::span<const double> row);

  [[nodiscard]] std::size_t tallies() const { return tallies_; }
  [[nodiscard]] std::size_t blocks() const { return sums_.size() / tallies_; }  ///< complete ones
  [[nodiscard]] std::span<const double> sums() const { return sums_; }          ///< blocks x tallies, row-major
  [[nodiscard]] std::uint64_t intervals_per_block() const { return per_block_; }

  /// All of it, for a checkpoint.
  struct Memory {
    std::uint64_t per_block, in_open;
    std::vector<double> sums, open;
  };
  [[nodiscard]] Memory memory() const { return {per_block_, in_open_, sums_, open_}; }
  /// Throws InputError when the memory is of other tallies.
  void restore(const Memory& memory);

 private:
  std::size_t tallies_;
  std::uint64_t per_block_ = 1, in_open_ = 0;
  std::vector<double> sums_, open_;
};

/// The sum over all blocks of each tally. `sums` are blocks x tallies, row-major.
std::vector<double> block_totals(std::span<const double> sums, std::size_t tallies);

}  // namespace gpf
