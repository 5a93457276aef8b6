// Writers killed at random moments: under the final name stands a complete file, never older than one seen before.
#include <boost/test/unit_test.hpp>
#include <chrono>
#include <csignal>
#include <random>
#include <thread>
#include <vector>

#include "faults/child_process.hpp"
#include "gpf/io/atomic_file.hpp"
#include "gpf/io/hdf5.hpp"
#include "unit/io/temporary_folder.hpp"

namespace {

using gpf::test::ChildProcess;
using gpf::test::TemporaryFolder;
namespace fs = std::filesystem;

constexpr int kills = 60;
constexpr std::size_t values = 50000;  // 400 kB, so that a kill can meet a half-written file

/// A kind of file that holds one number many times: writing it, and reading it with a check that nothing is missing.
struct Format {
  void (*write)(const fs::path& path, std::int64_t number);
  std::int64_t (*read)(const fs::path& path);  ///< -1 when the file is not complete
};

const Format text{[](const fs::path& path, std::int64_t number) {
                    std::string block = std::to_string(number);
                    block.insert(0, 8 - block.size(), '0');
                    std::string content;
                    for (std::size_t i = 0; i < values; ++i) content += block;
                    gpf::write_text_atomically(path, content);
                  },
                  [](const fs::path& path) -> std::int64_t {
                    const std::string content = gpf::read_text(path), block = content.substr(0, 8);
                    if (content.size() != 8 * values) return -1;
                    for (std::size_t i = 0; i < values; ++i) {
                      if (content.compare(8 * i, 8, block) != 0) return -1;
                    }
                    return std::stoll(block);
                  }};

const Format hdf5{[](const fs::path& path, std::int64_t number) {
                    gpf::Hdf5Writer writer(path);
                    writer.write("/values", std::vector<std::int64_t>(values, number));
                    writer.commit();
                  },
                  [](const fs::path& path) -> std::int64_t {
                    const auto content = gpf::Hdf5Reader(path).int64s("/values").values;
                    if (content != std::vector<std::int64_t>(values, content.at(0))) return -1;
                    return content[0];
                  }};

BOOST_AUTO_TEST_SUITE(killed_writer)

BOOST_AUTO_TEST_CASE(final_name_is_always_complete) {
  for (const Format& format : {text, hdf5}) {
    const TemporaryFolder folder;
    const fs::path path = folder / "file";
    const auto start = std::chrono::steady_clock::now();
    format.write(path, 0);
    // Children die at any moment of their first few writes, however slow the disk is.
    const std::chrono::duration<double> longest_life = 3 * (std::chrono::steady_clock::now() - start);
    std::mt19937 random(20240607);  // only spreads the moments; the machine's timing is random anyway
    std::int64_t newest = 0, left_parts = 0;
    for (int i = 0; i < kills; ++i) {
      ChildProcess child([&]() -> std::string {
        for (std::int64_t number = newest + 1;; ++number) format.write(path, number);
      });
      std::this_thread::sleep_for(std::uniform_real_distribution<>()(random) * longest_life);
      child.kill(SIGKILL);
      BOOST_TEST_REQUIRE(child.wait() == 128 + SIGKILL);
      left_parts += fs::exists(folder / "file.part");
      const std::int64_t found = format.read(path);
      BOOST_TEST(found >= newest);
      newest = found;
    }
    // The test means something only if children got work done and some died in the middle of it.
    BOOST_TEST(newest > 0);
    BOOST_TEST(left_parts > 0);
    BOOST_TEST_MESSAGE(newest << " files written, " << left_parts << " of " << kills << " kills left a .part");
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
