// gpf export from the outside: what it writes, refuses and leaves alone. What other programs read: tests/readers.
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <chrono>
#include <csignal>
#include <fstream>
#include <thread>

#include "gpf/io/atomic_file.hpp"
#include "gpf/io/subprocess.hpp"
#include "unit/io/temporary_folder.hpp"

using namespace gpf;

namespace {

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

struct Flow {
  test::TemporaryFolder folder;

  Flow() {
    std::ofstream(folder / "scene.toml")
        << "[scene]\ngeometry = \"channel\"\nparticles = 100\narea_fraction = 0.2\nwidth_over_diameter = 15\n"
           "normal_restitution = 0.9\nwall_tangential_restitution = 0.9\n[run]\nstart_up = 1\nduration = 1\nsnapshots "
           "= [0.5, 2]\n";
  }

  [[nodiscard]] std::string at(const std::string& name) const { return (folder / name).string(); }
  [[nodiscard]] static ProcessResult gpf(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), GPF_PROGRAM);
    return run_program(arguments, "");
  }
  void run() const { BOOST_REQUIRE(gpf({"run", at("scene.toml"), "-o", at("run.h5")}).exit_status == 0); }
  [[nodiscard]] static std::size_t lines(const std::string& text) {
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  }
};

}  // namespace

BOOST_FIXTURE_TEST_SUITE(export_command, Flow)

BOOST_AUTO_TEST_CASE(each_format_has_its_name_and_replaces_nothing_unasked) {
  run();
  for (const auto& [format, name] : std::vector<std::pair<std::string, std::string>>{
           {"h5md", "run.h5md"}, {"h5md-2d", "run-2d.h5md"}, {"xyz", "run.xyz"}}) {
    const ProcessResult first = gpf({"export", at("run.h5"), "--format", format});
    BOOST_TEST(first.exit_status == 0, first.errors);
    BOOST_TEST(first.output == at(name) + "\n");
    const std::string written = read_text(folder / name);
    const ProcessResult again = gpf({"export", at("run.h5"), "--format", format});
    BOOST_TEST(again.exit_status == 2);
    BOOST_TEST(contains(again.errors, "--force"));
    BOOST_TEST(gpf({"export", at("run.h5"), "--format", format, "--force"}).exit_status == 0);
    BOOST_TEST(read_text(folder / name) == written);  // byte for byte
  }
  BOOST_TEST(gpf({"export", at("run.h5"), "-o", at("run.h5"), "--force"}).exit_status == 2);  // its own input
}

// Snapshots at 0.5 and 2, and the final state at 2, which is one state.
BOOST_AUTO_TEST_CASE(the_states_of_a_record_are_exported_once_each) {
  run();
  BOOST_REQUIRE(gpf({"export", at("run.h5"), "--format", "xyz"}).exit_status == 0);
  const std::string text = read_text(folder / "run.xyz");
  BOOST_TEST(lines(text) == 2 * 102U);
  BOOST_TEST(text.starts_with("100\nLattice=\""));
  BOOST_TEST(contains(text, "pbc=\"T F F\" Properties=species:S:1:pos:R:3:velo:R:3:radius:R:1 Time=0.5\n"));
  BOOST_TEST(contains(text, " Time=2\n"));
}

BOOST_AUTO_TEST_CASE(a_scene_file_gives_its_start_or_a_trajectory) {
  BOOST_REQUIRE(gpf({"export", at("scene.toml"), "--format", "xyz"}).exit_status == 0);
  BOOST_TEST(lines(read_text(folder / "scene.xyz")) == 102U);
  const ProcessResult frames = gpf(
      {"export", at("scene.toml"), "--format", "xyz", "--frames", "3", "--interval", "0.25", "-o", at("three.xyz")});
  BOOST_REQUIRE(frames.exit_status == 0);
  const std::string trajectory = read_text(folder / "three.xyz");
  BOOST_TEST(lines(trajectory) == 3 * 102U);
  BOOST_TEST(contains(trajectory, " Time=0\n"));
  BOOST_TEST(contains(trajectory, " Time=0.5\n"));
}

