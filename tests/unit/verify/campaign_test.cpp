// Campaigns: the file, the manifest, and what the records say.
#include "verify/campaign.hpp"

#include <boost/test/unit_test.hpp>
#include <fstream>

#include "gpf/base/error.hpp"
#include "gpf/io/atomic_file.hpp"
#include "unit/io/temporary_folder.hpp"
#include "unit/verify/fake_run.hpp"
#include "verify/campaign_collect.hpp"
#include "verify/campaign_run.hpp"

using namespace gpf;

namespace {

const std::string head = "title = \"Lengths and walls\"\nreplicas = 4\nmost_replicas = 16\n";
const std::string axes = "[axes]\nlength_over_width = [1, 2, 4.5]\nwall_tangential_restitution = [0.6, [0.1, 0.9]]\n";
const std::string scene = R"([scene]
geometry = "channel"
area_fraction = 0.2
width_over_diameter = 12
normal_restitution = 0.9
[run]
start_up = 0
duration = 8
bins = 2
density_modes = 3
)";

Campaign campaign() { return parse_campaign(head + axes + scene, "c.toml"); }

/// The error that a campaign text causes.
std::string refusal(const std::string& text) {
  try {
    static_cast<void>(parse_campaign(text, "c.toml"));
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// Contrasts of a run: 1 everywhere but in the even or the odd mode k = 1.
Record record_with(const SceneFile& file, double even, double odd) {
  Record record = test::fake_record(file, 8);
  const TallyLayout layout(file.run);
  for (std::size_t b = 0; b < record.blocks; ++b) {
    double* row = record.sums.data() + b * layout.size();
    using enum Tally;
    for (const Tally noise : {mode_noise_even, mode_noise_odd, mode_noise_varicose}) row[layout.at(noise)] = 1;
    for (const Tally power : {mode_even, mode_odd, mode_varicose})
      for (int k = 0; k < 3; ++k) row[layout.at(power, k)] = 1;
    row[layout.at(mode_even)] = even;
    row[layout.at(mode_odd)] = odd;
    row[layout.at(band_cos)] = 1;
  }
  return record;
}

struct Fixture {
  test::TemporaryFolder folder;
  RecordStore store{folder / "records", Trust::same_version};
  Campaign plan_of = campaign();
  Manifest manifest = plan(plan_of, std::vector<int>(plan_of.points.size(), plan_of.replicas), {});

  /// Plugs below L/W 2, waves at 2, slugs above; where the walls differ and L/W is 2 every second run is a slug.
  void run_all() const {
    for (const ManifestEntry& entry : manifest) {
      const SceneFile file = job_of(entry).file;
      const double length = file.scene.length_over_width;
      const bool differ = file.scene.wall_tangential_restitution[0] < 0.5;
      if (length < 1.5)
        store.save(file, record_with(file, 1, 1));
      else if (length > 3 || (differ && entry.replica % 2 == 0))
        store.save(file, record_with(file, 40, 1));
      else
        store.save(file, record_with(file, 1, 40));
    }
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(campaign_test)

BOOST_AUTO_TEST_CASE(points_are_all_combinations_the_last_axis_fastest) {
  const Campaign c = campaign();
  BOOST_REQUIRE(c.points.size() == 6U);
  BOOST_TEST(c.points[1].label == "length_over_width = 1, wall_tangential_restitution = [0.1, 0.9]");
  BOOST_TEST(c.points[4].scene.scene.length_over_width == 4.5, boost::test_tools::tolerance(0.02));  // whole disks
  BOOST_TEST(c.points[3].scene.scene.wall_tangential_restitution[1] == 0.9);
  BOOST_TEST(c.points[2].scene.scene.wall_tangential_restitution[1] == 0.6);
  BOOST_TEST(c.axes[1].numbers[1] == 0.1);
  BOOST_TEST(c.neighbours(0) == (std::vector<std::size_t>{1, 2}), boost::test_tools::per_element());
  BOOST_TEST(c.neighbours(3).size() == 3U);
  BOOST_TEST(parse_campaign(head + "[axes]\nduration = [4, 8]\nlength_over_width = [2]\n" +
                                scene.substr(0, scene.find("[run]")) +
                                "wall_tangential_restitution = 0.5\n[run]\nstart_up = 0\ndensity_modes = 1\n",
                            "c.toml")
                 .points[1]
                 .scene.run.duration == 8.0);
}

BOOST_AUTO_TEST_CASE(what_cannot_be_a_campaign_is_refused_with_place_and_remedy) {
  BOOST_TEST(contains(refusal("titel = \"x\"\n" + axes + scene), "'title'"));
  BOOST_TEST(contains(refusal(head + "[axes]\nlenght_over_width = [1]\n" + scene), "did you mean 'length_over_width'"));
  BOOST_TEST(contains(refusal(head + "[axes]\nlength_over_width = 2\n" + scene), "not a list"));
  BOOST_TEST(contains(refusal(head + "[axes]\nlength_over_width = []\n" + scene), "not a list"));
  BOOST_TEST(contains(refusal(head + "[axes]\nlength_over_width = [1, 1]\n" + scene), "twice"));
  BOOST_TEST(contains(refusal(head + "[axes]\n" + scene), "empty"));
  BOOST_TEST(contains(refusal(head + "[axes]\nseed = [1, 2]\n" + scene), "replicas"));
  BOOST_TEST(contains(refusal(head + "[axes]\narea_fraction = [0.1]\n" + scene), "both fixed and an axis"));
  BOOST_TEST(
      contains(refusal(head + "[axes]\nlength_over_width = [1, -2]\nwall_tangential_restitution = [0.5]\n" + scene),
               "length_over_width = -2"));
  BOOST_TEST(contains(refusal("title = \"x\"\nreplicas = 0\n" + axes + scene), "replicas = 0"));
  BOOST_TEST(contains(refusal(head + "precision = 1.5\n" + axes + scene), "precision = 1.5"));
  BOOST_TEST(parse_campaign(head + "precision = 0.02\n" + axes + scene, "c.toml").precision == 0.02);
  BOOST_TEST(contains(refusal("title = \"x\"\nreplicas = 8\nmost_replicas = 4\n" + axes + scene), "most_replicas = 4"));
  BOOST_TEST(contains(refusal(head + axes), "scene"));
  std::string plain = scene;
  plain.erase(plain.find("density_modes = 3\n"));
  BOOST_TEST(contains(refusal(head + axes + plain), "no density modes"));
  BOOST_TEST(contains(
      refusal(head + "[axes]\nlength_over_width = [2]\nwall_tangential_restitution = [0.9, [0.9, 0.9]]\n" + scene),
      "the same scene"));
  BOOST_TEST(
      contains(refusal(head + "[axes]\nlength_over_width = [2, 2.0]\nwall_tangential_restitution = [0.9]\n" + scene),
               "the same scene"));
  BOOST_TEST(contains(refusal(head + "[axes]\nlattice = [\"a\\nb\"]\n" + scene), "control characters"));
  BOOST_TEST(contains(refusal(head + "[axes]\nstart_up = [2020-01-01]\n" + scene), "a date"));
  BOOST_CHECK_THROW(load_campaign("no such file"), StorageError);
}

BOOST_FIXTURE_TEST_CASE(a_number_in_the_manifest_never_changes, Fixture) {
  BOOST_REQUIRE(manifest.size() == 24U);
  const Campaign smaller = parse_campaign(
      head + "[axes]\nlength_over_width = [2, 7]\nwall_tangential_restitution = [0.6, [0.1, 0.9]]\n" + scene, "c.toml");
  const Manifest second = plan(smaller, std::vector<int>(4, 4), manifest);
  BOOST_REQUIRE(second.size() == 32U);
  for (std::size_t k = 0; k < manifest.size(); ++k) {
    BOOST_TEST(second[k].record == manifest[k].record);
    BOOST_TEST(second[k].wanted == (k / 8 == 1));  // L/W 2
  }
  const Manifest third = plan(plan_of, std::vector<int>(6, 4), second);
  BOOST_TEST(third.size() == 32U);
  BOOST_TEST(std::count_if(third.begin(), third.end(), [](const auto& e) { return e.wanted; }) == 24);

  const CampaignFolder place{folder / "campaign"};
  std::filesystem::create_directories(place.folder);
  write_manifest(third, place);
  const Manifest read = load_manifest(place);
  BOOST_REQUIRE(read.size() == third.size());
  for (std::size_t k = 0; k < read.size(); ++k) {
    BOOST_TEST(read[k].scene == third[k].scene);
    BOOST_TEST(read[k].label == third[k].label);
    BOOST_TEST(read[k].wanted == third[k].wanted);
    BOOST_TEST(record_name(job_of(read[k]).file.scene, job_of(read[k]).file.run) == third[k].record);
  }
  const std::string whole = read_text(place.file("manifest.jsonl"));
  const auto refused = [&](const std::string& damaged) {
    write_text_atomically(place.file("manifest.jsonl"), damaged);
    BOOST_CHECK_THROW(load_manifest(place), InputError);
  };
  refused("");
  refused(whole.substr(0, whole.find('\n') + 1));  // the end is missing
  refused(whole + "{\"index\": 99}\n");            // no entry
  refused(whole.substr(whole.find('\n') + 1));     // the first is missing
  std::string other = whole;
  refused(other.replace(other.find("seed = "), 8, "seed = 9"));  // another run under the same name
  write_text_atomically(place.file("manifest.jsonl"), whole);
  BOOST_TEST(load_manifest(place).size() == third.size());
  BOOST_CHECK_THROW(load_manifest({folder / "nothing"}), InputError);
}

BOOST_FIXTURE_TEST_CASE(what_has_no_record_is_missing, Fixture) {
  BOOST_TEST(missing(manifest, store).size() == 24U);
  BOOST_TEST(index_ranges(missing(manifest, store)) == "0-23");
  for (const std::size_t k : {0U, 5U, 6U, 8U, 23U}) {
    const SceneFile file = job_of(manifest[k]).file;
    store.save(file, record_with(file, 1, 1));
  }
  BOOST_TEST(index_ranges(missing(manifest, store)) == "1-4,7,9-22");
  manifest[7].wanted = false;
  BOOST_TEST(index_ranges(missing(manifest, store)) == "1-4,9-22");
  BOOST_TEST(index_ranges({}).empty());
}

BOOST_FIXTURE_TEST_CASE(the_phase_diagram_has_the_class_of_each_point_and_its_confidence, Fixture) {
  run_all();
  const std::vector<PointResult> results = collect(plan_of, manifest, store);
  BOOST_REQUIRE(results.size() == 6U);
  BOOST_TEST(results[0].name() == "plug?");  // 4 of 4: the share may be as low as .47
  BOOST_TEST(results[0].share.hits == 4U);
  BOOST_TEST(std::abs(results[0].confidence.lo - std::pow(0.05, 0.25)) < 1e-9);
  BOOST_TEST(results[2].name() == "wave?");
  BOOST_TEST(results[3].name() == "between the classes");  // two and two
  BOOST_TEST(!results[3].decided());
  BOOST_TEST(results[5].name() == "slug?");
  BOOST_TEST(results[5].band_shift.size() == 4U);

  const std::vector<int> replicas = refined_replicas(plan_of, results);
  for (const int r : replicas) BOOST_TEST(r == 8);  // none is decided
  manifest = plan(plan_of, replicas, manifest);
  run_all();
  const std::vector<PointResult> more = collect(plan_of, manifest, store);
  BOOST_TEST(more[0].name() == "plug");
  BOOST_TEST(more[3].name() == "bistable");
  const std::vector<int> again = refined_replicas(plan_of, more);
  BOOST_TEST(again[0] == 16);  // its neighbour at L/W 2 has waves
  BOOST_TEST(again[3] == 16);
  BOOST_TEST(again[5] == 16);  // a slug beside the bistable point

  const std::string table = phase_table(plan_of, more), csv = phase_csv(plan_of, more);
  BOOST_TEST(contains(table, "8 plug"));
  BOOST_TEST(contains(csv, "\"[0.1, 0.9]\""));
  BOOST_TEST(std::count(csv.begin(), csv.end(), '\n') == 7);
  const Plot plot = phase_diagram(plan_of, more);
  BOOST_TEST(plot.series.size() == 4U);
  BOOST_TEST(contains(gnuplot_script(plot), "bistable"));
}

BOOST_FIXTURE_TEST_CASE(points_without_neighbours_of_another_class_need_no_more, Fixture) {
  const Campaign flat =
      parse_campaign("title = \"x\"\nreplicas = 8\nmost_replicas = 32\n[axes]\nlength_over_width = [0.7, 0.9, 1.1]\n" +
                         scene.substr(0, scene.find("[run]")) + "wall_tangential_restitution = 0.6\n" +
                         scene.substr(scene.find("[run]")),
                     "c.toml");
  const Manifest all = plan(flat, std::vector<int>(3, 8), {});
  for (const ManifestEntry& entry : all) store.save(job_of(entry).file, record_with(job_of(entry).file, 1, 1));
  for (const int r : refined_replicas(flat, collect(flat, all, store))) BOOST_TEST(r == 8);
  Campaign precise = flat;
  std::vector<PointResult> results = collect(flat, all, store);
  for (PointResult& result : results) result.mean_flow = {10, 10.2, 9.8, 10, 10.1, 9.9, 10, 10};  // .044 of 10
  precise.precision = 0.005;
  for (const int r : refined_replicas(precise, results)) BOOST_TEST(r == 8);
  precise.precision = 0.004;
  for (const int r : refined_replicas(precise, results)) BOOST_TEST(r == 16);
  BOOST_TEST(collect(flat, {}, store)[0].name() == "no run");
  BOOST_TEST(phase_diagram(flat, collect(flat, all, store)).series.size() == 1U);
}

BOOST_AUTO_TEST_CASE(the_batch_script_quotes_what_users_name) {
  const std::string script = slurm_script({"it's here"}, "/opt/my gpf", "Title; rm -rf $HOME");
  BOOST_TEST(contains(script, "'/opt/my gpf' campaign run "));
  BOOST_TEST(contains(script, "it'\\''s here'"));
  BOOST_TEST(contains(script, "--job-name=Title--rm--rf--HOME"));
}

BOOST_AUTO_TEST_SUITE_END()
