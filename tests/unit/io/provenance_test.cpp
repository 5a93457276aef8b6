#include "gpf/io/provenance.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <chrono>
#include <nlohmann/json.hpp>
#include <string_view>

#include "gpf/io/atomic_file.hpp"
#include "gpf/io/subprocess.hpp"
#include "unit/io/environment.hpp"
#include "unit/io/temporary_folder.hpp"

namespace {

using gpf::run_program;
using gpf::test::TemporaryFolder;
namespace fs = std::filesystem;

/// Whether the text has the shape of the pattern, in which 0 stands for any digit and other characters for themselves.
bool has_shape(std::string_view text, std::string_view pattern) {
  return std::equal(text.begin(), text.end(), pattern.begin(), pattern.end(),
                    [](char c, char shape) { return shape == '0' ? c >= '0' && c <= '9' : c == shape; });
}

bool is_commit(std::string_view text) {
  return text.size() >= 40 && text.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

/// Whether the text begins with a version of two or more numbers.
bool is_version(std::string_view text) {
  const std::size_t dot = text.find_first_not_of("0123456789");
  return dot != std::string_view::npos && dot > 0 && has_shape(text.substr(dot, 2), ".0");
}

/// What stands between quotes after `name = ` in a generated header.
std::string value_of(const std::string& header, const std::string& name) {
  const std::size_t begin = header.find(name + " = \"") + name.size() + 4;
  return header.substr(begin, header.find('"', begin) - begin);
}

BOOST_AUTO_TEST_SUITE(provenance)

BOOST_AUTO_TEST_CASE(build_facts_are_filled_in) {
  const gpf::BuildProvenance build = gpf::build_provenance();
  BOOST_TEST(is_version(build.version));
  BOOST_TEST((build.commit == "unknown" || is_commit(build.commit)));
  BOOST_TEST((build.commit == "unknown") == !build.dirty.has_value());
  BOOST_TEST(is_version(build.compiler.substr(build.compiler.find(' ') + 1)), build.compiler);
  BOOST_TEST(build.flags.find("-ffp-contract=off") != std::string::npos, build.flags);
  BOOST_TEST(build.flags.find("-W") == std::string::npos, build.flags);
  for (const char* const library : {"HDF5", "Eigen3", "GSL", "FFTW3", "fmt", "nlohmann_json"}) {
    BOOST_TEST(is_version(build.libraries.at(library)), library);
  }
}

BOOST_AUTO_TEST_CASE(build_facts_do_not_vary) {
  const std::string json = gpf::to_json(gpf::build_provenance());
  BOOST_TEST(json == gpf::to_json(gpf::build_provenance()));
  const auto parsed = nlohmann::json::parse(json);
  BOOST_TEST(parsed.at("commit") == gpf::build_provenance().commit);
  BOOST_TEST(!parsed.contains("cpu"));
  BOOST_TEST(!parsed.contains("utc_time"));
}

BOOST_AUTO_TEST_CASE(unknown_dirtiness_is_null) {
  gpf::BuildProvenance build;
  BOOST_TEST(nlohmann::json::parse(gpf::to_json(build)).at("dirty").is_null());
  build.dirty = true;
  BOOST_TEST(nlohmann::json::parse(gpf::to_json(build)).at("dirty") == true);
}

BOOST_AUTO_TEST_CASE(session_facts) {
  const auto session = gpf::session_provenance({"gpf", "run", "scene \"x\"\n", "\xff"});
  BOOST_TEST(!session.cpu.empty());
  BOOST_TEST(session.system.find(run_program({"uname", "-r"}, "").output.substr(0, 3)) != std::string::npos);
  BOOST_TEST(has_shape(session.utc_time, "0000-00-00T00:00:00Z"));
  const auto parsed = nlohmann::json::parse(gpf::to_json(session));
  BOOST_TEST(parsed.at("command").at(2) == "scene \"x\"\n");
  BOOST_TEST(parsed.at("command").at(3) == "\xef\xbf\xbd");  // not UTF-8: replaced
  BOOST_TEST(parsed.at("utc_time") == session.utc_time);
}

/// The script that the build runs, on a source folder of our own.
struct GitFacts {
  TemporaryFolder folder;
  fs::path source = folder / "source", header = folder / "facts.hpp";

  GitFacts() { fs::create_directories(source / "lib"); }

  void git(std::vector<std::string> arguments) const {
    std::vector<std::string> command{"git", "-C", source.string(), "-c", "user.name=t", "-c", "user.email=t@t"};
    command.insert(command.end(), arguments.begin(), arguments.end());
    const auto result = run_program(command, "");
    BOOST_TEST_REQUIRE(result.exit_status == 0, result.errors);
  }

  void commit_one_file() const {
    git({"init", "-q"});
    gpf::write_text_atomically(source / "lib/a.cpp", "one");
    git({"add", "lib"});
    git({"commit", "-q", "--no-gpg-sign", "-m", "first"});
  }

  /// commit and dirty as the header has them
  std::pair<std::string, std::string> facts(const fs::path& of) const {
    const auto result =
        run_program({GPF_CMAKE, "-DSOURCE=" + of.string(), "-DOUTPUT=" + header.string(), "-P", GPF_GIT_FACTS}, "");
    BOOST_TEST_REQUIRE(result.exit_status == 0, result.errors);
    BOOST_TEST(result.errors.empty(), result.errors);
    const std::string text = gpf::read_text(header);
    return {value_of(text, "commit"), value_of(text, "dirty")};
  }
};

BOOST_FIXTURE_TEST_CASE(no_repository_and_no_commit_are_unknown, GitFacts) {
  BOOST_TEST((facts(source) == std::pair<std::string, std::string>("unknown", "unknown")));
  git({"init", "-q"});
  BOOST_TEST((facts(source) == std::pair<std::string, std::string>("unknown", "unknown")));
}

BOOST_FIXTURE_TEST_CASE(commit_and_changes_to_sources, GitFacts) {
  commit_one_file();
  const auto [commit, dirty] = facts(source);
  BOOST_TEST(is_commit(commit));
  BOOST_TEST(dirty == "no");
  gpf::write_text_atomically(source / "report.md", "not a source");
  BOOST_TEST(facts(source).second == "no");
  gpf::write_text_atomically(source / "lib/b.cpp", "a new source");
  BOOST_TEST(facts(source).second == "yes");
  fs::remove(source / "lib/b.cpp");
  gpf::write_text_atomically(source / "lib/a.cpp", "changed");
  BOOST_TEST(facts(source).second == "yes");
}

BOOST_FIXTURE_TEST_CASE(header_is_left_alone_when_nothing_changed, GitFacts) {
  commit_one_file();
  facts(source);
  const auto long_ago = fs::last_write_time(header) - std::chrono::hours(1);
  fs::last_write_time(header, long_ago);
  facts(source);
  BOOST_TEST((fs::last_write_time(header) == long_ago));
  gpf::write_text_atomically(source / "lib/a.cpp", "changed");
  facts(source);
  BOOST_TEST((fs::last_write_time(header) != long_ago));
}

BOOST_FIXTURE_TEST_CASE(the_repository_around_a_source_tree_is_not_its_own, GitFacts) {
  commit_one_file();
  BOOST_TEST(facts(source / "lib").first == "unknown");
}

BOOST_FIXTURE_TEST_CASE(without_git_all_is_unknown, GitFacts) {
  commit_one_file();
  const gpf::test::ScopedVariable nowhere("PATH", "/nonexistent");
  const auto result = run_program({GPF_CMAKE, "-DSOURCE=" + source.string(), "-DOUTPUT=" + header.string(),
                                   "-DCMAKE_FIND_USE_CMAKE_SYSTEM_PATH=OFF", "-P", GPF_GIT_FACTS},
                                  "");
  BOOST_TEST(result.exit_status == 0, result.errors);
  BOOST_TEST(gpf::read_text(header).find("commit = \"unknown\"") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
