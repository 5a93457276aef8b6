#include "verify/audit/side.hpp"

#include <fmt/format.h>

#include <cstdlib>

#include "gpf/base/error.hpp"
#include "gpf/io/atomic_file.hpp"
#include "gpf/io/subprocess.hpp"
#include "verify/audit/child.hpp"
#include "verify/audit/evidence_set.hpp"
#include "verify/audit/git.hpp"

namespace gpf {
namespace {

void create_folder(const std::filesystem::path& folder) {
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  if (failure)
    throw StorageError(fmt::format("cannot create '{}'", folder.string()), failure.message(),
                       "choose another folder with --work");
}

/// The last lines of a log, for a message.
std::string end_of(const std::filesystem::path& log, std::size_t most = 600) {
  const std::string text = read_text(log);
  return text.size() <= most ? text : fmt::format("... {}", text.substr(text.size() - most));
}

bool have_ccache() {
  try {
    return run_program({"ccache", "--version"}, "").exit_status == 0;
  } catch (const StorageError&) {
    return false;
  }
}

std::filesystem::path home_of(const Side& side, const SideOptions& options) {
  return std::filesystem::absolute(options.work) / (side.commit.empty() ? "working-tree" : side.commit);
}

/// The sources of a commit, or a link to those of the working tree: every side then has the same paths within its
/// folder, so that ccache knows a file again.
void provide_tree(const Side& side) {
  if (side.commit.empty()) {
    if (std::filesystem::exists(side.tree / "CMakeLists.txt")) return;
    std::filesystem::remove(side.tree);
    return std::filesystem::create_directory_symlink(git({"rev-parse", "--show-toplevel"}).value_or("."), side.tree);
  }
  // A checkout that was cut short has files, but not all of them.
  if (std::filesystem::exists(side.tree) && git({"-C", side.tree.string(), "diff", "--quiet", side.commit})) return;
  std::filesystem::remove_all(side.tree);
  git({"worktree", "prune"});
  if (!git({"worktree", "add", "--detach", "--force", side.tree.string(), side.commit}))
    throw StorageError(fmt::format("cannot check out {} into '{}'", side.commit, side.tree.string()),
                       "git worktree add failed", "make room there, or choose another folder with --work");
}

/// What a program is made with besides its sources. Records do not tell programs of the same sources apart, so when
/// this has changed neither the program nor its records can be used.
std::string toolchain(const Side& side) {
  std::string text;
  for (const char* variable : {"CXX", "CC", "CXXFLAGS", "CFLAGS", "LDFLAGS"})
    if (const char* value = std::getenv(variable)) text += fmt::format("{}={}\n", variable, value);
  const char* compiler = std::getenv("CXX");
  text += run_program({compiler != nullptr ? compiler : "c++", "--version"}, "").output;
  for (const char* file : {"CMakePresets.json", "CMakeLists.txt", "lib/CMakeLists.txt"})
    text += read_text(side.tree / file);
  return text;
}

/// Drops the program and the store when they were made with something else than is here now.
void drop_if_outdated(const Side& side, const std::filesystem::path& home) {
  const std::filesystem::path made_with = home / "toolchain.txt";
  const std::string now = toolchain(side);
  if (std::filesystem::exists(made_with) && read_text(made_with) == now) return;
  for (const std::filesystem::path& old : {home / "build", side.store, home / "validated.txt"})
    std::filesystem::remove_all(old);
  write_text_atomically(made_with, now);
}

}  // namespace

void stop_if_asked(const SideOptions& options) {
  if (options.stop != nullptr && *options.stop != 0)
    throw Error(ExitStatus::interrupted, "the audit was stopped", "by a signal", "the same command goes on");
}

Side side_named(const std::string& name, const SideOptions& options) {
  Side side;
  side.name = name;
  if (is_store(name)) {
    side.store = name;
    return side;
  }
  const bool as_it_is = name == working_tree;
  const std::string commit = commit_of(as_it_is ? "HEAD" : name);
  if (!as_it_is) side.commit = commit;
  const std::filesystem::path home = home_of(side, options);
  side.tree = home / "tree";
  side.program = home / "build" / "verify" / "gpf";
  side.store = home / "records";
  return side;
}

void build(const Side& side, const SideOptions& options) {
  if (!side.has_program()) return;
  const bool fixed = !side.commit.empty();
  const std::filesystem::path home = home_of(side, options), log = home / "build.log";
  create_folder(home);
  provide_tree(side);
  drop_if_outdated(side, home);
  if (fixed && !options.rebuild && std::filesystem::exists(side.program)) return;
  std::filesystem::remove(log);
  fmt::print(stderr, "gpf audit: building {} (log in {})\n", side.name, log.string());
  const std::string build_folder = (home / "build").string();
  std::vector<std::string> configure{"cmake", "-S",         side.tree.string(),      "--preset",      "release",
                                     "-B",    build_folder, "-DGPF_BUILD_TESTS=OFF", "-DGPF_VIEW=OFF"};
  if (have_ccache()) {
    for (const char* language : {"C", "CXX"})
      configure.push_back(fmt::format("-DCMAKE_{}_COMPILER_LAUNCHER=ccache", language));
    // ccache cannot use what was compiled with them, and the next revision shares most files with this one.
    configure.emplace_back("-DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON");
  }
  std::vector<std::string> compile{"cmake",
                                   "-E",
                                   "env",
                                   fmt::format("CCACHE_BASEDIR={}", home.string()),
                                   "CCACHE_NOHASHDIR=1",
                                   "cmake",
                                   "--build",
                                   build_folder,
                                   "--target",
                                   "gpf",
                                   "--parallel",
                                   fmt::format("{}", options.jobs)};
  if (options.rebuild) compile.emplace_back("--clean-first");
  for (const auto& command : {configure, compile}) {
    const int status = run_child(command, log, options.stop).exit_status;
    stop_if_asked(options);
    if (status != 0)
      throw InputError(fmt::format("{} does not build", side.name), end_of(log), fmt::format("see {}", log.string()));
  }
}

void fill_store(Side& side, const SideOptions& options) {
  if (!side.has_program()) return;
  const std::filesystem::path home = home_of(side, options), log = home / "validate.log";
  std::vector<std::string> command{side.program.string(),
                                   "validate",
                                   "--tier",
                                   "quick",
                                   "--replicas",
                                   fmt::format("{}", options.replicas),
                                   "--jobs",
                                   fmt::format("{}", options.jobs),
                                   "--store",
                                   side.store.string(),
                                   "--reference",
                                   (side.tree / "reference").string()};
  command.insert(command.end(), options.claims.begin(), options.claims.end());
  // What a commit was asked before it need not be asked again.
  const std::filesystem::path done = home / "validated.txt";
  const std::string question = fmt::format("{}\n", fmt::join(command, " "));
  if (options.rebuild) std::filesystem::remove_all(side.store);
  if (!side.commit.empty() && !options.rebuild && std::filesystem::exists(done) && read_text(done) == question) return;
  // Verdicts of an earlier audit must not stand for those that this one does not reach.
  for (const std::filesystem::path& old : {done, log, side.store / "verdicts"}) std::filesystem::remove_all(old);
  fmt::print(stderr, "gpf audit: running and judging {} (log in {})\n", side.name, log.string());
  const int status = run_child(command, log, options.stop).exit_status;
  stop_if_asked(options);
  const auto is = [status](ExitStatus s) { return status == static_cast<int>(s); };
  if (is(ExitStatus::interrupted))
    throw Error(ExitStatus::interrupted, "the audit was stopped", "by a signal", "the same command goes on");
  if (!is_store(side.store))
    throw InputError(fmt::format("{} has judged nothing", side.name), end_of(log),
                     "audit revisions whose gpf has validate --replicas and trace");
  if (is(ExitStatus::success) || is(ExitStatus::red) || is(ExitStatus::inconclusive))
    return write_text_atomically(done, question);
  if (is(ExitStatus::physics))
    side.notes.push_back(
        fmt::format("{}: the engine refused a run, or a claim could not be judged: {}", side.name, end_of(log)));
  else
    throw InputError(fmt::format("{} could not be run and judged, status {}", side.name, status), end_of(log),
                     fmt::format("see {}", log.string()));
}

}  // namespace gpf
