#include "verify/run_pool.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <chrono>
#include <csignal>
#include <fstream>
#include <thread>

#include "gpf/io/atomic_file.hpp"
#include "unit/io/temporary_folder.hpp"
#include "unit/verify/fake_run.hpp"

using namespace gpf;

namespace {

SceneFile scene() { return parse_scene(test::periodic_scene, "periodic.toml"); }
volatile std::sig_atomic_t stop_flag = 0;
extern "C" void set_stop_flag(int) { stop_flag = 1; }

/// A store, jobs for its runs, and a log to which every run adds a line when it starts.
struct Fixture {
  test::TemporaryFolder folder;
  RecordStore store{folder / "records", Trust::same_sources};
  std::filesystem::path log = folder / "log";
  PoolOptions options;

  Fixture() {
    stop_flag = 0;
    options.jobs = 2;
    options.run = [this](const SceneFile& file, const SimulationOptions&) {
      note();
      return test::fake_record(file, 8);
    };
  }

  void note() const {
    const int descriptor = ::open(log.c_str(), O_WRONLY | O_APPEND | O_CREAT, 0666);
    BOOST_REQUIRE(::write(descriptor, "x", 1) == 1);
    ::close(descriptor);
  }
  [[nodiscard]] std::size_t started() const { return std::filesystem::exists(log) ? read_text(log).size() : 0; }

  static std::vector<RunJob> jobs(int count) {
    std::vector<RunJob> result;
    for (int r = 0; r < count; ++r) result.push_back({replica_of(scene(), r, 0), "periodic #" + std::to_string(r + 1)});
    return result;
  }

  [[nodiscard]] bool holds(const std::vector<RunJob>& wanted) const {
    return std::all_of(wanted.begin(), wanted.end(),
                       [this](const RunJob& j) { return store.load(j.file).has_value(); });
  }
};

bool appears(const std::filesystem::path& path) {
  for (int k = 0; k < 200 && !std::filesystem::exists(path); ++k)
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  return std::filesystem::exists(path);
}

/// Waits for the order to stop, as a simulation does, and leaves a checkpoint.
std::optional<Record> run_until_stopped(const SceneFile&, const SimulationOptions& options) {
  while (*options.stop == 0) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  write_text_atomically(*options.checkpoint, "half way");
  return std::nullopt;
}

}  // namespace

BOOST_FIXTURE_TEST_SUITE(pool, Fixture)

BOOST_AUTO_TEST_CASE(every_job_leaves_its_record_and_nothing_else) {
  const PoolResult result = run_pool(store, jobs(5), options);
  BOOST_TEST(result.failures.empty());
  BOOST_TEST(!result.stopped);
  BOOST_TEST(started() == 5U);
  BOOST_TEST(holds(jobs(5)));
  for (const auto& entry : std::filesystem::directory_iterator(store.folder()))
    BOOST_TEST(entry.path().extension() == ".h5");
}

BOOST_AUTO_TEST_CASE(no_job_is_no_work) { BOOST_TEST(!run_pool(store, {}, options).stopped); }

BOOST_AUTO_TEST_CASE(the_real_simulation_gives_the_record_of_a_direct_run) {
  options.run = simulate;
  const PoolResult result = run_pool(store, jobs(1), options);
  BOOST_TEST(result.failures.empty());
  const auto record = store.load(jobs(1)[0].file);
  BOOST_REQUIRE(record.has_value());
  BOOST_TEST(record->trace_hash == simulate(jobs(1)[0].file)->trace_hash);
}

// Two pools want the same six runs at the same time.
BOOST_AUTO_TEST_CASE(two_processes_compute_a_record_once) {
  options.run = [this](const SceneFile& file, const SimulationOptions&) {
    note();
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    return test::fake_record(file, 8);
  };
  const pid_t other = ::fork();
  const PoolResult result = run_pool(store, jobs(6), options);
  if (other == 0) ::_exit(result.failures.empty() ? 0 : 1);
  int status = 1;
  ::waitpid(other, &status, 0);
  BOOST_TEST(status == 0);
  BOOST_TEST(result.failures.empty());
  BOOST_TEST(started() == 6U);
  BOOST_TEST(holds(jobs(6)));
}

