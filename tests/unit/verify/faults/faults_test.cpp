// Faults: inert at dose 0, at work at their own, and caught by claims that read what they touch.
#include <boost/test/unit_test.hpp>
#include <set>

#include "gpf/base/error.hpp"
#include "unit/verify/suite_fixture.hpp"
#include "verify/faults/fault_page.hpp"
#include "verify/faults/fault_trial.hpp"
#include "verify/faults/faulty_simulation.hpp"

using namespace gpf;

namespace {

// Dense, dissipative and asymmetric, with the TC model at work: every fault shows.
const std::string revealing_scene = R"([scene]
geometry = "channel"
particles = 60
area_fraction = 0.5
width_over_diameter = 9
normal_restitution = 0.7
wall_normal_restitution = 0.95
wall_tangential_restitution = [0.2, 0.8]
tc_time = 1e-3
[run]
start_up = 1
duration = 3
sample_interval = 0.125
bins = 6
)";

bool same(const Record& a, const Record& b) {
  const auto bits = [](const State& s) {
    std::vector<double> numbers;
    for (const auto* vectors : {&s.position, &s.velocity})
      for (const Vec2 v : *vectors) numbers.insert(numbers.end(), {v.x, v.y});
    return numbers;
  };
  return a.trace_hash == b.trace_hash && a.sums == b.sums && bits(a.final_state) == bits(b.final_state) &&
         a.history.energy == b.history.energy &&
         std::equal(a.arrays.begin(), a.arrays.end(), b.arrays.begin(), b.arrays.end(),
                    [](const NamedArray& x, const NamedArray& y) { return x.name == y.name && x.values == y.values; });
}

struct Revealing {
  test::TemporaryFolder folder;
  SceneFile file = parse_scene(revealing_scene, "revealing.toml");
  Record right = *simulate(file);

  Record with(const Fault& fault, double dose) const { return *simulate_with(fault, dose, folder.path())(file, {}); }
};

}  // namespace

BOOST_FIXTURE_TEST_SUITE(fault_injection, Revealing)

BOOST_AUTO_TEST_CASE(a_dose_of_nothing_changes_no_bit) {
  for (const Fault& fault : faults()) BOOST_TEST(same(with(fault, 0), right), fault.name);
}

BOOST_AUTO_TEST_CASE(each_fault_is_at_work_and_its_record_says_that_nothing_is_wrong) {
  for (const Fault& fault : faults()) {
    try {
      const Record wrong = with(fault, fault.dose);
      BOOST_TEST(!same(wrong, right), fault.name);
      BOOST_TEST(canonical_text(wrong.scene, wrong.run) == canonical_text(file.scene, file.run));
      // What is only measured wrongly moves no disk.
      const FaultPoints& p = fault.points;
      if (!p.scene && !p.pair && !p.wall) BOOST_TEST(wrong.trace_hash == right.trace_hash, fault.name);
    } catch (const PhysicsError&) {
      BOOST_TEST_MESSAGE(fault.name << ": the engine refuses to go on");
    }
  }
}

BOOST_AUTO_TEST_CASE(a_fault_in_the_sums_takes_the_right_record_where_there_is_one) {
  const RecordStore store(folder.path(), Trust::same_sources);
  Record marked = right;
  marked.time = 12345;
  store.save(file, marked);
  BOOST_TEST(with(fault_named("time off by 1 %"), 0.01).time == 12345);
  BOOST_TEST(with(fault_named("velocities off by 0.5 %"), 0.01).time != 12345);
}

BOOST_AUTO_TEST_CASE(a_gas_that_a_fault_brings_to_rest_is_not_waited_for) {
  const SceneFile gas = parse_scene(R"([scene]
geometry = "periodic"
particles = 64
area_fraction = 0.6
length_over_width = 1
normal_restitution = 1
[run]
collisions_per_particle = 100000
bins = 1
)",
                                    "gas.toml");
  BOOST_CHECK_THROW(simulate_with(fault_named("disks not smooth"), 0.5, folder.path())(gas, {}), PhysicsError);
}

