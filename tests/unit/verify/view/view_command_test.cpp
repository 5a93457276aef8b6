// gpf view from the outside: what it writes, refuses and leaves alone.
#include <spawn.h>
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
#include "verify/view/page.hpp"

using namespace gpf;

namespace {

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

struct Flow {
  test::TemporaryFolder folder;

  Flow() {
    std::ofstream(folder / "scene.toml")
        << "[scene]\ngeometry = \"channel\"\nparticles = 100\narea_fraction = 0.2\nwidth_over_diameter = 15\n"
           "normal_restitution = 0.9\nwall_tangential_restitution = 0.9\n[run]\nstart_up = 1\nduration = 1\nsnapshots "
           "= [0.5]\n";
  }

  [[nodiscard]] std::string at(const std::string& name) const { return (folder / name).string(); }
  [[nodiscard]] ProcessResult gpf(std::vector<std::string> arguments, const std::string& program = GPF_PROGRAM) const {
    arguments.insert(arguments.begin(), program);
    return run_program(arguments, "");
  }
  void run() const { BOOST_REQUIRE(gpf({"run", at("scene.toml"), "-o", at("run.h5")}).exit_status == 0); }
};

bool has_ffmpeg() {
  try {
    return run_program({"ffmpeg", "-version"}, "").exit_status == 0;
  } catch (const std::exception&) {
    return false;
  }
}

using boost::test_tools::assertion_result;
using boost::unit_test::precondition;
using boost::unit_test::test_unit_id;

assertion_result skipped_unless(bool there, const char* why) {
  assertion_result result(there);
  if (!there) result.message() << why;
  return result;
}
assertion_result with_ffmpeg(test_unit_id) { return skipped_unless(has_ffmpeg(), "there is no ffmpeg"); }
assertion_result with_page_parts(test_unit_id) {
  return skipped_unless(has_page_parts(), "built without the page's parts (GPF_VIEW)");
}
assertion_result without_page_parts(test_unit_id) {
  return skipped_unless(!has_page_parts(), "built with the page's parts (GPF_VIEW)");
}

}  // namespace

BOOST_FIXTURE_TEST_SUITE(view_command, Flow)

BOOST_AUTO_TEST_CASE(without_its_plots_the_program_says_how_to_get_them, *precondition(without_page_parts)) {
  const ProcessResult page = gpf({"view", at("scene.toml")});
  BOOST_TEST(page.exit_status == 2);
  BOOST_TEST(contains(page.errors, "GPF_VIEW=ON"));
}

BOOST_AUTO_TEST_CASE(a_page_stands_beside_its_record_and_is_not_overwritten, *precondition(with_page_parts)) {
  run();
  const ProcessResult page = gpf({"view", at("run.h5"), "--frames", "4"});
  BOOST_TEST_REQUIRE(page.exit_status == 0, page.errors);
  BOOST_TEST(page.output == at("run.html") + "\n");
  BOOST_TEST(contains(read_text(folder / "run.html"), "\"frames\":4,\"start\":2.0,"));

  const ProcessResult again = gpf({"view", at("run.h5")});
  BOOST_TEST(again.exit_status == 2);
  BOOST_TEST(contains(again.errors, "--force"));
  BOOST_TEST(gpf({"view", at("run.h5"), "--force", "--from-snapshot", "1"}).exit_status == 0);
  BOOST_TEST(contains(read_text(folder / "run.html"), "\"frames\":240,\"start\":0.5,"));
  BOOST_TEST(gpf({"view", at("run.h5"), "-o", at("run.h5"), "--force"}).exit_status == 2);  // its own input
}

// 900 disks, 240 frames: below 4 MB.
BOOST_AUTO_TEST_CASE(a_page_is_small, *precondition(with_page_parts)) {
  std::ofstream(folder / "scene.toml")
      << "[scene]\ngeometry = \"channel\"\nparticles = 900\narea_fraction = 0.2\nwidth_over_diameter = 31\n"
         "normal_restitution = 0.9\nwall_tangential_restitution = 0.9\n[run]\nduration = 1\n";
  BOOST_REQUIRE(gpf({"view", at("scene.toml"), "-o", at("page.html")}).exit_status == 0);
  BOOST_TEST(std::filesystem::file_size(folder / "page.html") < 4'000'000u);
}