BOOST_AUTO_TEST_CASE(a_run_that_fails_is_reported_and_the_others_go_on) {
  const std::uint64_t bad = jobs(4)[1].file.scene.seed, fatal = jobs(4)[2].file.scene.seed;
  options.run = [bad, fatal](const SceneFile& file, const SimulationOptions&) -> std::optional<Record> {
    if (file.scene.seed == bad) throw PhysicsError("disks overlap", "by 0.1 d", "report it");
    if (file.scene.seed == fatal) ::raise(SIGKILL);
    return test::fake_record(file, 8);
  };
  PoolResult result = run_pool(store, jobs(4), options);
  BOOST_REQUIRE(result.failures.size() == 2U);
  std::sort(result.failures.begin(), result.failures.end(), [](auto& a, auto& b) { return a.label < b.label; });
  BOOST_TEST(result.failures[0].label == "periodic #2");
  BOOST_TEST(result.failures[0].what == "disks overlap (by 0.1 d): report it");
  BOOST_CHECK(result.failures[0].status == ExitStatus::physics);
  BOOST_TEST(result.failures[1].label == "periodic #3");
  BOOST_TEST(result.failures[1].what.starts_with("ended by signal 9"), result.failures[1].what);
  BOOST_TEST(store.load(jobs(4)[0].file).has_value());
  BOOST_TEST(store.load(jobs(4)[3].file).has_value());
}

BOOST_AUTO_TEST_CASE(a_stopped_pool_keeps_checkpoints_and_goes_on_from_them) {
  std::signal(SIGTERM, set_stop_flag);
  std::signal(SIGALRM, set_stop_flag);
  options.stop = &stop_flag;
  options.run = run_until_stopped;
  ::alarm(1);
  const PoolResult stopped = run_pool(store, jobs(3), options);
  BOOST_TEST(stopped.stopped);
  BOOST_TEST(stopped.failures.empty());
  const auto checkpoint = [this](int r) {
    return store.path(jobs(3)[static_cast<std::size_t>(r)].file).string() + ".checkpoint";
  };
  BOOST_TEST(std::filesystem::exists(checkpoint(0)));
  BOOST_TEST(std::filesystem::exists(checkpoint(1)));
  BOOST_TEST(!std::filesystem::exists(checkpoint(2)));  // never started

  stop_flag = 0;
  options.run = [this](const SceneFile& file, const SimulationOptions& o) {
    if (o.resume && std::filesystem::exists(*o.checkpoint) && read_text(*o.checkpoint) == "half way") note();
    return test::fake_record(file, 8);
  };
  const PoolResult resumed = run_pool(store, jobs(3), options);
  BOOST_TEST(!resumed.stopped);
  BOOST_TEST(started() == 2U);  // two of the three went on
  BOOST_TEST(holds(jobs(3)));
  BOOST_TEST(!std::filesystem::exists(checkpoint(0)));
}

BOOST_AUTO_TEST_CASE(a_checkpoint_that_cannot_be_used_is_thrown_away) {
  write_text_atomically(store.path(jobs(1)[0].file).string() + ".checkpoint", "damaged");
  options.run = [](const SceneFile& file, const SimulationOptions& o) {
    if (std::filesystem::exists(*o.checkpoint)) throw InputError("damaged checkpoint", "it is short", "delete it");
    return test::fake_record(file, 8);
  };
  BOOST_TEST(run_pool(store, jobs(1), options).failures.empty());
  BOOST_TEST(holds(jobs(1)));
}

// kill -9 to the program: its runs notice, write their checkpoints and stop.
BOOST_AUTO_TEST_CASE(runs_do_not_outlive_their_pool) {
  std::signal(SIGTERM, set_stop_flag);
  options.stop = &stop_flag;
  options.run = [this](const SceneFile& file, const SimulationOptions& o) {
    note();
    return run_until_stopped(file, o);
  };
  const pid_t parent = ::fork();
  if (parent == 0) {
    run_pool(store, jobs(1), options);
    ::_exit(0);
  }
  BOOST_TEST(appears(log));
  ::kill(parent, SIGKILL);
  ::waitpid(parent, nullptr, 0);
  BOOST_TEST(appears(store.path(jobs(1)[0].file).string() + ".checkpoint"));
}

BOOST_AUTO_TEST_SUITE_END()
