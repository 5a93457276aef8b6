// Another program that reads what this one writes, bit by bit.
#pragma once

#include <sys/types.h>

#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

namespace gpf {

/// A program with a pipe as its standard input, while run_program would keep all of the input in memory and on disk.
class PipedProgram {
 public:
  /// Starts arguments[0], looked up on the PATH. Throws StorageError when it cannot be started.
  explicit PipedProgram(const std::vector<std::string>& arguments);
  /// Ends the program unless it has finished.
  ~PipedProgram();
  PipedProgram(const PipedProgram&) = delete;
  PipedProgram& operator=(const PipedProgram&) = delete;

  /// Throws StorageError with the program's own words when it reads no more.
  void write(std::string_view bytes);
  /// Closes the pipe and waits. Throws StorageError with the program's own words when it fails.
  void finish();

 private:
  [[noreturn]] void fail();
  int wait();

  std::string name_;
  std::FILE* errors_;  ///< a nameless file for what it complains about
  int pipe_ = -1;
  pid_t process_ = -1;
};

}  // namespace gpf
