#include <hdf5.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <optional>
#include <utility>

#include "gpf/base/error.hpp"
#include "gpf/io/atomic_file.hpp"
#include "gpf/io/hdf5.hpp"
#include "gpf/io/hdf5_handle.hpp"
#include "gpf/io/hdf5_seal.hpp"

namespace gpf {

using hdf5::check;
using hdf5::Handle;

namespace {

/// Creation properties that keep times out of the file.
Handle timeless(hid_t property_class) {
  Handle properties(H5Pcreate(property_class), H5Pclose);
  check(H5Pset_obj_track_times(properties.get(), false));
  return properties;
}

Handle dataspace(const Dims& dims) {
  if (dims.empty()) return {H5Screate(H5S_SCALAR), H5Sclose};
  const std::vector<hsize_t> lengths(dims.begin(), dims.end());
  return {H5Screate_simple(static_cast<int>(lengths.size()), lengths.data(), nullptr), H5Sclose};
}

/// Creates the groups above `name` (and `name` itself if asked to) that are not there yet.
void make_groups(hid_t file, const std::string& name, bool including_last) {
  if (name.empty() || name.front() != '/') throw hdf5::Failure{"names in a file begin with '/'"};
  for (std::size_t end = name.find('/', 1);; end = name.find('/', end + 1)) {
    if (end == std::string::npos && (!including_last || name.size() == 1)) return;
    const std::string group = name.substr(0, end);
    if (check(H5Lexists(file, group.c_str(), H5P_DEFAULT)) == 0) {
      Handle(H5Gcreate2(file, group.c_str(), H5P_DEFAULT, timeless(H5P_GROUP_CREATE).get(), H5P_DEFAULT), H5Gclose)
          .close();
    }
    if (end == std::string::npos) return;
  }
}

/// Stores `data`, which is laid out as `memory_type`, in a new dataset.
void write_dataset(hid_t file, const std::string& name, hid_t stored_type, hid_t memory_type, const Dims& dims,
                   const void* data) {
  make_groups(file, name, false);
  const Handle space = dataspace(dims);
  Handle dataset(H5Dcreate2(file, name.c_str(), stored_type, space.get(), H5P_DEFAULT,
                            timeless(H5P_DATASET_CREATE).get(), H5P_DEFAULT),
                 H5Dclose);
  check(H5Dwrite(dataset.get(), memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data));
  dataset.close();
}

void write_attribute(hid_t file, const std::string& path, const std::string& name, hid_t stored_type, hid_t memory_type,
                     const Dims& dims, const void* data) {
  make_groups(file, path, true);
  const Handle object(H5Oopen(file, path.c_str(), H5P_DEFAULT), H5Oclose);
  const Handle space = dataspace(dims);
  Handle attribute(H5Acreate2(object.get(), name.c_str(), stored_type, space.get(), H5P_DEFAULT, H5P_DEFAULT),
                   H5Aclose);
  check(H5Awrite(attribute.get(), memory_type, data));
  attribute.close();
}

void refuse_nul(std::string_view text) {
  if (text.find('\0') != std::string_view::npos) throw hdf5::Failure{"the text contains a NUL byte"};
}

}  // namespace

struct Hdf5Writer::File {
  std::filesystem::path path;
  std::optional<Handle> handle;  // empty after commit()

  /// Runs calls of HDF5 with the open file; a failure becomes a StorageError about `object` of this file.
  void apply(const std::string& object, const char* remedy, const std::function<void(hid_t)>& calls) const {
    const hdf5::Quiet quiet;
    try {
      if (!handle) throw hdf5::Failure{"the file has been committed already"};
      calls(handle->get());
    } catch (const hdf5::Failure& failure) {
      throw StorageError("cannot write " + object + " of " + path.string(), failure.why, remedy);
    }
  }

  template <typename T>
  void numbers(const std::string& name, std::span<const T> values, const Dims& dims) const {
    apply("dataset " + name, "give each dataset its own name and as many values as its shape holds", [&](hid_t file) {
      if (values.size() != std::accumulate(dims.begin(), dims.end(), std::uint64_t{1}, std::multiplies<>())) {
        throw hdf5::Failure{std::to_string(values.size()) + " values do not fill the shape"};
      }
      const hdf5::NumberType type = hdf5::number_type<T>();
      write_dataset(file, name, type.stored, type.native, dims, values.data());
    });
  }

  void attribute(const std::string& path_in_file, const std::string& name,
                 const std::function<void(hid_t)>& calls) const {
    apply("attribute " + name + " of " + path_in_file,
          "give each attribute of an object its own name, and store texts beyond 64 kB as datasets", calls);
  }

