// gpf audit and gpf trace from the outside: two small stores, and a repository whose commits declare their change.
#include <fmt/format.h>

#include <boost/test/unit_test.hpp>
#include <chrono>
#include <cstdlib>

#include "gpf/io/atomic_file.hpp"
#include "gpf/io/subprocess.hpp"
#include "unit/io/temporary_folder.hpp"
#include "unit/verify/audit/made_up_evidence.hpp"
#include "verify/audit/baseline.hpp"
#include "verify/audit/trace.hpp"

using namespace gpf;

namespace {

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// A reference folder with one claim about 64 disks.
struct SmallSuite {
  test::TemporaryFolder folder;

  SmallSuite() {
    for (const char* name : {"claims", "scenes"}) std::filesystem::create_directories(folder / name);
    write_text_atomically(
        folder / "scenes/dilute.toml",
        "[scene]\ngeometry = \"periodic\"\nparticles = 64\narea_fraction = 0.10\n"
        "length_over_width = 1\nnormal_restitution = 1\n[run]\ncollisions_per_particle = 400\nbins = 1\n");
    write_text_atomically(folder / "claims/eos.virial.toml", claim(0.2));
  }

  static std::string claim(double tolerance) {
    return fmt::format(
        "id = \"eos.virial\"\ntitle = \"t\"\nchapter = 2\nsource = \"s\"\nstatement = \"s\"\nmethod = \"m\"\n"
        "kind = \"profile\"\nexpected = \"reproduced\"\nestimator = \"eos_virial\"\ntolerance_unit = \"relative\"\n"
        "catches = [\"a fault\"]\n[scenes]\nquick = [\"dilute\"]\n[replicas]\nquick = 4\n"
        "[[tolerance]]\nname = \"all\"\nvalue = {}\nevidence = \"none: this tests the program\"\n",
        tolerance);
  }

  [[nodiscard]] ProcessResult gpf(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), GPF_PROGRAM);
    return run_program(arguments, "");
  }
  [[nodiscard]] ProcessResult fill(const std::string& store, const std::string& replicas) const {
    return gpf({"validate", "--replicas", replicas, "--reference", folder.path().string(), "--store",
                (folder / store).string(), "--jobs", "2"});
  }
  [[nodiscard]] ProcessResult audit(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "audit");
    arguments.insert(arguments.end(), {"--reference", folder.path().string()});
    return gpf(arguments);
  }
};

/// A git repository with nothing but baselines.
struct Repository {
  test::TemporaryFolder folder;

  Repository() {
    std::filesystem::create_directories(folder / "reference");
    git({"init", "--quiet"});
  }
  [[nodiscard]] ProcessResult run(std::vector<std::string> command) const {
    command.insert(command.begin(), {"env", "-C", folder.path().string()});
    return run_program(command, "");
  }
  void git(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"git", "-c", "user.name=a", "-c", "user.email=a@b"});
    const ProcessResult done = run(arguments);
    BOOST_REQUIRE_MESSAGE(done.exit_status == 0, done.errors);
  }
  void commit(const EvidenceSet& evidence, const std::string& message) const {
    write_text_atomically(folder / "reference/baseline.csv", baseline_text(evidence));
    git({"add", "."});
    git({"commit", "--quiet", "--allow-empty", "-m", message});
  }
  [[nodiscard]] int check() const { return run({GPF_PROGRAM, "audit", "--check-commit"}).exit_status; }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(audit_command)

BOOST_FIXTURE_TEST_CASE(two_stores_are_compared, SmallSuite) {
  BOOST_REQUIRE(fill("one", "4").exit_status == 0);
  BOOST_REQUIRE(fill("two", "4").exit_status == 0);
  const std::string one = (folder / "one").string(), two = (folder / "two").string();
  const ProcessResult same = audit({one, two, "--declare", "bitwise"});
  BOOST_TEST(same.exit_status == 0, same.errors);
  BOOST_TEST(contains(same.output, "**bitwise**, declared bitwise: **accepted**"), same.output);

  // Another estimate from the same runs: a value in a verdict is moved by hand.
  const std::filesystem::path verdict = folder / "two/verdicts/quick/eos.virial.json";
  std::string text = read_text(verdict);
  const std::size_t at = text.find("\"values\": [") + 11, end = text.find(',', at);
  text.replace(at, end - at, "\n    0.19");
  write_text_atomically(verdict, text);
  const ProcessResult other = audit({one, two, "--declare", "roundoff", "--output", (folder / "page.md").string()});
  BOOST_TEST(other.exit_status == 1, other.errors);
  BOOST_TEST(other.output.empty());
  BOOST_TEST(contains(read_text(folder / "page.md"), "**rejected**"));
  BOOST_TEST(audit({one, two}).exit_status == 0);                           // nothing was declared
  BOOST_TEST(audit({one, two, "--output", "/dev/full"}).exit_status == 4);  // it would be replaced by the page
  BOOST_TEST(std::filesystem::is_character_file("/dev/full"));
  // The page is not written, and nobody says that it was.
  BOOST_TEST(run_program({"sh", "-c",
                          fmt::format("{} audit {} {} --reference {} > /dev/full", GPF_PROGRAM, one, two,
                                      folder.path().string())},
                         "")
                 .exit_status == 4);
}

