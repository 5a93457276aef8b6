// Two programs side by side: where their runs part, and what they cost.
#include "verify/audit/replay.hpp"

#include <fmt/format.h>

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "gpf/base/error.hpp"
#include "gpf/io/atomic_file.hpp"
#include "unit/io/temporary_folder.hpp"
#include "verify/audit/cost.hpp"

using namespace gpf;

namespace {

struct Programs {
  test::TemporaryFolder folder;

  /// A program in words of the shell.
  [[nodiscard]] std::filesystem::path program(const std::string& name, const std::string& body) const {
    write_text_atomically(folder / name, "#!/bin/sh\n" + body + "\n");
    std::filesystem::permissions(folder / name, std::filesystem::perms::owner_all);
    return folder / name;
  }
  /// gpf with its scene changed by sed, at any scene that `gpf run` or `gpf trace` is given.
  [[nodiscard]] std::filesystem::path changed(const std::string& sed) const {
    return program("changed", fmt::format("sed '{}' \"$2\" > \"$2.changed\"\nverb=$1 scene=$2.changed\nshift 2\n"
                                          "exec {} $verb \"$scene\" \"$@\"",
                                          sed, GPF_PROGRAM));
  }
  [[nodiscard]] ReplayTask task(const std::filesystem::path& after) const {
    return {.scene =
                "[scene]\ngeometry = \"channel\"\nparticles = 64\nwidth_over_diameter = 12\narea_fraction = 0.2\n"
                "normal_restitution = 0.9\nwall_tangential_restitution = 0.9\n[run]\nstart_up = 1\nduration = 2\n",
            .epochs = 5,
            .epoch_length = 0.1,
            .before = GPF_PROGRAM,
            .after = after,
            .folder = folder.path(),
            .between = [] {}};
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(side_by_side)

BOOST_FIXTURE_TEST_CASE(programs_that_agree_have_no_first_difference, Programs) {
  BOOST_TEST(!replay(task(GPF_PROGRAM)).has_value());
}

BOOST_FIXTURE_TEST_CASE(the_first_collision_with_another_restitution_is_found, Programs) {
  const auto found = replay(task(changed("s/^normal_restitution = 0.9$/normal_restitution = 0.9000001/")));
  BOOST_TEST_REQUIRE(found.has_value());
  BOOST_TEST((found->kind == EventDifference::Kind::numbers));
  BOOST_TEST(!found->other_start);
  BOOST_TEST(found->before.first == found->after.first);
  BOOST_TEST(found->before.second == found->after.second);
  BOOST_TEST_REQUIRE(!found->numbers.empty());
  for (const NumberDifference& n : found->numbers) BOOST_TEST(n.name.starts_with("v_"), n.name);  // not its time
  BOOST_TEST(found->largest_ulps > 1e3);   // 1e-7 of a velocity, in units of 1e-16
  BOOST_TEST(found->largest_ulps < 1e11);  // and not another collision
}

BOOST_FIXTURE_TEST_CASE(another_start_is_told_from_another_rule, Programs) {
  const auto found = replay(task(changed("s/^particles/seed = 2\\nparticles/")));
  BOOST_TEST_REQUIRE(found.has_value());
  BOOST_TEST(found->other_start);
}

BOOST_FIXTURE_TEST_CASE(a_program_that_cannot_trace_is_named_with_its_reason, Programs) {
  BOOST_CHECK_EXCEPTION(
      replay(task(program("old", "echo 'no such command' >&2\nexit 2"))), InputError, [](const InputError& e) {
        const std::string text = e.what();
        return text.find("old cannot trace") != std::string::npos && text.find("no such command") != std::string::npos;
      });
}

BOOST_FIXTURE_TEST_CASE(a_replay_is_stopped_between_runs, Programs) {
  ReplayTask stopped = task(GPF_PROGRAM);
  int runs = 0;
  stopped.between = [&] {
    if (++runs == 2) throw InputError("stopped", "", "");
  };
  BOOST_CHECK_THROW(replay(stopped), InputError);
  BOOST_TEST(runs == 2);
}

BOOST_FIXTURE_TEST_CASE(cost_is_measured_in_turn, Programs) {
  const CostComparison cost = measure_cost(GPF_PROGRAM, GPF_PROGRAM, folder.path(), 1);
  BOOST_TEST(cost.interleaved);
  BOOST_TEST_REQUIRE(cost.before.size() == 1U);
  BOOST_TEST(cost.before[0] > 20e-9);  // a collision takes some 200 ns
  BOOST_TEST(cost.before[0] < 50e-6);
  BOOST_TEST(cost.ratio == cost.after[0] / cost.before[0]);
  BOOST_TEST(cost.memory_after > 1e6);
}

BOOST_FIXTURE_TEST_CASE(a_program_that_fails_or_is_stopped_has_no_cost, Programs) {
  const auto failing = program("failing", "echo 'engine lost' >&2\nexit 3");
  BOOST_CHECK_EXCEPTION(measure_cost(failing, GPF_PROGRAM, folder.path(), 1), InputError, [](const InputError& e) {
    return std::string(e.what()).find("engine lost") != std::string::npos;
  });
  const volatile std::sig_atomic_t stop = 1;
  BOOST_CHECK_THROW(measure_cost(GPF_PROGRAM, GPF_PROGRAM, folder.path(), 1, &stop), InputError);
}

BOOST_AUTO_TEST_SUITE_END()
