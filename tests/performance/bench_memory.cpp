// Nanoseconds for a cache line that is read at random, by the size of the memory that it lies in, and for a word that
// one core waits for from another: what the cost per collision is to be held against (lib/gpf/event/DECISIONS.md).
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <thread>
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
  double alone;                   ///< each read waits for the one before
  double eight_ahead, far_ahead;  ///< fetched 8 and 32 reads ahead
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
  const double began = cpu_nanoseconds();
  for (std::size_t k = 0; k < reads; ++k) at = lines[at].next;
  const double alone = (cpu_nanoseconds() - began) / static_cast<double>(reads);

  order.resize(count + 32);
  std::copy_n(order.begin(), 32, order.begin() + static_cast<std::ptrdiff_t>(count));
  const auto fetched = [&](std::size_t ahead) {
    const std::size_t passes = (reads + count - 1) / count;
    const double start = cpu_nanoseconds();
    for (std::size_t pass = 0; pass < passes; ++pass)
      for (std::size_t k = 0; k < count; ++k) {
        gpf::fetch(&lines[order[k + ahead]]);
        sum += lines[order[k]].next;
      }
    return (cpu_nanoseconds() - start) / static_cast<double>(passes * count);
  };
  const Cost cost{alone, fetched(8), fetched(32)};
  if (at == sum) std::puts("");  // so that no loop is left out
  return cost;
}

/// Two threads that wait for each other's word, as two cores that work on one scene would have to: nanoseconds of wall
/// time for each word.
double cost_of_a_word() {
  constexpr std::int64_t words = 1'000'000;
  alignas(64) std::atomic<std::int64_t> said{0};
  const auto speak = [&said](std::int64_t first) {
    for (std::int64_t word = first; word < words; word += 2) {
      while (said.load(std::memory_order_acquire) != word) {
      }
      said.store(word + 1, std::memory_order_release);
    }
  };
  const auto began = std::chrono::steady_clock::now();
  std::thread other(speak, 1);
  speak(0);
  other.join();
  return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - began).count() / words;
}

}  // namespace

int main(int count, char** arguments) {
  std::printf("%10s %16s %22s %10s\n", "MB", "ns, one by one", "ns, fetched 8 ahead", "32 ahead");
  for (const double megabytes : {0.25, 2.4, 24.0, 240.0}) {
    if (count > 1 && megabytes > std::atof(arguments[1])) continue;
    const Cost cost = cost_of_a_line(static_cast<std::size_t>(megabytes * 1e6));
    std::printf("%10.3g %16.1f %22.1f %10.1f\n", megabytes, cost.alone, cost.eight_ahead, cost.far_ahead);
  }
  if (count == 1 && std::thread::hardware_concurrency() > 1)
    std::printf("a word from one core to another: %.0f ns\n", cost_of_a_word());
}