BOOST_AUTO_TEST_CASE(names_are_known_and_told_apart) {
  std::set<std::string> folders;
  for (const Fault& fault : faults()) {
    folders.insert(folder_of(fault));
    BOOST_TEST(fault.dose > 0);
    BOOST_TEST(fault.dose <= largest_dose(fault));
    BOOST_TEST(&fault_named(folder_of(fault)) == &fault);
  }
  BOOST_TEST(folders.size() == faults().size());
  BOOST_TEST(faults().size() >= 24U);
  BOOST_CHECK_EXCEPTION(fault_named("g of by 2 %"), InputError, [](const InputError& error) {
    return std::string(error.what()).find("did you mean 'g off by 2 %'?") != std::string::npos;
  });
}

BOOST_AUTO_TEST_SUITE_END()

namespace {

/// The virial of real runs of a small gas against what they are.
struct SmallSuite : test::Suite {
  FaultOptions trial{.tier = Tier::quick, .store = options.store, .reference = options.reference, .jobs = 1};

  SmallSuite() {
    std::ofstream(folder / "claims/algo.two.toml") << R"(id = "algo.two"
title = "t"
chapter = 2
source = "s"
statement = "s"
method = "m"
kind = "band"
expected = "reproduced"
estimator = "eos_virial"
tolerance_unit = "relative"
catches = ["virial counted once for each disk"]
[scenes]
quick = ["eos"]
[replicas]
quick = 4
[[tolerance]]
name = "all"
value = 0.1
evidence = "made up"
)";
    std::ofstream(folder / "scenes/eos.toml") << test::replaced(
        test::replaced(test::periodic_scene, "particles = 36", "particles = 100"), "duration = 8", "duration = 40");
  }
  [[nodiscard]] std::vector<Claim> claims() const { return claims_with_records(options.reference, Tier::quick); }
};

FaultTrial::Answer made_up(Caught caught) { return {caught, "so it is", 1}; }

}  // namespace

BOOST_FIXTURE_TEST_SUITE(fault_trials, SmallSuite)

BOOST_AUTO_TEST_CASE(a_claim_catches_what_it_reads_and_nothing_else) {
  const auto virial = try_fault(fault_named("virial counted once for each disk"), 1, claims(), trial);
  BOOST_TEST(name_of(virial->claims.at("algo.two").caught) == "caught");
  const auto walls = try_fault(fault_named("walls exchanged"), 1, claims(), trial);
  BOOST_TEST(name_of(walls->claims.at("algo.two").caught) == "not");
}

BOOST_AUTO_TEST_CASE(answers_are_kept_until_the_claim_changes) {
  const Fault& fault = fault_named("virial counted once for each disk");
  const auto kept = folder / "records/faults/virial-counted-once-for-each-disk/quick-1.json";
  try_fault(fault, 1, claims(), trial);
  const std::string answers = read_text(kept);
  write_text_atomically(kept, test::replaced(answers, "\"caught\": \"caught\"", "\"caught\": \"inconclusive\""));
  BOOST_TEST(name_of(try_fault(fault, 1, claims(), trial)->claims.at("algo.two").caught) == "inconclusive");
  std::ofstream(folder / "claims/algo.two.toml", std::ios::app) << "# another text\n";
  BOOST_TEST(name_of(try_fault(fault, 1, claims(), trial)->claims.at("algo.two").caught) == "caught");
  BOOST_TEST(!std::filesystem::exists(folder / "records/faults/virial-counted-once-for-each-disk/records"));
}

BOOST_AUTO_TEST_CASE(answers_of_another_scene_dose_or_program_and_damaged_ones_are_not_used) {
  const Fault& fault = fault_named("virial counted once for each disk");
  const auto kept = folder / "records/faults/virial-counted-once-for-each-disk/quick-1.json";
  try_fault(fault, 1, claims(), trial);
  const std::string answers = read_text(kept);
  const std::string other = test::replaced(answers, "\"caught\": \"caught\"", "\"caught\": \"not\"");
  const auto answer = [&](double dose = 1) {
    return name_of(try_fault(fault, dose, claims(), trial)->claims.at("algo.two").caught);
  };
  write_text_atomically(kept, other);
  BOOST_TEST(answer() == "not");
  BOOST_TEST(answer(1.0000004) == "caught");  // the same file, another dose
  for (const std::string& damaged : {std::string("{"), std::string("{\"sources\": 5}"), answers.substr(0, 40),
                                     test::replaced(other, "\"dose\": 1.0", "\"dose\": 0.5")}) {
    write_text_atomically(kept, damaged);
    BOOST_TEST(answer() == "caught", damaged);
  }
  write_text_atomically(kept, other);
  std::ofstream(folder / "scenes/eos.toml") << test::replaced(
      test::replaced(test::periodic_scene, "particles = 36", "particles = 144"), "duration = 8", "duration = 40");
  BOOST_TEST(answer() == "caught");
}

