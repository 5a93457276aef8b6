// Files that are truncated, damaged, foreign or lie about their sizes: an InputError, never a crash or a long wait.
#include <boost/test/unit_test.hpp>
#include <cstring>
#include <fstream>
#include <vector>

#include "gpf/base/error.hpp"
#include "gpf/io/atomic_file.hpp"
#include "gpf/io/hdf5.hpp"
#include "gpf/io/hdf5_seal.hpp"
#include "unit/io/temporary_folder.hpp"

namespace {

using gpf::InputError;
using gpf::test::TemporaryFolder;

/// Numbers that occur nowhere else in the sample file, so that a test can find and falsify them.
constexpr std::uint64_t rows = 0x1235;
constexpr std::uint32_t text_length = 0x2467;

struct Sample {
  TemporaryFolder folder;
  std::filesystem::path path = folder / "record.h5";
  std::string bytes;

  Sample() {
    gpf::Hdf5Writer writer(path);
    writer.write("/fields/velocity", std::vector<double>{1, 2, 3, 4, 5, 6}, {2, 3});
    writer.write("/counts", std::vector<std::uint64_t>{7, 8});
    writer.write_text("/scene", "a scene");
    writer.attribute("/fields", "seed", 7);
    writer.commit();
    bytes = gpf::read_text(path);
  }

  /// What the error says when `content` stands in the file, "" if there is none.
  [[nodiscard]] std::string complaint(const std::string& content) const {
    std::ofstream(folder / "damaged.h5", std::ios::binary) << content;  // without the wait for the disk
    try {
      const gpf::Hdf5Reader reader(folder / "damaged.h5");
      return "";
    } catch (const InputError& error) {
      BOOST_TEST(error.problem().find("damaged.h5") != std::string::npos);
      BOOST_TEST(!error.remedy().empty());
      return error.why();
    }
  }
};

BOOST_AUTO_TEST_SUITE(damaged_file)

BOOST_FIXTURE_TEST_CASE(sample_is_sound, Sample) {
  BOOST_TEST(complaint(bytes) == "");
  BOOST_TEST(gpf::Hdf5Reader(path).text("/scene") == "a scene");
}

BOOST_FIXTURE_TEST_CASE(every_length_but_the_whole, Sample) {
  for (std::size_t length = 0; length < bytes.size(); length += length < 600 ? 1 : 61) {
    BOOST_TEST(complaint(bytes.substr(0, length)) != "", "length " << length);
  }
  BOOST_TEST(complaint(bytes.substr(0, bytes.size() - 1)) != "");
  BOOST_TEST(complaint(bytes + '\0') != "");
  BOOST_TEST(complaint(bytes + bytes) != "");
}

BOOST_FIXTURE_TEST_CASE(every_flipped_bit, Sample) {
  std::size_t unseen = 0;
  for (std::size_t i = 0; i < 8 * bytes.size(); ++i) {
    std::string damaged = bytes;
    damaged[i / 8] = static_cast<char>(damaged[i / 8] ^ (1 << i % 8));
    try {
      gpf::hdf5::check_seal(damaged, path);
      ++unseen;
    } catch (const InputError&) {
    }
  }
  BOOST_TEST(unseen == 0u);
}

BOOST_FIXTURE_TEST_CASE(flipped_bits_seen_by_the_reader, Sample) {
  for (std::size_t i = 0; i < bytes.size(); i += 13) {
    std::string damaged = bytes;
    damaged[i] = static_cast<char>(damaged[i] ^ 0x10);
    BOOST_TEST(complaint(damaged) != "", "byte " << i);
  }
}

BOOST_FIXTURE_TEST_CASE(foreign_files, Sample) {
  BOOST_TEST(complaint("") == "the file is empty");
  BOOST_TEST(complaint("particles = 900\n").find("not a file") == 0);
  BOOST_TEST(complaint(std::string(5000, '\0')).find("not a file") == 0);
  const std::string without_seal = bytes.substr(gpf::hdf5::seal_size);  // HDF5, but not sealed
  BOOST_TEST(complaint(without_seal).find("not a file") == 0);
  // A seal around something that is not HDF5: the checksum holds, and HDF5 itself refuses.
  const std::string text = "not HDF5 at all";
  BOOST_TEST(complaint(gpf::hdf5::seal(text) + text).find("HDF5: ") == 0);
  BOOST_TEST(complaint(gpf::hdf5::seal("")).find("HDF5: ") == 0);
}

/// The sealed file with every occurrence of `from` replaced by `to`, and sealed anew.
template <typename T>
std::string falsify(std::string bytes, T from, T to) {
  std::string old_value(sizeof(T), '\0'), new_value(sizeof(T), '\0');
  std::memcpy(old_value.data(), &from, sizeof(T));
  std::memcpy(new_value.data(), &to, sizeof(T));
  std::size_t replaced = 0;
  for (std::size_t at = gpf::hdf5::seal_size; (at = bytes.find(old_value, at)) != std::string::npos; ++replaced) {
    bytes.replace(at, sizeof(T), new_value);
  }
  BOOST_TEST_REQUIRE(replaced > 0u);
  const std::string content = bytes.substr(gpf::hdf5::seal_size);
  return gpf::hdf5::seal(content) + content;
}

BOOST_AUTO_TEST_CASE(claimed_sizes_are_not_believed) {
  const TemporaryFolder folder;
  const auto path = folder / "a.h5";
  gpf::Hdf5Writer writer(path);
  writer.write("/rows", std::vector<double>(rows));
  writer.write_text("/text", std::string(text_length, 'x'));
  writer.commit();
  const std::string bytes = gpf::read_text(path);
  const auto sees_the_lie = [](const InputError& error) {
    return error.why().find("than the file has room for") != std::string::npos;
  };
  for (const std::uint64_t claimed : {rows * 1000, std::uint64_t{1} << 40, ~std::uint64_t{0} / 8}) {
    gpf::write_text_atomically(path, falsify(bytes, rows, claimed));
    BOOST_CHECK_EXCEPTION(static_cast<void>(gpf::Hdf5Reader(path).doubles("/rows")), InputError, sees_the_lie);
  }
  for (const std::uint32_t claimed : {text_length * 1000, 0x7fffffffu, 0xffffffffu}) {
    gpf::write_text_atomically(path, falsify(bytes, text_length, claimed));
    BOOST_CHECK_EXCEPTION(static_cast<void>(gpf::Hdf5Reader(path).text("/text")), InputError, sees_the_lie);
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
