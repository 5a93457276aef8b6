// The program's own commands, from the outside: what they print and with which status they end.
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "gpf/io/subprocess.hpp"
#include "unit/io/temporary_folder.hpp"
#include "unit/verify/claim_text.hpp"

using namespace gpf;

namespace {

/// A reference folder with one real claim about 64 disks, which takes a moment to decide.
struct Program {
  test::TemporaryFolder folder;

  Program() {
    std::filesystem::create_directories(folder / "claims");
    std::filesystem::create_directories(folder / "scenes");
    std::ofstream(folder / "scenes/dilute.toml")
        << "[scene]\ngeometry = \"periodic\"\nparticles = 64\narea_fraction = 0.10\nlength_over_width = 1\n"
           "normal_restitution = 1\n[run]\ncollisions_per_particle = 400\nbins = 1\n";
    std::ofstream(folder / "claims/eos.virial.toml")
        << "id = \"eos.virial\"\ntitle = \"t\"\nchapter = 2\nsource = \"s\"\nstatement = \"s\"\nmethod = \"m\"\n"
           "kind = \"profile\"\nexpected = \"reproduced\"\nestimator = \"eos_virial\"\ntolerance_unit = \"relative\"\n"
           "catches = [\"a fault\"]\n[scenes]\nquick = [\"dilute\"]\n[replicas]\nquick = 4\n"
           "[[tolerance]]\nname = \"all\"\nvalue = 0.2\nevidence = \"none: this tests the program, not the physics\"\n";
    std::ofstream(folder / "claims/required.txt") << "eos.virial\n";
  }

  [[nodiscard]] std::vector<std::string> command(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), GPF_PROGRAM);
    arguments.insert(arguments.end(), {"--reference", folder.path().string()});
    if (arguments[1] == "validate")
      arguments.insert(arguments.end(), {"--store", (folder / "records").string(), "--jobs", "2"});
    return arguments;
  }
  [[nodiscard]] ProcessResult gpf(const std::vector<std::string>& arguments) const {
    return run_program(command(arguments), "");
  }
};

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

BOOST_FIXTURE_TEST_SUITE(commands, Program)

BOOST_AUTO_TEST_CASE(the_flow_of_a_periodic_scene_is_a_table_too) {
  std::ofstream(folder / "box.toml")
      << "[scene]\ngeometry = \"periodic\"\nparticles = 64\narea_fraction = 0.10\n"
         "length_over_width = 1\nnormal_restitution = 1\n[run]\nduration = 1\nbins = 2\n";
  const ProcessResult flow =
      run_program({GPF_PROGRAM, "flow", (folder / "box.toml").string(), "--method", "event_driven"}, "");
  BOOST_TEST(flow.exit_status == 0, flow.errors);
  BOOST_TEST(contains(flow.output, "kurt_x"));
  BOOST_TEST(!contains(flow.output, "slip_velocity"));  // for channels only
}

BOOST_AUTO_TEST_CASE(a_report_on_chosen_claims_wants_a_folder_of_its_own) {
  const ProcessResult report = gpf({"report", "eos.virial", "--store", (folder / "records").string()});
  BOOST_TEST(report.exit_status == 2);
  BOOST_TEST(contains(report.errors, "without --output"));
}

BOOST_AUTO_TEST_CASE(a_claim_is_run_judged_and_passes_the_gate) {
  const ProcessResult early = gpf({"validate", "--gate"});
  BOOST_TEST(early.exit_status == 1);
  BOOST_TEST(contains(early.output, "claim eos.virial has no verdict"));

  const ProcessResult runs = gpf({"validate", "--only-runs", "dilute"});
  BOOST_TEST(runs.exit_status == 0, runs.errors);
  BOOST_TEST(runs.output.empty());
  BOOST_TEST(contains(runs.errors, "run 4/4 dilute #"));
  BOOST_TEST(!contains(runs.errors, "\r"));  // nothing that only a terminal understands

  const ProcessResult judged = gpf({"validate", "eos.virial", "--json"});
  BOOST_TEST(judged.exit_status == 0, judged.errors + judged.output);
  BOOST_TEST(judged.errors.empty());  // the runs are there
  BOOST_TEST(nlohmann::json::parse(judged.output).at("claims").at(0).at("outcome") == "pass");

  const ProcessResult gate = gpf({"validate", "--gate"});
  BOOST_TEST(gate.exit_status == 0, gate.output);
}

BOOST_AUTO_TEST_CASE(a_claim_is_explained) {
  const ProcessResult known = gpf({"explain", "eos.virial"});
  BOOST_TEST(known.exit_status == 0);
  BOOST_TEST(contains(known.output, "gpf validate --reference"));  // not that of the suite
  const ProcessResult unknown = gpf({"explain", "eos.viral"});
  BOOST_TEST(unknown.exit_status == 2);
  BOOST_TEST(contains(unknown.errors, "did you mean 'eos.virial'?"));
}

BOOST_AUTO_TEST_CASE(what_cannot_be_used_is_refused_with_status_2) {
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{"validate", "--tier", "fast"},
                                                    {"validate", "none"},
                                                    {"validate", "--jobs", "0"},
                                                    {"validate", "--release-seed", "7"},
                                                    {"validate", "--only-runs", "none"},
                                                    {"explain"}})
    BOOST_TEST(gpf(arguments).exit_status == 2);
  std::filesystem::remove(folder / "claims/eos.virial.toml");
  BOOST_TEST(gpf({"validate"}).exit_status == 2);
}

BOOST_AUTO_TEST_CASE(a_signal_leaves_checkpoints_and_the_same_command_goes_on) {
  std::ofstream(folder / "scenes/dilute.toml")
      << "[scene]\ngeometry = \"periodic\"\nparticles = 400\narea_fraction = 0.10\nlength_over_width = 1\n"
         "normal_restitution = 1\n[run]\ncollisions_per_particle = 1e8\nbins = 1\n";  // hours
  std::vector<std::string> storage = command({"validate"});
  std::vector<char*> argv;
  for (std::string& argument : storage) argv.push_back(argument.data());
  argv.push_back(nullptr);
  pid_t process = 0;
  BOOST_REQUIRE(::posix_spawn(&process, argv.front(), nullptr, nullptr, argv.data(), environ) == 0);
  const auto count = [this](const std::string& extension) {
    int found = 0;
    if (!std::filesystem::exists(folder / "records")) return found;
    for (const auto& entry : std::filesystem::directory_iterator(folder / "records"))
      found += entry.path().extension() == extension;
    return found;
  };
  for (int k = 0; k < 200 && count(".lock") < 2; ++k) std::this_thread::sleep_for(std::chrono::milliseconds(50));
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  ::kill(process, SIGTERM);
  int status = 0;
  ::waitpid(process, &status, 0);
  BOOST_TEST(WIFEXITED(status));
  BOOST_TEST(WEXITSTATUS(status) == 75);
  BOOST_TEST(count(".checkpoint") == 2);
  BOOST_TEST(count(".lock") == 0);
  BOOST_TEST(count(".h5") == 0);
}

BOOST_AUTO_TEST_SUITE_END()
