// HDF5 files of our own: written in one step, sealed by a checksum, read with every claim of the file checked.
#pragma once

#include <concepts>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gpf {

/// Lengths of a dataset's axes, slowest first (C order). Empty: a scalar.
using Dims = std::vector<std::uint64_t>;

/// A dataset as read: values in C order, values.size() the product of dims.
template <typename T>
struct Hdf5Array {
  std::vector<T> values;
  Dims dims;
};

/// Builds an HDF5 file in memory and writes it with commit(). Equal content written in equal order gives equal bytes.
///
/// The first 512 bytes (HDF5's user block, which HDF5 programs skip) hold the seal: length and checksum of the rest.
/// Building in memory is deliberate: HDF5 1.10's own writing crashes the process when the disk is full. It costs
/// twice the file's size in memory during commit().
///
/// Names are absolute paths in the file ("/fields/velocity"); missing groups are created. Numbers are stored
/// little-endian. Every failure is a StorageError naming the file and the dataset. Without commit() no file appears.
class Hdf5Writer {
 public:
  explicit Hdf5Writer(std::filesystem::path path);
  ~Hdf5Writer();
  Hdf5Writer(Hdf5Writer&&) noexcept;
  Hdf5Writer& operator=(Hdf5Writer&&) noexcept;

  /// A new dataset; the product of dims must be values.size().
  void write(const std::string& name, std::span<const double> values, const Dims& dims);
  void write(const std::string& name, std::span<const std::int32_t> values, const Dims& dims);
  void write(const std::string& name, std::span<const std::int64_t> values, const Dims& dims);
  void write(const std::string& name, std::span<const std::uint64_t> values, const Dims& dims);

  /// A new dataset with one axis, from a vector, array or span of one of the four types.
  template <typename Range>
  void write(const std::string& name, const Range& values) {
    write(name, std::span(values), Dims{std::size(values)});
  }

  /// A new scalar dataset that holds a UTF-8 text of any length (attributes fail near 64 kB), without NUL bytes.
  void write_text(const std::string& name, std::string_view text);

  /// Attributes of a group or dataset, which is created as a group if it is not there yet. Together at most 64 kB.
  void attribute(const std::string& path, const std::string& name, double value);
  void attribute(const std::string& path, const std::string& name, std::string_view text);
  template <std::integral T>
  void attribute(const std::string& path, const std::string& name, T value) {
    if constexpr (std::signed_integral<T>) {
      integer_attribute(path, name, std::int64_t{value});
    } else {
      integer_attribute(path, name, std::uint64_t{value});
    }
  }
  /// Attributes with one axis (H5MD wants a version number and a list of boundary conditions).
  void attribute(const std::string& path, const std::string& name, std::span<const std::int32_t> values);
  void attribute(const std::string& path, const std::string& name, std::span<const std::string> texts);

  /// A second name for a dataset or group (a hard link).
  void link(const std::string& existing, const std::string& name);

  /// Seals the content and writes it with write_atomically. The writer cannot be used afterwards.
  void commit();

 private:
  void integer_attribute(const std::string& path, const std::string& name, std::int64_t value);
  void integer_attribute(const std::string& path, const std::string& name, std::uint64_t value);

  struct File;
  std::unique_ptr<File> file_;
};

/// Reads a file that Hdf5Writer wrote. The constructor reads it whole and checks the seal before HDF5 sees a byte, so
/// a truncated, damaged or foreign file is an InputError and never a crash inside HDF5. Opening takes three times the
/// file's size in memory; afterwards the file on disk is no longer needed. Asking for what the file does not hold (a
/// name, a type, one value where there are many) is an InputError too, naming file and dataset.
class Hdf5Reader {
 public:
  /// @throws StorageError when the file cannot be read, InputError when it is not a complete gpf file.
  explicit Hdf5Reader(std::filesystem::path path);
  ~Hdf5Reader();
  Hdf5Reader(Hdf5Reader&&) noexcept;
  Hdf5Reader& operator=(Hdf5Reader&&) noexcept;

  [[nodiscard]] bool exists(const std::string& name) const;
  /// Names of the datasets and groups in a group, sorted.
  [[nodiscard]] std::vector<std::string> names_in(const std::string& group) const;

  [[nodiscard]] Hdf5Array<double> doubles(const std::string& name) const;
  [[nodiscard]] Hdf5Array<std::int32_t> int32s(const std::string& name) const;
  [[nodiscard]] Hdf5Array<std::int64_t> int64s(const std::string& name) const;
  [[nodiscard]] Hdf5Array<std::uint64_t> uint64s(const std::string& name) const;
  [[nodiscard]] std::string text(const std::string& name) const;

  [[nodiscard]] bool has_attribute(const std::string& path, const std::string& name) const;
  [[nodiscard]] double attribute_double(const std::string& path, const std::string& name) const;
  [[nodiscard]] std::int64_t attribute_int64(const std::string& path, const std::string& name) const;
  [[nodiscard]] std::uint64_t attribute_uint64(const std::string& path, const std::string& name) const;
  [[nodiscard]] std::string attribute_text(const std::string& path, const std::string& name) const;
  [[nodiscard]] std::vector<std::int32_t> attribute_int32s(const std::string& path, const std::string& name) const;
  [[nodiscard]] std::vector<std::string> attribute_texts(const std::string& path, const std::string& name) const;

 private:
  struct File;
  std::unique_ptr<File> file_;
};

}  // namespace gpf