BOOST_AUTO_TEST_CASE(tables_are_of_what_was_measured) {
  run();
  const ProcessResult tables = gpf({"export", at("run.h5"), "--format", "csv", "-o", at("table.txt")});
  BOOST_TEST(tables.exit_status == 0, tables.errors);
  BOOST_TEST(tables.output == at("table.txt") + "\n" + at("table-scalars.txt") + "\n");
  const std::string profiles = read_text(folder / "table.txt");
  BOOST_TEST(profiles.starts_with("bin,y,area_fraction,area_fraction_error,"));
  BOOST_TEST(lines(profiles) == 1 + 9U);  // bins: round(18/31 15)
  BOOST_TEST(contains(read_text(folder / "table-scalars.txt"), "\nmean_flow,"));
}

BOOST_AUTO_TEST_CASE(what_cannot_be_used_is_refused_and_writes_nothing) {
  run();
  const std::string scene = at("scene.toml"), record = at("run.h5");
  std::ofstream(folder / "note.h5") << "no record";
  const auto before = folder.names();
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{"export"},
                                                    {"export", at("note.h5")},
                                                    {"export", record, "--format", "pdb"},
                                                    {"export", record, "--frames", "0"},
                                                    {"export", record, "--interval", "1"},
                                                    {"export", record, "--from-start"},
                                                    {"export", record, "--from-snapshot", "3", "--frames", "2"},
                                                    {"export", record, "--format", "csv", "--frames", "2"},
                                                    {"export", scene, "--format", "csv"}}) {
    const ProcessResult refused = gpf(arguments);
    BOOST_TEST(refused.exit_status == 2, refused.errors);
    BOOST_TEST(!refused.errors.empty());
  }
  BOOST_TEST(gpf({"export", at("none.h5")}).exit_status == 4);
  BOOST_TEST(gpf({"export", record, "-o", folder.path().string(), "--force"}).exit_status == 4);
  BOOST_TEST(folder.names() == before, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_full_disk_is_an_error_and_leaves_nothing) {
  const auto before = folder.names();
  for (const char* format : {"h5md", "xyz"}) {
    const ProcessResult full =
        run_program({"/bin/sh", "-c", "trap '' XFSZ; ulimit -f 256; exec \"$@\"", "sh", GPF_PROGRAM, "export",
                     at("scene.toml"), "--format", format, "--frames", "1000"},
                    "");
    BOOST_TEST(full.exit_status == 4, full.errors);
    BOOST_TEST(contains(full.errors, "File too large"), full.errors);
    BOOST_TEST(folder.names() == before, boost::test_tools::per_element());
  }
}

BOOST_AUTO_TEST_CASE(a_signal_leaves_nothing) {
  for (const char* format : {"h5md", "xyz"}) {
    std::vector<std::string> storage{GPF_PROGRAM, "export", at("scene.toml"), "--format", format,
                                     "--frames",  "100000", "--interval",     "100"};
    std::vector<char*> argv;
    for (std::string& argument : storage) argv.push_back(argument.data());
    argv.push_back(nullptr);
    pid_t process = 0;
    BOOST_REQUIRE(::posix_spawn(&process, argv.front(), nullptr, nullptr, argv.data(), environ) == 0);
    for (int k = 0; k < 500 && folder.names().size() < 2; ++k)  // until the .part is there
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    BOOST_TEST(folder.names().size() == 2U);
    ::kill(process, SIGTERM);
    int status = 0;
    ::waitpid(process, &status, 0);
    BOOST_TEST(WIFEXITED(status));
    BOOST_TEST(WEXITSTATUS(status) == 75);
    BOOST_TEST((folder.names() == std::vector<std::string>{"scene.toml"}));
  }
}

BOOST_AUTO_TEST_SUITE_END()