BOOST_AUTO_TEST_CASE(a_picture_is_that_of_the_first_frame) {
  const ProcessResult picture = gpf({"view", at("scene.toml"), "--svg", at("start.svg")});
  BOOST_TEST(picture.exit_status == 0, picture.errors);
  BOOST_TEST(read_text(folder / "start.svg").starts_with("<svg"));
  BOOST_TEST(contains(read_text(folder / "start.svg"), "scene.toml; t = 0"));
  BOOST_TEST((folder.names() == std::vector<std::string>{"scene.toml", "start.svg"}));  // no page unasked
}

BOOST_AUTO_TEST_CASE(what_cannot_be_used_is_refused_and_writes_nothing) {
  run();
  const std::string scene = at("scene.toml"), record = at("run.h5");
  std::ofstream(folder / "note.h5") << "no record";
  std::ofstream(folder / "typo.toml") << "[scene]\ngeometri = \"channel\"\n";
  const auto before = folder.names();
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{"view"},
                                                    {"view", at("note.h5")},
                                                    {"view", at("typo.toml")},
                                                    {"view", scene, "--frames", "0"},
                                                    {"view", scene, "--interval", "-1"},
                                                    {"view", scene, "--from-snapshot", "1"},
                                                    {"view", record, "--from-snapshot", "2"},
                                                    {"view", record, "--from-snapshot", "1", "--from-start"},
                                                    {"view", record, "--movie", at("flow.avi")},
                                                    {"view", record, "--svg", at("flow"), "-o", at("flow")},
                                                    {"view", record, "--frames", "1000000"}}) {
    const ProcessResult refused = gpf(arguments);
    BOOST_TEST(refused.exit_status == 2, refused.errors);
    BOOST_TEST(!refused.errors.empty());
  }
  BOOST_TEST(gpf({"view", at("none.h5"), "--svg", at("none.svg")}).exit_status == 4);
  BOOST_TEST(gpf({"view", record, "-o", folder.path().string()}).exit_status == 2);
  BOOST_TEST(folder.names() == before, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_movie_needs_ffmpeg) {
  const ProcessResult without = run_program({"/usr/bin/env", "PATH=" + folder.path().string(), GPF_PROGRAM, "view",
                                             at("scene.toml"), "--movie", at("flow.mp4")},
                                            "");
  BOOST_TEST(without.exit_status == 4);
  BOOST_TEST(contains(without.errors, "apt-get install ffmpeg"));
  BOOST_TEST((folder.names() == std::vector<std::string>{"scene.toml"}));
}

BOOST_AUTO_TEST_CASE(movies_are_mp4_or_gif, *precondition(with_ffmpeg)) {
  for (const char* name : {"flow.mp4", "flow.gif"}) {
    const ProcessResult movie = gpf({"view", at("scene.toml"), "--movie", at(name), "--frames", "3"});
    BOOST_TEST(movie.exit_status == 0, movie.errors);
    BOOST_TEST(std::filesystem::file_size(folder / name) > 1000u);
  }
  BOOST_TEST((folder.names() == std::vector<std::string>{"flow.gif", "flow.mp4", "scene.toml"}));
}

/// Stops `gpf view` of a scene with these options in the middle of its work.
void stop_in_the_middle(const Flow& flow, std::vector<std::string> options) {
  std::vector<std::string> storage{GPF_PROGRAM, "view", flow.at("scene.toml"), "--frames", "100000"};
  storage.insert(storage.end(), options.begin(), options.end());
  std::vector<char*> argv;
  for (std::string& argument : storage) argv.push_back(argument.data());
  argv.push_back(nullptr);
  pid_t process = 0;
  BOOST_REQUIRE(::posix_spawn(&process, argv.front(), nullptr, nullptr, argv.data(), environ) == 0);
  std::this_thread::sleep_for(std::chrono::milliseconds(1500));
  ::kill(process, SIGTERM);
  int status = 0;
  ::waitpid(process, &status, 0);
  BOOST_TEST(WIFEXITED(status));
  BOOST_TEST(WEXITSTATUS(status) == 75);
  BOOST_TEST((flow.folder.names() == std::vector<std::string>{"scene.toml"}));
}

BOOST_AUTO_TEST_CASE(a_signal_leaves_no_movie, *precondition(with_ffmpeg)) {
  stop_in_the_middle(*this, {"--movie", at("flow.mp4")});
}

BOOST_AUTO_TEST_CASE(a_signal_leaves_no_page, *precondition(with_page_parts)) {
  stop_in_the_middle(*this, {"-o", at("flow.html"), "--interval", "1000"});
}

BOOST_AUTO_TEST_SUITE_END()