BOOST_FIXTURE_TEST_CASE(runs_that_moved_nowhere_but_are_gone_are_not_called_equal, SmallSuite) {
  BOOST_REQUIRE(fill("one", "4").exit_status == 0);
  std::filesystem::copy(folder / "one", folder / "two", std::filesystem::copy_options::recursive);
  for (const auto& entry : std::filesystem::directory_iterator(folder / "two"))
    if (entry.path().extension() == ".h5") std::filesystem::remove(entry.path());
  const ProcessResult audited = audit({(folder / "one").string(), (folder / "two").string(), "--declare", "roundoff"});
  BOOST_TEST(audited.exit_status == 1, audited.errors);
  BOOST_TEST(contains(audited.output, "could not be compared"), audited.output);
}

BOOST_FIXTURE_TEST_CASE(the_replicas_asked_for_are_looked_at_once, SmallSuite) {
  const ProcessResult filled = fill("three", "3");
  BOOST_TEST(filled.exit_status == 0, filled.errors);
  const EvidenceSet set = read_evidence(folder / "three", run_names(folder.path()));
  BOOST_TEST(set.runs.size() == 3U);
  BOOST_TEST(set.runs.begin()->second.name.starts_with("dilute #"));
  BOOST_TEST(set.numbers.at(0).values.size() == 3U);
  const ProcessResult other_tier =
      gpf({"validate", "--tier", "standard", "--replicas", "3", "--reference", folder.path().string()});
  BOOST_TEST(other_tier.exit_status == 2);
  BOOST_TEST(contains(other_tier.errors, "leave out --replicas"));
}

BOOST_FIXTURE_TEST_CASE(a_baseline_is_written_and_recognised, SmallSuite) {
  BOOST_REQUIRE(fill("one", "4").exit_status == 0);
  const std::string one = (folder / "one").string();
  BOOST_TEST(audit({"--write-baseline", "--store", one}).exit_status == 0);
  BOOST_TEST(audit({"--check-baseline", "--store", one}).exit_status == 0);
  std::string text = read_text(folder / "baseline.csv");
  const std::size_t hash = text.find(",dilute #2,") + 11;
  text[hash] = text[hash] == '0' ? '1' : '0';
  write_text_atomically(folder / "baseline.csv", text);
  const ProcessResult differs = audit({"--check-baseline", "--store", one});
  BOOST_TEST(differs.exit_status == 1);
  BOOST_TEST(contains(differs.output, "run dilute #2: trace hash"), differs.output);
}

BOOST_FIXTURE_TEST_CASE(a_commit_must_declare_what_its_baseline_shows, Repository) {
  BOOST_TEST(check() == 77);  // no commit
  const EvidenceSet set = test::made_up_evidence(), other = test::with_other_trajectories(set);
  EvidenceSet moved = other;
  for (double& x : moved.numbers[0].values) x += 2.5;
  commit(set, "The first");
  BOOST_TEST(check() == 77);  // no parent
  commit(set, "A refactoring");
  BOOST_TEST(check() == 0);
  commit(other, "A sum in another order");
  BOOST_TEST(check() == 1);
  commit(set, "Back\n\nPhysics-Change: roundoff");
  BOOST_TEST(check() == 0);
  commit(moved, "Another wall\n\nPhysics-Change: same physics");
  BOOST_TEST(check() == 1);
  commit(set, "Back\n\nPhysics-Change: new physics");
  BOOST_TEST(check() == 0);
  commit(set, "What?\n\nPhysics-Change: harmless");
  BOOST_TEST(check() == 2);
}

BOOST_FIXTURE_TEST_CASE(revisions_of_equal_sources_are_bitwise_at_once, Repository) {
  const EvidenceSet set = test::made_up_evidence();
  commit(set, "The first");
  commit(test::with_other_trajectories(set), "Another baseline, but no other source");
  for (const std::vector<std::string>& sides :
       {std::vector<std::string>{"HEAD~1", "HEAD"}, {"HEAD", "."}, {".", "HEAD~1"}}) {
    const ProcessResult audited = run({GPF_PROGRAM, "audit", sides[0], sides[1], "--declare", "bitwise"});
    BOOST_TEST(audited.exit_status == 0, audited.errors);
    BOOST_TEST(contains(audited.output, "nothing was run"), audited.output);
  }
  std::filesystem::create_directories(folder / "lib");
  write_text_atomically(folder / "lib/new.cpp", "a file that git does not know yet\n");
  BOOST_TEST(run({GPF_PROGRAM, "audit", "HEAD", "."}).exit_status == 4);  // there is nothing to build
  BOOST_TEST(run({"env", "-C", "reference", GPF_PROGRAM, "audit", "HEAD", "."}).exit_status == 4);  // from anywhere
  BOOST_TEST(run({GPF_PROGRAM, "audit", "^HEAD", "."}).exit_status == 2);
}

