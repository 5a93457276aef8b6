#include "gpf/io/hdf5_handle.hpp"

#include <hdf5.h>

#include <algorithm>
#include <new>
#include <type_traits>

namespace gpf::hdf5 {

static_assert(std::is_same_v<hid_t, std::int64_t> && std::is_same_v<herr_t, int>, "HDF5 1.10 or later is needed");

Quiet::Quiet() {
  H5Eget_auto2(H5E_DEFAULT, &handler_, &handler_data_);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Quiet::~Quiet() { H5Eset_auto2(H5E_DEFAULT, handler_, handler_data_); }

namespace {

/// The innermost entry of HDF5's error stack says what actually went wrong; the others who asked for it.
struct Reason {
  std::string why;
  bool no_memory = false;
};
Reason reason() {
  Reason reason;
  const auto keep_first = [](unsigned, const H5E_error2_t* entry, void* out) -> herr_t {
    auto& kept = *static_cast<Reason*>(out);
    kept.why = entry->desc != nullptr ? entry->desc : "";
    kept.no_memory =
        entry->maj_num == H5E_RESOURCE && (entry->min_num == H5E_NOSPACE || entry->min_num == H5E_CANTALLOC);
    return 1;
  };
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_first, &reason);
  reason.why = "HDF5: " + (reason.why.empty() ? "no reason given" : reason.why);
  return reason;
}

}  // namespace

template <typename Result>
Result check(Result result) {
  if (result >= 0) return result;
  const Reason why = reason();
  if (why.no_memory) throw std::bad_alloc();  // no fault of the file: it is not to be deleted
  throw Failure{why.why};
}
template int check(int);
template std::int64_t check(std::int64_t);

template <>
NumberType number_type<double>() {
  return {H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, "64-bit floating point numbers"};
}
template <>
NumberType number_type<std::int32_t>() {
  return {H5T_STD_I32LE, H5T_NATIVE_INT32, "32-bit integers"};
}
template <>
NumberType number_type<std::int64_t>() {
  return {H5T_STD_I64LE, H5T_NATIVE_INT64, "64-bit integers"};
}
template <>
NumberType number_type<std::uint64_t>() {
  return {H5T_STD_U64LE, H5T_NATIVE_UINT64, "64-bit unsigned integers"};
}

Handle text_type(std::size_t length) {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  check(H5Tset_size(type.get(), std::max<std::size_t>(1, length)));
  check(H5Tset_cset(type.get(), H5T_CSET_UTF8));
  check(H5Tset_strpad(type.get(), H5T_STR_NULLPAD));
  return type;
}

Handle memory_access(const std::string& image) {
  constexpr std::size_t growth_step = 1 << 20;
  Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  check(H5Pset_fapl_core(access.get(), growth_step, false));
  check(H5Pset_fclose_degree(access.get(), H5F_CLOSE_STRONG));
  if (!image.empty()) {
    // HDF5 copies the image; its parameter merely lacks the const.
    check(H5Pset_file_image(access.get(), const_cast<char*>(image.data()), image.size()));
  }
  return access;
}

}  // namespace gpf::hdf5
