// The same work for several replicas, on all cores.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <future>
#include <thread>
#include <vector>

namespace gpf {

/// Calls f(0) ... f(count - 1), each once, on as many threads as there are cores; all have ended when it returns. What
/// they throw is thrown on, the first one found. f must not change what another call reads.
template <class F>
void for_each_in_parallel(std::size_t count, F&& f) {
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t k = next++; k < count; k = next++) f(k);
  };
  std::vector<std::future<void>> threads;
  const std::size_t cores = std::max(1u, std::thread::hardware_concurrency());
  for (std::size_t k = 0; k < std::min(cores, count); ++k) threads.push_back(std::async(std::launch::async, work));
  for (const std::future<void>& thread : threads) thread.wait();
  for (std::future<void>& thread : threads) thread.get();
}

}  // namespace gpf