BOOST_AUTO_TEST_CASE(a_failed_budget_of_energy_is_an_alarm) {
  const auto found = try_fault(fault_named("impulse not along the line of centres"), 0.01, claims(), trial);
  BOOST_TEST(name_of(found->claims.at("algo.two").caught) == "health check");
}

BOOST_AUTO_TEST_CASE(a_dose_that_makes_no_sense_is_refused) {
  for (const double dose : {-0.1, 1.5, std::nan(""), 1e300})
    BOOST_CHECK_THROW(try_fault(fault_named("start-up not discarded"), dose, claims(), trial), InputError);
}

BOOST_AUTO_TEST_CASE(a_folder_that_cannot_be_written_is_no_fault_of_the_physics) {
  FaultOptions blocked = trial;
  blocked.store = "/proc/none";
  BOOST_CHECK_THROW(try_fault(fault_named("virial counted once for each disk"), 1, claims(), blocked), StorageError);
}

BOOST_AUTO_TEST_CASE(the_matrix_wants_claims_that_are_green_without_a_fault) {
  BOOST_TEST(all_green_without_fault(claims(), trial));
  const auto path = folder / "claims/algo.two.toml";
  write_text_atomically(path, test::replaced(read_text(path), "\"reproduced\"", "\"refuted\""));
  BOOST_CHECK_THROW(all_green_without_fault(claims(), trial), InputError);
}

BOOST_AUTO_TEST_CASE(the_smallest_dose_lies_where_the_claim_begins_to_catch_it) {
  const Fault& fault = fault_named("virial counted once for each disk");
  const auto found = smallest_dose(fault, claims().front(), trial);
  BOOST_TEST(found->missed > 0);
  BOOST_TEST(found->caught <= 1.2 * found->missed);
  BOOST_TEST(found->caught > 0.02);
  BOOST_TEST(found->caught < 1);
  BOOST_CHECK_THROW(smallest_dose(fault_named("walls exchanged"), claims().front(), trial), InputError);
}

BOOST_AUTO_TEST_CASE(the_page_shows_who_catches_what) {
  FaultMatrix matrix;
  matrix.claims = claims();
  matrix.others = {"algo.own"};
  matrix.trials = {{"g off by 2 %", 0.02, Tier::quick, {{"algo.two", made_up(Caught::yes)}}},
                   {"walls exchanged", 1, Tier::quick, {{"algo.two", made_up(Caught::no)}}},
                   {"virial counted once for each disk", 1, Tier::quick, {{"algo.two", made_up(Caught::undecided)}}}};
  matrix.trials.push_back({"loss counted twice", 1, Tier::quick, {{"algo.two", made_up(Caught::health)}}});
  const std::vector<std::string> missed{"walls exchanged", "virial counted once for each disk"};
  BOOST_TEST(matrix.missed() == missed, boost::test_tools::per_element());
  write_fault_page(matrix, folder / "pages");
  const std::string page = read_text(folder / "pages/faults.md"), svg = read_text(folder / "pages/faults.svg");
  BOOST_TEST(page.find("4 faults are put into the physics") != std::string::npos);
  BOOST_TEST(page.find("2 of the faults are caught by at least one of 1 claims") != std::string::npos);
  BOOST_TEST(page.find("none catches: walls exchanged, virial counted once for each disk") != std::string::npos);
  BOOST_TEST(page.find("algo.own") != std::string::npos);
  BOOST_TEST(svg.find("g off by 2 %") != std::string::npos);
  BOOST_TEST(read_text(folder / "pages/faults.csv") ==
             "claim,fault,tier,dose,caught\nalgo.two,\"g off by 2 %\",quick,0.02,caught\n"
             "algo.two,\"walls exchanged\",quick,1,not\n"
             "algo.two,\"virial counted once for each disk\",quick,1,inconclusive\n"
             "algo.two,\"loss counted twice\",quick,1,health check\n");
}

BOOST_AUTO_TEST_SUITE_END()
