// Nanoseconds for a cache line that is read at random, by the size of the memory that it lies in: what the engine's
// cost per collision is to be held against (lib/gpf/event/DECISIONS.md).
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <vector>

#include "gpf/base/random.hpp"
#include "gpf/event/fetch.hpp"
#include "gpf/event/huge_pages.hpp"
#include "performance/machine_state.hpp"

using gpf::performance::cpu_nanoseconds;

namespace {

struct alignas(64) Line {
  std::uint64_t next = 0, unused[7] = {};
};

struct Cost {
  double alone, fetched;  ///< each read waits for the one before; fetched eight reads ahead
};

Cost cost_of_a_line(std::size_t bytes) {
  const std::size_t count = bytes / sizeof(Line), reads = 4'000'000;
  std::vector<Line, gpf::HugePages<Line>> lines(count);
  // One cycle through all lines (Sattolo).
  std::vector<std::uint64_t> order(count);
  std::iota(order.begin(), order.end(), 0);
  for (std::size_t k = count - 1; k > 0; --k) {
    const auto words = gpf::random_words(1, 2, k);
    std::swap(order[k], order[((std::uint64_t{words[0]} << 32) | words[1]) % k]);
  }
  for (std::size_t k = 0; k < count; ++k) lines[order[k]].next = order[(k + 1) % count];

  std::uint64_t at = 0, sum = 0;
  for (std::size_t k = 0; k < reads / 4; ++k) at = lines[at].next;
  double began = cpu_nanoseconds();
  for (std::size_t k = 0; k < reads; ++k) at = lines[at].next;
  const double alone = (cpu_nanoseconds() - began) / static_cast<double>(reads);

  began = cpu_nanoseconds();
  for (std::size_t k = 0; k < reads; ++k) {
    gpf::fetch(&lines[order[(k + 8) % count]]);
    sum += lines[order[k % count]].next;
  }
  const double fetched = (cpu_nanoseconds() - began) / static_cast<double>(reads);
  if (at == sum) std::puts("");  // so that neither loop is left out
  return {alone, fetched};
}

}  // namespace

int main(int count, char** arguments) {
  std::printf("%10s %16s %22s\n", "MB", "ns, one by one", "ns, fetched 8 ahead");
  for (const double megabytes : {0.25, 2.4, 24.0, 240.0}) {
    if (count > 1 && megabytes > std::atof(arguments[1])) continue;
    const Cost cost = cost_of_a_line(static_cast<std::size_t>(megabytes * 1e6));
    std::printf("%10.3g %16.1f %22.1f\n", megabytes, cost.alone, cost.fetched);
  }
}
