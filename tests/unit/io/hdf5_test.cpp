#include "gpf/io/hdf5.hpp"

#include <array>
#include <bit>
#include <boost/test/unit_test.hpp>
#include <chrono>
#include <cstring>
#include <limits>
#include <thread>

#include "gpf/base/error.hpp"
#include "gpf/io/atomic_file.hpp"
#include "gpf/io/hdf5_seal.hpp"
#include "gpf/io/subprocess.hpp"
#include "unit/io/temporary_folder.hpp"

namespace {

using gpf::Dims;
using gpf::Hdf5Reader;
using gpf::Hdf5Writer;
using gpf::InputError;
using gpf::StorageError;
using gpf::test::TemporaryFolder;

using Double = std::numeric_limits<double>;

BOOST_AUTO_TEST_SUITE(hdf5)

BOOST_AUTO_TEST_CASE(doubles_keep_their_bits_and_shape) {
  const TemporaryFolder folder;
  const std::vector<double> values{0.1,
                                   -0.0,
                                   Double::denorm_min(),
                                   Double::max(),
                                   1e-5,
                                   -Double::infinity(),
                                   3,
                                   4,
                                   std::bit_cast<double>(0x7ff8000000000abcULL)};
  const std::vector<double> cube{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
  {
    Hdf5Writer file(folder / "a.h5");
    file.write("/deep/er/square", values, {3, 3});
    file.write("/cube", cube, {2, 3, 2});
    file.write("/row", cube);
    file.write("/scalar", std::array{2.5}, Dims{});
    file.write("/nothing", std::vector<double>{});
    file.write("/no_rows", std::vector<double>{}, {0, 4});
    file.commit();
  }
  const Hdf5Reader file(folder / "a.h5");
  const auto square = file.doubles("/deep/er/square");
  BOOST_TEST((square.dims == Dims{3, 3}));
  BOOST_TEST_REQUIRE(square.values.size() == values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    BOOST_TEST(std::bit_cast<std::uint64_t>(square.values[i]) == std::bit_cast<std::uint64_t>(values[i]));
  }
  BOOST_TEST((file.doubles("/cube").dims == Dims{2, 3, 2}));
  BOOST_TEST(file.doubles("/cube").values == cube);
  BOOST_TEST((file.doubles("/row").dims == Dims{12}));
  BOOST_TEST(file.doubles("/scalar").dims.empty());
  BOOST_TEST(file.doubles("/scalar").values == std::vector{2.5});
  BOOST_TEST((file.doubles("/nothing").dims == Dims{0}));
  BOOST_TEST((file.doubles("/no_rows").dims == Dims{0, 4}));
  BOOST_TEST(file.doubles("/no_rows").values.empty());
}

BOOST_AUTO_TEST_CASE(integers_keep_their_extremes) {
  const TemporaryFolder folder;
  using std::numeric_limits;
  const std::vector<std::int32_t> small{numeric_limits<std::int32_t>::min(), -1, numeric_limits<std::int32_t>::max()};
  const std::vector<std::int64_t> large{numeric_limits<std::int64_t>::min(), -1, numeric_limits<std::int64_t>::max()};
  const std::vector<std::uint64_t> positive{0, numeric_limits<std::uint64_t>::max()};
  Hdf5Writer writer(folder / "a.h5");
  writer.write("/i32", small);
  writer.write("/i64", large);
  writer.write("/u64", positive);
  writer.commit();
  const Hdf5Reader file(folder / "a.h5");
  BOOST_TEST(file.int32s("/i32").values == small);
  BOOST_TEST(file.int64s("/i64").values == large);
  BOOST_TEST(file.uint64s("/u64").values == positive);
}

BOOST_AUTO_TEST_CASE(texts_of_any_length) {
  const TemporaryFolder folder;
  const std::string long_text(200000, 's');  // three times what an attribute holds
  Hdf5Writer writer(folder / "a.h5");
  writer.write_text("/long", long_text);
  writer.write_text("/empty", "");
  writer.write_text("/scene", "W/d = 31\n\xce\xbd = 0.56\n");
  writer.commit();
  const Hdf5Reader file(folder / "a.h5");
  BOOST_TEST((file.text("/long") == long_text));
  BOOST_TEST(file.text("/empty").empty());
  BOOST_TEST(file.text("/scene") == "W/d = 31\n\xce\xbd = 0.56\n");
}

BOOST_AUTO_TEST_CASE(attributes_of_groups_and_datasets) {
  const TemporaryFolder folder;
  const std::vector<std::string> boundaries{"periodic", "", "none"};
  Hdf5Writer writer(folder / "a.h5");
  writer.write("/data", std::vector{1.0});
  writer.attribute("/data", "unit", "sqrt(g W)");
  writer.attribute("/", "seed", std::numeric_limits<std::uint64_t>::max());
  writer.attribute("/new/group", "offset", -5);
  writer.attribute("/new/group", "temperature", 0.1);
  writer.attribute("/new/group", "empty", std::string());
  writer.attribute("/new/group", "version", std::array<std::int32_t, 2>{1, 1});
  writer.attribute("/new/group", "boundary", boundaries);
  writer.commit();
  const Hdf5Reader file(folder / "a.h5");
  BOOST_TEST(file.attribute_text("/data", "unit") == "sqrt(g W)");
  BOOST_TEST(file.attribute_uint64("/", "seed") == std::numeric_limits<std::uint64_t>::max());
  BOOST_TEST(file.attribute_int64("/new/group", "offset") == -5);
  BOOST_TEST(file.attribute_double("/new/group", "temperature") == 0.1);
  BOOST_TEST(file.attribute_text("/new/group", "empty").empty());
  BOOST_TEST(file.attribute_int32s("/new/group", "version") == (std::vector{1, 1}));
  BOOST_TEST(file.attribute_texts("/new/group", "boundary") == boundaries);
  BOOST_TEST(file.has_attribute("/", "seed"));
  BOOST_TEST(!file.has_attribute("/", "absent"));
}

BOOST_AUTO_TEST_CASE(names_and_links) {
  const TemporaryFolder folder;
  Hdf5Writer writer(folder / "a.h5");
  writer.write("/b/step", std::vector{1.0, 2.0});
  writer.link("/b/step", "/a/c/step");
  writer.commit();
  const Hdf5Reader file(folder / "a.h5");
  BOOST_TEST(file.names_in("/") == (std::vector<std::string>{"a", "b"}));
  BOOST_TEST(file.names_in("/a") == std::vector<std::string>{"c"});
  BOOST_TEST(file.doubles("/a/c/step").values == (std::vector{1.0, 2.0}));
  BOOST_TEST(file.exists("/"));
  BOOST_TEST(file.exists("/a/c"));
  BOOST_TEST(file.exists("/b/step"));
  BOOST_TEST(!file.exists("/b/step/deeper"));
  BOOST_TEST(!file.exists("/x"));
  BOOST_TEST(!file.exists("/x/y"));
}

/// One file with everything in it.
void write_sample(const std::filesystem::path& path, double value) {
  Hdf5Writer writer(path);
  writer.write("/group/values", std::vector{value, 2.0, 3.0});
  writer.write("/counts", std::vector<std::int64_t>{1, 2});
  writer.write_text("/scene", "text");
  writer.attribute("/group", "seed", 7);
  writer.commit();
}

BOOST_AUTO_TEST_CASE(equal_content_gives_equal_bytes) {
  const TemporaryFolder folder;
  write_sample(folder / "a.h5", 1);
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // HDF5 counts its times in seconds
  write_sample(folder / "b.h5", 1);
  write_sample(folder / "c.h5", 1.5);
  BOOST_TEST((gpf::read_text(folder / "a.h5") == gpf::read_text(folder / "b.h5")));
  BOOST_TEST((gpf::read_text(folder / "a.h5") != gpf::read_text(folder / "c.h5")));
}

BOOST_AUTO_TEST_CASE(hdf5_tools_read_the_files) {
  const TemporaryFolder folder;
  write_sample(folder / "a.h5", 1);
  const auto dump = gpf::run_program({"h5dump", "-d", "/group/values", (folder / "a.h5").string()}, "");
  BOOST_TEST(dump.exit_status == 0);
  BOOST_TEST(dump.output.find("1, 2, 3") != std::string::npos, dump.output << dump.errors);
}

BOOST_AUTO_TEST_CASE(nothing_appears_without_commit) {
  const TemporaryFolder folder;
  {
    Hdf5Writer writer(folder / "a.h5");
    writer.write("/x", std::vector{1.0});
  }
  BOOST_TEST(folder.names().empty());
}

BOOST_AUTO_TEST_CASE(files_of_the_same_name_do_not_mix) {
  const TemporaryFolder folder;
  write_sample(folder / "a.h5", 1);
  const Hdf5Reader before(folder / "a.h5");
  Hdf5Writer one(folder / "a.h5"), two(folder / "a.h5");
  one.write("/group/values", std::vector{10.0});
  two.write("/group/values", std::vector{20.0});
  one.commit();
  const Hdf5Reader first(folder / "a.h5");
  two.commit();
  const Hdf5Reader second(folder / "a.h5");
  BOOST_TEST(before.doubles("/group/values").values.front() == 1);
  BOOST_TEST(first.doubles("/group/values").values.front() == 10);
  BOOST_TEST(second.doubles("/group/values").values.front() == 20);
}

/// Whether the error names the file and the object in it and gives a reason and a remedy.
auto names(const std::string& object) {
  return [=](const gpf::Error& error) {
    const bool complete = error.problem().find("a.h5") != std::string::npos &&
                          error.problem().find(object) != std::string::npos && !error.why().empty() &&
                          !error.remedy().empty();
    BOOST_TEST(complete, error.what());
    return complete;
  };
}

BOOST_AUTO_TEST_CASE(wrong_writes_are_storage_errors) {
  const TemporaryFolder folder;
  const std::vector<double> six(6);
  Hdf5Writer writer(folder / "a.h5");
  writer.write("/data", six);
  BOOST_CHECK_EXCEPTION(writer.write("/data", six), StorageError, names("/data"));
  BOOST_CHECK_EXCEPTION(writer.write("/data/below", six), StorageError, names("/data/below"));
  BOOST_CHECK_EXCEPTION(writer.write("/shape", six, {4, 2}), StorageError, names("/shape"));
  BOOST_CHECK_EXCEPTION(writer.write("/shape", six, {}), StorageError, names("/shape"));
  BOOST_CHECK_EXCEPTION(writer.write("relative", six), StorageError, names("relative"));
  BOOST_CHECK_EXCEPTION(writer.write("", six), StorageError, names("dataset"));
  BOOST_CHECK_EXCEPTION(writer.write("/", six), StorageError, names("/"));
  BOOST_CHECK_EXCEPTION(writer.write_text("/nul", std::string(3, '\0')), StorageError, names("/nul"));
  BOOST_CHECK_EXCEPTION(writer.link("/absent", "/name"), StorageError, names("/name"));
  BOOST_CHECK_EXCEPTION(writer.attribute("/", "long", std::string(70000, 'x')), StorageError, names("long"));
  writer.attribute("/", "twice", 1);
  BOOST_CHECK_EXCEPTION(writer.attribute("/", "twice", 1), StorageError, names("twice"));
  writer.commit();
  BOOST_CHECK_EXCEPTION(writer.write("/late", six), StorageError, names("/late"));
  BOOST_CHECK_EXCEPTION(writer.commit(), StorageError, names("content"));
  BOOST_TEST(Hdf5Reader(folder / "a.h5").doubles("/data").values == six);  // the failures did no harm

  Hdf5Writer nowhere(folder / "no/a.h5");
  BOOST_CHECK_EXCEPTION(nowhere.commit(), StorageError, names("a.h5"));
}

BOOST_AUTO_TEST_CASE(wrong_reads_are_input_errors) {
  const TemporaryFolder folder;
  Hdf5Writer writer(folder / "a.h5");
  writer.write("/group/data", std::vector{1.0, 2.0});
  writer.write_text("/text", "text");
  writer.attribute("/group", "number", 1.5);
  writer.attribute("/group", "pair", std::array<std::int32_t, 2>{1, 2});
  writer.commit();
  const Hdf5Reader file(folder / "a.h5");
  BOOST_CHECK_EXCEPTION(static_cast<void>(file.doubles("/absent")), InputError, names("/absent"));
  BOOST_CHECK_EXCEPTION(static_cast<void>(file.doubles("/group")), InputError, names("/group"));
  BOOST_CHECK_EXCEPTION(static_cast<void>(file.doubles("/group/data/x")), InputError, names("/group/data/x"));
  BOOST_CHECK_EXCEPTION(static_cast<void>(file.doubles("data")), InputError, names("data"));
  BOOST_CHECK_EXCEPTION(static_cast<void>(file.doubles("/text")), InputError, names("/text"));
  BOOST_CHECK_EXCEPTION(static_cast<void>(file.int64s("/group/data")), InputError, names("/group/data"));
  BOOST_CHECK_EXCEPTION(static_cast<void>(file.text("/group/data")), InputError, names("/group/data"));
  BOOST_CHECK_EXCEPTION(static_cast<void>(file.names_in("/group/data")), InputError, names("/group/data"));
  BOOST_CHECK_EXCEPTION(static_cast<void>(file.attribute_double("/group", "absent")), InputError, names("absent"));
  BOOST_CHECK_EXCEPTION(static_cast<void>(file.attribute_double("/absent", "number")), InputError, names("/absent"));
  BOOST_CHECK_EXCEPTION(static_cast<void>(file.attribute_int64("/group", "number")), InputError, names("number"));
  BOOST_CHECK_EXCEPTION(static_cast<void>(file.attribute_text("/group", "number")), InputError, names("number"));
  BOOST_CHECK_EXCEPTION(static_cast<void>(file.attribute_int64("/group", "pair")), InputError, names("pair"));
  BOOST_CHECK_EXCEPTION(static_cast<void>(file.has_attribute("/absent", "number")), InputError, names("/absent"));
  BOOST_CHECK_THROW(Hdf5Reader(folder / "none.h5"), StorageError);
  BOOST_CHECK_THROW(Hdf5Reader(folder.path()), StorageError);
}

/// A sealed file whose dataset /row of twelve doubles says that its values lie at `begin` (unless 0) and take `bytes`.
void write_misplaced(const std::filesystem::path& path, std::uint64_t begin, std::uint64_t bytes) {
  Hdf5Writer writer(path);
  writer.write("/row", std::vector<double>(12, 1.5));
  writer.commit();
  std::string content = gpf::read_text(path).substr(gpf::hdf5::seal_size);
  // The layout message of the HDF5 format, version 3: class 1 (contiguous), address and size of eight bytes each.
  constexpr std::uint64_t twelve_doubles = 96;
  std::string size_field(sizeof twelve_doubles, '\0');
  std::memcpy(size_field.data(), &twelve_doubles, size_field.size());
  std::size_t at = content.find(std::string{3, 1});
  while (at != std::string::npos && content.substr(at + 10, 8) != size_field)
    at = content.find(std::string{3, 1}, at + 1);
  BOOST_TEST_REQUIRE(at != std::string::npos);
  if (begin != 0) std::memcpy(content.data() + at + 2, &begin, sizeof begin);
  std::memcpy(content.data() + at + 10, &bytes, sizeof bytes);
  gpf::write_text_atomically(path, gpf::hdf5::seal(content) + content);
}

BOOST_AUTO_TEST_CASE(values_lie_where_the_file_says_they_can) {
  const TemporaryFolder folder;
  const auto why = [](const InputError& error) {
    return std::string(error.what()).find("one piece") != std::string::npos;
  };
  write_misplaced(folder / "a.h5", 0, 96);
  BOOST_TEST(Hdf5Reader(folder / "a.h5").doubles("/row").values == std::vector<double>(12, 1.5));
  constexpr std::uint64_t undefined = ~std::uint64_t{0};
  for (const auto& [begin, bytes] : {std::pair<std::uint64_t, std::uint64_t>{0, 88},
                                     {0, 104},
                                     {0, 1ULL << 60},
                                     {1ULL << 40, 96},
                                     {undefined - 600, 96},
                                     {undefined, 96}}) {
    write_misplaced(folder / "a.h5", begin, bytes);
    const Hdf5Reader file(folder / "a.h5");
    BOOST_CHECK_EXCEPTION(static_cast<void>(file.doubles("/row")), InputError, why);
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