  template <typename T>
  void number_attribute(const std::string& path_in_file, const std::string& name, std::span<const T> values,
                        const Dims& dims) const {
    attribute(path_in_file, name, [&](hid_t file) {
      const hdf5::NumberType type = hdf5::number_type<T>();
      write_attribute(file, path_in_file, name, type.stored, type.native, dims, values.data());
    });
  }
};

Hdf5Writer::Hdf5Writer(std::filesystem::path path) : file_(std::make_unique<File>()) {
  file_->path = std::move(path);
  const hdf5::Quiet quiet;
  try {
    const Handle creation = timeless(H5P_FILE_CREATE);
    check(H5Pset_userblock(creation.get(), hdf5::seal_size));
    // HDF5 takes two files in memory with the same name for one file, so the name is the address of this object.
    const std::string name = "gpf-writer-" + std::to_string(reinterpret_cast<std::uintptr_t>(file_.get()));
    file_->handle.emplace(H5Fcreate(name.c_str(), H5F_ACC_TRUNC, creation.get(), hdf5::memory_access("").get()),
                          H5Fclose);
  } catch (const hdf5::Failure& failure) {
    throw StorageError("cannot begin " + file_->path.string(), failure.why, "check the memory that is left");
  }
}

Hdf5Writer::~Hdf5Writer() = default;
Hdf5Writer::Hdf5Writer(Hdf5Writer&&) noexcept = default;
Hdf5Writer& Hdf5Writer::operator=(Hdf5Writer&&) noexcept = default;

void Hdf5Writer::write(const std::string& name, std::span<const double> values, const Dims& dims) {
  file_->numbers(name, values, dims);
}
void Hdf5Writer::write(const std::string& name, std::span<const std::int32_t> values, const Dims& dims) {
  file_->numbers(name, values, dims);
}
void Hdf5Writer::write(const std::string& name, std::span<const std::int64_t> values, const Dims& dims) {
  file_->numbers(name, values, dims);
}
void Hdf5Writer::write(const std::string& name, std::span<const std::uint64_t> values, const Dims& dims) {
  file_->numbers(name, values, dims);
}

void Hdf5Writer::write_text(const std::string& name, std::string_view text) {
  file_->apply("text " + name, "give each dataset its own name; texts are UTF-8", [&](hid_t file) {
    refuse_nul(text);
    const Handle type = hdf5::text_type(text.size());
    const char nothing = '\0';  // stands for the empty text, whose type has one byte
    write_dataset(file, name, type.get(), type.get(), {}, text.empty() ? &nothing : text.data());
  });
}

void Hdf5Writer::attribute(const std::string& path, const std::string& name, double value) {
  file_->number_attribute(path, name, std::span<const double>(&value, 1), {});
}
void Hdf5Writer::integer_attribute(const std::string& path, const std::string& name, std::int64_t value) {
  file_->number_attribute(path, name, std::span<const std::int64_t>(&value, 1), {});
}
void Hdf5Writer::integer_attribute(const std::string& path, const std::string& name, std::uint64_t value) {
  file_->number_attribute(path, name, std::span<const std::uint64_t>(&value, 1), {});
}
void Hdf5Writer::attribute(const std::string& path, const std::string& name, std::span<const std::int32_t> values) {
  file_->number_attribute(path, name, values, {values.size()});
}

void Hdf5Writer::attribute(const std::string& path, const std::string& name, std::string_view text) {
  file_->attribute(path, name, [&](hid_t file) {
    refuse_nul(text);
    const Handle type = hdf5::text_type(text.size());
    const char nothing = '\0';
    write_attribute(file, path, name, type.get(), type.get(), {}, text.empty() ? &nothing : text.data());
  });
}

void Hdf5Writer::attribute(const std::string& path, const std::string& name, std::span<const std::string> texts) {
  file_->attribute(path, name, [&](hid_t file) {
    std::size_t longest = 1;
    for (const std::string& text : texts) longest = std::max(longest, text.size());
    std::string padded;
    for (const std::string& text : texts) {
      refuse_nul(text);
      padded += text + std::string(longest - text.size(), '\0');
    }
    const Handle type = hdf5::text_type(longest);
    write_attribute(file, path, name, type.get(), type.get(), {texts.size()}, padded.data());
  });
}

void Hdf5Writer::link(const std::string& existing, const std::string& name) {
  file_->apply("link " + name, "link to a dataset that is there, under a new name", [&](hid_t file) {
    make_groups(file, name, false);
    check(H5Lcreate_hard(file, existing.c_str(), file, name.c_str(), H5P_DEFAULT, H5P_DEFAULT));
  });
}

void Hdf5Writer::commit() {
  std::string bytes(hdf5::seal_size, '\0');
  file_->apply("the content", "check the memory that is left", [&](hid_t file) {
    check(H5Fflush(file, H5F_SCOPE_LOCAL));
    const std::int64_t size = check(H5Fget_file_image(file, nullptr, 0));
    bytes.resize(hdf5::seal_size + static_cast<std::size_t>(size));
    check(H5Fget_file_image(file, bytes.data() + hdf5::seal_size, static_cast<std::size_t>(size)));
    file_->handle->close();
    file_->handle.reset();
  });
  bytes.replace(0, hdf5::seal_size, hdf5::seal(std::string_view(bytes).substr(hdf5::seal_size)));
  write_text_atomically(file_->path, bytes);
}

}  // namespace gpf
