#include "gpf/stats/jackknife.hpp"

#include <fmt/format.h>

#include <cmath>

#include "gpf/base/error.hpp"
#include "gpf/stats/blocks.hpp"

namespace gpf {

std::vector<Estimate> jackknife(std::span<const double> sums, std::size_t blocks, const Derive& derive) {
  if (blocks == 0 || sums.empty() || sums.size() % blocks != 0) {
    throw InputError(fmt::format("{} sums cannot be split into {} blocks", sums.size(), blocks),
                     "every block holds the same tallies", "pass blocks x tallies numbers, row by row");
  }
  const std::size_t tallies = sums.size() / blocks;
  std::vector<double> total(tallies, 0.0);
  for (std::size_t k = 0; k < sums.size(); ++k) total[k % tallies] += sums[k];
  const std::vector<double> whole = derive(total);

  const double count = static_cast<double>(blocks);
  std::vector<std::vector<double>> pseudo(whole.size(), std::vector<double>(blocks));
  std::vector<double> rest(tallies);
  for (std::size_t b = 0; b < blocks; ++b) {
    for (std::size_t k = 0; k < tallies; ++k) rest[k] = total[k] - sums[b * tallies + k];
    const std::vector<double> without = derive(rest);
    if (without.size() != whole.size()) {
      throw InputError(fmt::format("{} derived quantities became {}", whole.size(), without.size()),
                       "the jackknife compares them one by one", "return NaN for a quantity that is not defined");
    }
    for (std::size_t q = 0; q < whole.size(); ++q) pseudo[q][b] = count * whole[q] - (count - 1) * without[q];
  }

  std::vector<Estimate> estimates(whole.size());
  for (std::size_t q = 0; q < whole.size(); ++q) {
    if (!std::isfinite(whole[q])) continue;  // undefined: stays NaN with NaN
    estimates[q] = {whole[q], block_error(pseudo[q]).error};
  }
  return estimates;
}

}  // namespace gpf
