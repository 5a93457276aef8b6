#include <hdf5.h>

#include <algorithm>
#include <functional>
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

/// Steps down from the root, because HDF5 only tells whether the last part of a path exists.
bool path_exists(hid_t file, const std::string& name) {
  if (name.empty() || name.front() != '/') throw hdf5::Failure{"names in a file begin with '/'"};
  for (std::size_t end = 0; end != std::string::npos && end + 1 < name.size();) {
    end = name.find('/', end + 1);
    // Negative: the part before is a dataset, which holds nothing.
    if (H5Lexists(file, name.substr(0, end).c_str(), H5P_DEFAULT) <= 0) return false;
  }
  return true;
}

Handle open_object(hid_t file, const std::string& name, H5I_type_t kind, const char* kind_name) {
  if (!path_exists(file, name)) throw hdf5::Failure{"not there"};
  Handle object(H5Oopen(file, name.c_str(), H5P_DEFAULT), H5Oclose);
  if (kind != H5I_BADID && H5Iget_type(object.get()) != kind) throw hdf5::Failure{std::string("not a ") + kind_name};
  return object;
}

/// A dataset or an attribute: HDF5 has the same three questions for both, under different names.
struct Values {
  Handle object;
  hid_t (*type)(hid_t), (*space)(hid_t);
  herr_t (*read)(hid_t object, hid_t memory_type, void* buffer);
  void (*check_place)(hid_t object, std::size_t bytes, std::size_t file_size);
};

/// Where the values of a dataset lie, before HDF5 goes there: all of them in one piece within this file, as we write
/// them. HDF5 1.10 believes a file that says otherwise, and reads beyond it.
void check_place(hid_t dataset, std::size_t bytes, std::size_t file_size) {
  const haddr_t begin = H5Dget_offset(dataset);
  if (begin == HADDR_UNDEF || H5Dget_storage_size(dataset) != bytes || bytes > file_size || begin > file_size - bytes) {
    throw hdf5::Failure{"its values are not in one piece of the file that has the size of its shape"};
  }
}

Values open_dataset(hid_t file, const std::string& name) {
  const auto read = [](hid_t object, hid_t type, void* to) { return H5Dread(object, type, H5S_ALL, H5S_ALL, 0, to); };
  return {open_object(file, name, H5I_DATASET, "dataset"), H5Dget_type, H5Dget_space, read, check_place};
}

Values open_attribute(hid_t file, const std::string& path, const std::string& name) {
  const Handle owner = open_object(file, path, H5I_BADID, "");
  if (check(H5Aexists(owner.get(), name.c_str())) == 0) throw hdf5::Failure{"not there"};
  return {Handle(H5Aopen(owner.get(), name.c_str(), H5P_DEFAULT), H5Aclose), H5Aget_type, H5Aget_space, H5Aread,
          [](hid_t, std::size_t, std::size_t) {}};
}

/// Shape and number of elements. What the file claims must fit into its own size before anything is allocated.
std::pair<Dims, std::size_t> shape(const Values& values, std::size_t element_size, std::size_t file_size) {
  const Handle space(values.space(values.object.get()), H5Sclose);
  if (H5Sget_simple_extent_type(space.get()) == H5S_NULL) throw hdf5::Failure{"it has no elements"};
  std::vector<hsize_t> lengths(static_cast<std::size_t>(check(H5Sget_simple_extent_ndims(space.get()))));
  check(H5Sget_simple_extent_dims(space.get(), lengths.data(), nullptr));
  std::size_t elements = 1;
  const std::size_t limit = file_size / element_size;
  for (const hsize_t length : lengths) {
    if (length > 0 && elements > limit / length)
      throw hdf5::Failure{"it claims more values than the file has room for"};
    elements *= length;
  }
  if (elements > 0) values.check_place(values.object.get(), elements * element_size, file_size);
  return {Dims(lengths.begin(), lengths.end()), elements};
}

template <typename T>
Hdf5Array<T> read_numbers(const Values& values, std::size_t file_size) {
  const hdf5::NumberType expected = hdf5::number_type<T>();
  const Handle type(values.type(values.object.get()), H5Tclose);
  if (check(H5Tequal(type.get(), expected.stored)) == 0) throw hdf5::Failure{std::string("not ") + expected.name};
  auto [dims, elements] = shape(values, sizeof(T), file_size);
  Hdf5Array<T> array{std::vector<T>(elements), std::move(dims)};
  if (elements > 0) check(values.read(values.object.get(), expected.native, array.values.data()));
  return array;
}

template <typename T>
T read_number(const Values& values, std::size_t file_size) {
  const Hdf5Array<T> array = read_numbers<T>(values, file_size);
  if (array.values.size() != 1) throw hdf5::Failure{"not a single value"};
  return array.values.front();
}

std::vector<std::string> read_texts(const Values& values, std::size_t file_size) {
  const Handle type(values.type(values.object.get()), H5Tclose);
  if (H5Tget_class(type.get()) != H5T_STRING || check(H5Tis_variable_str(type.get())) != 0) {
    throw hdf5::Failure{"not a text of fixed length"};
  }
  const std::size_t length = H5Tget_size(type.get());
  if (length == 0 || length > file_size) throw hdf5::Failure{"it claims a longer text than the file has room for"};
  const std::size_t elements = shape(values, length, file_size).second;
  std::string padded(elements * length, '\0');
  if (elements > 0) check(values.read(values.object.get(), hdf5::text_type(length).get(), padded.data()));
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < elements; ++i) {
    const std::string text = padded.substr(i * length, length);
    texts.push_back(text.substr(0, text.find('\0')));
  }
  return texts;
}

