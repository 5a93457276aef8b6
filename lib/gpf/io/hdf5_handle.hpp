// For the HDF5 writer and reader only: ids that close themselves, failures as exceptions, our number types.
#pragma once

#include <cstdint>
#include <string>
#include <utility>

namespace gpf::hdf5 {

/// A failed HDF5 call, before it is known which file and dataset to name.
struct Failure {
  std::string why;
};

/// Keeps HDF5 from printing its error stack while it lives; the previous handler comes back afterwards.
class Quiet {
 public:
  Quiet();
  ~Quiet();
  Quiet(const Quiet&) = delete;
  Quiet& operator=(const Quiet&) = delete;

 private:
  int (*handler_)(std::int64_t, void*) = nullptr;
  void* handler_data_ = nullptr;
};

/// Passes the result of an HDF5 call on. @throws Failure with HDF5's innermost reason when it is negative;
/// std::bad_alloc when that is want of memory.
template <typename Result>
Result check(Result result);

/// An HDF5 id (hid_t is a std::int64_t) with the function that closes it.
class Handle {
 public:
  using Close = int (*)(std::int64_t);
  Handle(std::int64_t id, Close closer) : id_(check(id)), close_(closer) {}
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
  }

  [[nodiscard]] std::int64_t get() const noexcept { return id_; }
  /// Closes now and reports what closing finds wrong. @throws Failure
  void close() { check(close_(std::exchange(id_, -1))); }

 private:
  std::int64_t id_;
  Close close_;
};

/// How a number is stored in files (little-endian) and held in memory.
struct NumberType {
  std::int64_t stored, native;
  const char* name;
};
template <typename T>
NumberType number_type();

/// A UTF-8 text type of fixed length, padded with NUL; HDF5 has no texts of length zero, so at least one byte.
Handle text_type(std::size_t length);

/// File access in memory. image: bytes of a file to open, or empty for a new one.
Handle memory_access(const std::string& image);

}  // namespace gpf::hdf5
