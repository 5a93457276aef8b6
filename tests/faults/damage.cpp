// Damage done to a record, one byte or one length at a time: what read_record makes of it.
// usage: damage RECORD STRIDE     every STRIDE-th byte and length; prints "damage<TAB>outcome<TAB>times" and ends with
// 1
//                                 when something was not refused that must be
//        damage --other-hash RECORD...     gives each another trace hash, for what compares records
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "faults/child_process.hpp"
#include "gpf/base/error.hpp"
#include "gpf/io/atomic_file.hpp"
#include "gpf/io/hdf5_seal.hpp"
#include "gpf/io/record.hpp"

namespace {

namespace fs = std::filesystem;

/// Outcomes of one kind of damage; those of a child process come through a file.
using Counts = std::map<std::string, int>;

/// The scratch files, removed in the end.
struct Scratch {
  fs::path folder = fs::temp_directory_path() / ("gpf-damage-" + std::to_string(::getpid()));
  Scratch() { fs::create_directories(folder); }
  ~Scratch() {
    std::error_code ignored;
    fs::remove_all(folder, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
};

/// What a record says, as bytes: equal records give equal bytes.
std::string told_by(const gpf::Record& record, const fs::path& scratch) {
  gpf::write_record(record, scratch);
  return gpf::read_text(scratch);
}

class Reader {
 public:
  Reader(const fs::path& record, const fs::path& folder)
      : damaged_(folder / "damaged.h5"),
        scratch_(folder / "again.h5"),
        told_(told_by(gpf::read_record(record), scratch_)) {}

  [[nodiscard]] std::string outcome(const std::string& bytes) const {
    std::ofstream(damaged_, std::ios::binary) << bytes;
    try {
      return told_by(gpf::read_record(damaged_), scratch_) == told_ ? "the same numbers" : "other numbers";
    } catch (const gpf::Error& error) {
      const bool clear = std::strstr(error.what(), "damaged.h5") != nullptr && !error.remedy().empty();
      return clear ? "refused" : "refused without naming the file";
    } catch (const std::exception& error) {
      return std::string("not caught: ") + error.what();
    }
  }

 private:
  fs::path damaged_, scratch_;
  std::string told_;
};

std::string flipped(std::string bytes, std::size_t at) {
  bytes[at] = static_cast<char>(~bytes[at]);
  return bytes;
}

/// Bytes whose seal is made anew, as someone would who wants them to be read. HDF5 reads these, so children do.
Counts sealed_anew(const Reader& reader, const std::string& bytes, std::size_t stride, const fs::path& folder) {
  constexpr std::size_t batch = 500;
  const fs::path report = folder / "report";
  const std::string content = bytes.substr(gpf::hdf5::seal_size);
  Counts counts;
  for (std::size_t begin = 0; begin < content.size();) {
    std::ofstream(report, std::ios::trunc).close();
    gpf::test::ChildProcess child([&]() -> std::string {
      std::ofstream out(report);
      for (std::size_t k = 0, at = begin; k < batch && at < content.size(); ++k, at += stride) {
        ::alarm(20);
        const std::string other = flipped(content, at);
        out << reader.outcome(gpf::hdf5::seal(other) + other) << std::endl;
      }
      return "";
    });
    const int status = child.wait();
    std::ifstream in(report);
    std::size_t done = 0;
    for (std::string line; std::getline(in, line); ++done) ++counts[line];
    if (status != 0) ++counts[status == 128 + SIGALRM ? "hangs" : "ends the process"], ++done;
    begin += done * stride;
  }
  return counts;
}

bool print(const char* damage, const Counts& counts, bool all_refused) {
  bool good = true;
  for (const auto& [outcome, times] : counts) {
    std::printf("%s\t%s\t%d\n", damage, outcome.c_str(), times);
    const bool numbers = outcome == "the same numbers" || outcome == "other numbers";
    good = good && (outcome == "refused" || (numbers && !all_refused));
  }
  return good;
}

int try_damage(const fs::path& record, std::size_t stride) {
  const Scratch scratch;
  const Reader reader(record, scratch.folder);
  const std::string bytes = gpf::read_text(record);
  Counts flips, lengths;
  for (std::size_t at = 0; at < bytes.size(); at += stride) ++flips[reader.outcome(flipped(bytes, at))];
  for (std::size_t length = 0; length < bytes.size(); length += stride)
    ++lengths[reader.outcome(bytes.substr(0, length))];
  ++lengths[reader.outcome(bytes + '\0')];
  bool good = print("a byte of a record flipped", flips, true);
  good = print("a record cut short, or longer", lengths, true) && good;
  good = print("a byte flipped and sealed anew", sealed_anew(reader, bytes, stride, scratch.folder), false) && good;
  return good ? 0 : 1;
}

}  // namespace

int main(int count, char** arguments) {
  const std::vector<std::string> words(arguments + 1, arguments + count);
  if (words.size() >= 2 && words[0] == "--other-hash") {
    for (std::size_t k = 1; k < words.size(); ++k) {
      gpf::Record record = gpf::read_record(words[k]);
      record.trace_hash ^= 1;
      gpf::write_record(record, words[k]);
    }
    return 0;
  }
  if (words.size() != 2 || std::atoi(words[1].c_str()) < 1) {
    std::fputs("usage: damage RECORD STRIDE | damage --other-hash RECORD...\n", stderr);
    return 2;
  }
  return try_damage(words[0], static_cast<std::size_t>(std::atoi(words[1].c_str())));
}
