// Memory for large arrays that are read at random: on huge pages, where the system offers them.
#pragma once

#include <cstddef>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace gpf {

/// An allocator for std::vector. An array of at least one huge page (2 MB) starts at the boundary of one and asks for
/// them: a random read then seldom misses the address translation. A refusal costs speed only.
template <class T>
struct HugePages {
  using value_type = T;
  static constexpr std::size_t page = std::size_t{1} << 21;

  HugePages() = default;
  template <class Other>
  HugePages(const HugePages<Other>&) {}

  static constexpr std::align_val_t alignment(std::size_t bytes) {
    return std::align_val_t{bytes >= page ? page : alignof(T)};
  }

  T* allocate(std::size_t count) {
    std::size_t bytes = count * sizeof(T);
    if (bytes >= page) bytes = (bytes + page - 1) / page * page;  // its end on a huge page too
    void* const memory = ::operator new(bytes, alignment(bytes));
#ifdef MADV_HUGEPAGE
    if (bytes >= page) madvise(memory, bytes, MADV_HUGEPAGE);
#endif
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, std::size_t count) { ::operator delete(memory, alignment(count * sizeof(T))); }

  template <class Other>
  bool operator==(const HugePages<Other>&) const {
    return true;
  }
};

}  // namespace gpf