std::string read_text_value(const Values& values, std::size_t file_size) {
  std::vector<std::string> texts = read_texts(values, file_size);
  if (texts.size() != 1) throw hdf5::Failure{"not a single text"};
  return std::move(texts.front());
}

}  // namespace

struct Hdf5Reader::File {
  std::filesystem::path path;
  std::size_t size = 0;
  std::optional<Handle> handle;

  /// The result of calls of HDF5; a failure becomes an InputError about `object` of this file.
  template <typename Calls>
  auto apply(const std::string& object, Calls calls) const {
    const hdf5::Quiet quiet;
    try {
      return calls(handle->get());
    } catch (const hdf5::Failure& failure) {
      throw InputError("cannot read " + object + " of " + path.string(), failure.why,
                       "use a file that holds it; h5dump -H lists what is there");
    }
  }

  /// What `read` (one of the functions above) makes of a dataset.
  template <typename Read>
  auto dataset(const std::string& name, Read read) const {
    return apply("dataset " + name, [&](hid_t file) { return read(open_dataset(file, name), size); });
  }

  template <typename Read>
  auto attribute(const std::string& path_in_file, const std::string& name, Read read) const {
    return apply("attribute " + name + " of " + path_in_file,
                 [&](hid_t file) { return read(open_attribute(file, path_in_file, name), size); });
  }
};

Hdf5Reader::Hdf5Reader(std::filesystem::path path) : file_(std::make_unique<File>()) {
  file_->path = std::move(path);
  const std::string bytes = gpf::read_text(file_->path);
  hdf5::check_seal(bytes, file_->path);
  file_->size = bytes.size();
  const hdf5::Quiet quiet;
  try {
    // Not the path: HDF5 takes files in memory with the same name for one file.
    const std::string name = "gpf-reader-" + std::to_string(reinterpret_cast<std::uintptr_t>(file_.get()));
    file_->handle.emplace(H5Fopen(name.c_str(), H5F_ACC_RDONLY, hdf5::memory_access(bytes).get()), H5Fclose);
  } catch (const hdf5::Failure& failure) {
    throw InputError("cannot use " + file_->path.string(), failure.why, "delete it and run again");
  }
}

Hdf5Reader::~Hdf5Reader() = default;
Hdf5Reader::Hdf5Reader(Hdf5Reader&&) noexcept = default;
Hdf5Reader& Hdf5Reader::operator=(Hdf5Reader&&) noexcept = default;

bool Hdf5Reader::exists(const std::string& name) const {
  return file_->apply(name, [&](hid_t file) { return path_exists(file, name); });
}

std::vector<std::string> Hdf5Reader::names_in(const std::string& group) const {
  return file_->apply("group " + group, [&](hid_t file) {
    const Handle opened = open_object(file, group, H5I_GROUP, "group");
    std::vector<std::string> names;
    const auto keep = [](hid_t, const char* name, const H5L_info_t*, void* to) -> herr_t {
      static_cast<std::vector<std::string>*>(to)->emplace_back(name);
      return 0;
    };
    check(H5Literate(opened.get(), H5_INDEX_NAME, H5_ITER_INC, nullptr, keep, &names));
    return names;
  });
}

Hdf5Array<double> Hdf5Reader::doubles(const std::string& name) const {
  return file_->dataset(name, read_numbers<double>);
}
Hdf5Array<std::int32_t> Hdf5Reader::int32s(const std::string& name) const {
  return file_->dataset(name, read_numbers<std::int32_t>);
}
Hdf5Array<std::int64_t> Hdf5Reader::int64s(const std::string& name) const {
  return file_->dataset(name, read_numbers<std::int64_t>);
}
Hdf5Array<std::uint64_t> Hdf5Reader::uint64s(const std::string& name) const {
  return file_->dataset(name, read_numbers<std::uint64_t>);
}
std::string Hdf5Reader::text(const std::string& name) const { return file_->dataset(name, read_text_value); }

bool Hdf5Reader::has_attribute(const std::string& path, const std::string& name) const {
  return file_->apply("attribute " + name + " of " + path, [&](hid_t file) {
    return check(H5Aexists(open_object(file, path, H5I_BADID, "").get(), name.c_str())) > 0;
  });
}
double Hdf5Reader::attribute_double(const std::string& path, const std::string& name) const {
  return file_->attribute(path, name, read_number<double>);
}
std::int64_t Hdf5Reader::attribute_int64(const std::string& path, const std::string& name) const {
  return file_->attribute(path, name, read_number<std::int64_t>);
}
std::uint64_t Hdf5Reader::attribute_uint64(const std::string& path, const std::string& name) const {
  return file_->attribute(path, name, read_number<std::uint64_t>);
}
std::string Hdf5Reader::attribute_text(const std::string& path, const std::string& name) const {
  return file_->attribute(path, name, read_text_value);
}
std::vector<std::int32_t> Hdf5Reader::attribute_int32s(const std::string& path, const std::string& name) const {
  return file_->attribute(path, name, read_numbers<std::int32_t>).values;
}
std::vector<std::string> Hdf5Reader::attribute_texts(const std::string& path, const std::string& name) const {
  return file_->attribute(path, name, read_texts);
}

}  // namespace gpf
