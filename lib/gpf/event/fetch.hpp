// A hint to bring memory near before it is read.
#pragma once

namespace gpf {

/// Asks for the cache line at `address`. The empty assembly keeps GCC 12 from taking a function that only fetches for
/// one without effect, and leaving its calls out.
inline void fetch(const void* address) {
  __builtin_prefetch(address);
  asm volatile("");
}

}  // namespace gpf