/// A revision whose gpf is a script: what becomes of an audit when its parts fail or take long.
BOOST_FIXTURE_TEST_CASE(parts_that_fail_or_are_stopped_end_the_audit, Repository) {
  const std::filesystem::path bin = folder / "bin";
  std::filesystem::create_directories(bin);
  const auto script = [](const std::filesystem::path& path, const std::string& text) {
    write_text_atomically(path, "#!/bin/sh\n" + text);
    std::filesystem::permissions(path, std::filesystem::perms::owner_all);
  };
  script(bin / "ccache", "exit 1\n");
  script(bin / "cmake", "exec sleep 30\n");
  std::filesystem::create_directories(folder / "lib");
  for (const char* file : {"CMakeLists.txt", "CMakePresets.json", "lib/CMakeLists.txt"})
    write_text_atomically(folder / file, "one\n");
  commit(test::made_up_evidence(), "The first");
  write_text_atomically(folder / "lib/CMakeLists.txt", "two\n");
  commit(test::made_up_evidence(), "The second");
  const std::string path = fmt::format("PATH={}:{}", bin.string(), std::getenv("PATH"));
  const auto began = std::chrono::steady_clock::now();
  const ProcessResult stopped =
      run({"env", path, "timeout", "--signal=TERM", "--foreground", "1", GPF_PROGRAM, "audit", "HEAD~1", "HEAD"});
  BOOST_TEST(stopped.exit_status == 124, stopped.errors);  // that of timeout, which sent the signal
  BOOST_TEST(contains(stopped.errors, "the audit was stopped"), stopped.errors);
  BOOST_TEST((std::chrono::steady_clock::now() - began < std::chrono::seconds(15)));  // it does not wait for its child

  // A program that dies of a full disk before it has judged everything.
  script(bin / "gpf",
         "for a; do [ \"$p\" = --store ] && store=$a; p=$a; done\n"
         "mkdir -p $store/verdicts/quick; echo {} > $store/verdicts/quick/one.json; exit 4\n");
  script(bin / "cmake",
         "for a; do [ \"$p\" = -B ] && build=$a; p=$a; done\n"
         "[ -z \"$build\" ] || { mkdir -p $build/verify; cp $(dirname $0)/gpf $build/verify/gpf; }\n");
  const ProcessResult failed = run({"env", path, GPF_PROGRAM, "audit", "HEAD~1", "HEAD"});
  BOOST_TEST(failed.exit_status == 2, failed.errors);
  BOOST_TEST(contains(failed.errors, "could not be run and judged, status 4"), failed.errors);
}

BOOST_FIXTURE_TEST_CASE(what_cannot_be_audited_is_refused, SmallSuite) {
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{},
                                                    {"one"},
                                                    {"no-such-revision", "nor-this"},
                                                    {"a", "b", "--declare", "harmless"},
                                                    {"--write-baseline", "--check-commit"},
                                                    {"--check-baseline", "a", "b"},
                                                    {"--check-commit", "--declare", "bitwise"},
                                                    {"a", "b", "--claims", "eos.viral"},
                                                    {"a", "b", "--replicas", "1"}})
    BOOST_TEST(audit(arguments).exit_status == 2);
}

BOOST_FIXTURE_TEST_CASE(a_run_is_traced, SmallSuite) {
  const std::string scene = (folder / "scenes/dilute.toml").string();
  const ProcessResult marks = gpf({"trace", scene, "--epochs", "3"});
  BOOST_TEST(marks.exit_status == 0, marks.errors);
  const auto parsed = parse_marks(marks.output);
  BOOST_REQUIRE(parsed.size() == 4U);
  const ProcessResult contacts = gpf({"trace", scene, "--epoch", "2"});
  BOOST_TEST(parse_contacts(contacts.output).size() == parsed[2].contacts - parsed[1].contacts);
  BOOST_TEST(gpf({"trace", scene, "--epoch", "0"}).exit_status == 2);
  BOOST_TEST(gpf({"trace", (folder / "none.toml").string()}).exit_status == 4);
}

BOOST_AUTO_TEST_SUITE_END()
