#include "verify/campaign_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "gpf/base/error.hpp"
#include "gpf/io/atomic_file.hpp"
#include "gpf/measure/block_series.hpp"
#include "gpf/measure/tallies.hpp"
#include "verify/campaign_collect.hpp"
#include "verify/file_lock.hpp"
#include "verify/report_markdown.hpp"

namespace gpf {
namespace {

RecordStore store_of(const CampaignFolder& folder) {
  return {folder.file("records"), Trust::same_version,
          [](const std::string& line) { fmt::print(stderr, "gpf: {}\n", line); }};
}

/// Throws StorageError when it cannot be made.
void make_folder(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error || !std::filesystem::is_directory(path))
    throw StorageError(fmt::format("cannot make the folder '{}'", path.string()),
                       error ? error.message() : "there is a file of that name",
                       "choose another place for the campaign");
}

/// Whoever changes the manifest holds this from reading it until it is written.
FileLock lock_of(const CampaignFolder& folder, const volatile std::sig_atomic_t* stop = nullptr) {
  auto lock = FileLock::wait(folder.file("manifest.lock"), stop);
  if (!lock) throw StorageError("the manifest is in use", "a signal came before it was free", "try again");
  return std::move(*lock);
}

std::ptrdiff_t wanted_in(const Manifest& manifest) {
  return std::count_if(manifest.begin(), manifest.end(), [](const ManifestEntry& e) { return e.wanted; });
}

/// The manifest to plan on; a damaged one is put aside.
Manifest manifest_before(const CampaignFolder& folder) {
  const std::filesystem::path path = folder.file("manifest.jsonl");
  if (!std::filesystem::exists(path)) return {};
  try {
    return load_manifest(folder);
  } catch (const InputError& error) {
    std::filesystem::path aside = path;
    aside += ".damaged";
    std::filesystem::rename(path, aside);
    fmt::print(stderr,
               "gpf: {}\ngpf: it is now '{}'; numbers start anew, and replicas that --adaptive added are no longer "
               "planned; finished runs are found\n",
               error.what(), aside.string());
    return {};
  }
}

/// A text from a file for a terminal, on one line.
std::string shown(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
  return text;
}

std::filesystem::path failure_file(const CampaignFolder& folder, std::size_t index) {
  return folder.file("failed") / fmt::format("{}", index);
}

/// MemAvailable of the kernel, in bytes; nothing where it does not say.
std::optional<std::uint64_t> free_memory() {
  std::ifstream file("/proc/meminfo");
  for (std::string key, rest; file >> key; std::getline(file, rest))
    if (std::uint64_t kilobytes = 0; key == "MemAvailable:" && file >> kilobytes) return 1024 * kilobytes;
  return std::nullopt;
}

int jobs_that_fit(const std::vector<RunJob>& jobs, int wanted) {
  std::uint64_t largest = 1;
  for (const RunJob& job : jobs) largest = std::max(largest, memory_of_run(job.file));
  const auto memory = free_memory();
  if (!memory) return wanted;
  const auto fit = static_cast<int>(std::clamp<std::uint64_t>(*memory / largest, 1, 1 << 20));
  if (fit < wanted)
    fmt::print(stderr, "{} of {} jobs: a run takes up to {} MB, {} MB are free\n", fit, wanted, largest >> 20,
               *memory >> 20);
  return std::min(fit, wanted);
}

/// Does these entries; true when the pool was stopped before it was done.
bool do_entries(const CampaignFolder& folder, const RecordStore& store, std::vector<ManifestEntry> entries,
                const CampaignRunOptions& options, std::vector<RunFailure>& failures) {
  std::stable_sort(entries.begin(), entries.end(), [](const ManifestEntry& a, const ManifestEntry& b) {
    return expected_collisions(job_of(a).file) > expected_collisions(job_of(b).file);
  });
  std::vector<RunJob> jobs;
  for (const ManifestEntry& entry : entries) jobs.push_back(job_of(entry));
  const PoolResult result = run_pool(store, jobs,
                                     {.jobs = jobs_that_fit(jobs, options.jobs),
                                      .checkpoint_period = options.checkpoint_period,
                                      .stop = options.stop,
                                      .command = options.command});
  for (const ManifestEntry& entry : entries) {
    const auto failed = std::find_if(result.failures.begin(), result.failures.end(),
                                     [&](const RunFailure& f) { return f.label == entry.label; });
    if (failed == result.failures.end()) {
      std::error_code none_there;
      if (store.load(job_of(entry).file)) std::filesystem::remove(failure_file(folder, entry.index), none_there);
      continue;
    }
    make_folder(folder.file("failed"));
    write_text_atomically(failure_file(folder, entry.index), failed->what + "\n");
  }
  failures.insert(failures.end(), result.failures.begin(), result.failures.end());
  return result.stopped;
}

/// Adds replicas where they are wanted; false when nothing is.
bool refine(const CampaignFolder& folder, const RecordStore& store, const volatile std::sig_atomic_t* stop) {
  const FileLock lock = lock_of(folder, stop);
  const Manifest manifest = load_manifest(folder);
  const Campaign campaign = load_campaign(folder.file("campaign.toml"));
  const Manifest refined = plan(campaign, refined_replicas(campaign, collect(campaign, manifest, store)), manifest);
  const auto more = wanted_in(refined) - wanted_in(manifest);
  if (more <= 0) return false;
  write_manifest(refined, folder);
  fmt::print(stderr, "{} more run(s) where structures are undecided or differ between neighbours\n", more);
  return true;
}

}  // namespace

std::uint64_t memory_of_run(const SceneFile& file) {
  // Resident memory of gpf run: 12 MB and 1.0 kB a disk at N 1000 ... 100,000, beside the sums of the blocks.
  constexpr std::uint64_t program = 16U << 20, disk = 2048;
  const std::uint64_t row = TallyLayout(file.run).size() * sizeof(double);
  return program + static_cast<std::uint64_t>(file.scene.particles) * disk + 2 * BlockSeries::most_blocks * row;
}

void plan_campaign(const std::filesystem::path& file, const CampaignFolder& folder,
                   const std::filesystem::path& program) {
  const Campaign campaign = load_campaign(file);
  const std::string name = folder.folder.string();
  if (name.empty() || std::any_of(name.begin(), name.end(), [](unsigned char c) { return c < 0x20; }))
    throw InputError("a campaign's folder has no name, or a line break in it", "it is written into a batch script",
                     "choose another name for --output");
  make_folder(folder.folder);
  const FileLock lock = lock_of(folder);
  const Manifest before = manifest_before(folder);
  // Replicas that --adaptive added stay.
  std::vector<int> replicas;
  for (const CampaignPoint& point : campaign.points) {
    const auto planned = std::count_if(before.begin(), before.end(), [&](const auto& e) {
      return e.wanted && e.label.starts_with(point.label + " #");
    });
    replicas.push_back(std::clamp(static_cast<int>(planned), campaign.replicas, campaign.most_replicas));
  }
  const Manifest manifest = plan(campaign, replicas, before);
  write_text_atomically(folder.file("campaign.toml"), campaign.text);
  write_text_atomically(folder.file("job.slurm"), slurm_script(folder, program, campaign.title));
  write_manifest(manifest, folder);
  double collisions = 0;
  const std::vector<ManifestEntry> open = missing(manifest, store_of(folder));
  for (const ManifestEntry& entry : open) collisions += expected_collisions(job_of(entry).file);
  fmt::print("{}: {} point(s), {} run(s), {} missing, roughly {:.2g} collisions\n", campaign.title,
             campaign.points.size(), wanted_in(manifest), open.size(), collisions);
  if (const auto dropped =
          wanted_in(before) + static_cast<std::ptrdiff_t>(manifest.size() - before.size()) - wanted_in(manifest);
      dropped > 0)
    fmt::print("{} run(s) of the plan before are no longer wanted; their records stay\n", dropped);
  if (campaign.most_replicas < fewest_decisive_replicas)
    fmt::print("with fewer than {} replicas no structure is sure at 95 %\n", fewest_decisive_replicas);
  fmt::print("{}\n", folder.file("manifest.jsonl").string());
}

int run_campaign(const CampaignFolder& folder, const CampaignRunOptions& options) {
  Manifest manifest = load_manifest(folder);
  const RecordStore store = store_of(folder);
  std::vector<RunFailure> failures;
  bool stopped = false;
  if (options.task) {
    if (*options.task >= manifest.size())
      throw InputError(fmt::format("no entry {} in the manifest", *options.task),
                       fmt::format("it has {}, counted from 0", manifest.size()), "see gpf campaign missing");
    const ManifestEntry& entry = manifest[*options.task];
    if (entry.wanted)
      stopped = do_entries(folder, store, {entry}, options, failures);
    else
      fmt::print(stderr, "entry {}, {}, is no longer wanted: nothing to do\n", entry.index, entry.label);
  } else {
    while (!stopped && failures.empty()) {
      const std::vector<ManifestEntry> open = missing(load_manifest(folder), store);
      if (open.empty() && !(options.adaptive && refine(folder, store, options.stop))) break;
      if (open.empty()) continue;
      fmt::print(stderr, "{} run(s) missing\n", open.size());
      stopped = do_entries(folder, store, open, options, failures);
    }
  }
  for (const RunFailure& failure : failures) fmt::print(stderr, "gpf: run {}: {}\n", failure.label, failure.what);
  if (!failures.empty()) return static_cast<int>(failures.front().status);
  if (stopped) {
    fmt::print(stderr, "gpf: stopped by a signal; the same command goes on\n");
    return static_cast<int>(ExitStatus::interrupted);
  }
  return static_cast<int>(ExitStatus::success);
}

void print_missing(const CampaignFolder& folder, bool as_ranges) {
  const std::vector<ManifestEntry> open = missing(load_manifest(folder), store_of(folder));
  if (as_ranges) {
    fmt::print("{}\n", index_ranges(open));
    return;
  }
  for (const ManifestEntry& entry : open) {
    const std::filesystem::path failed = failure_file(folder, entry.index);
    fmt::print("{}\t{}\t{}\n", entry.index, shown(entry.label),
               std::filesystem::exists(failed) ? "failed: " + shown(read_text(failed)) : "not done");
  }
}

std::filesystem::path collect_campaign(const CampaignFolder& folder) {
  const Campaign campaign = load_campaign(folder.file("campaign.toml"));
  const Manifest manifest = load_manifest(folder);
  const RecordStore store = store_of(folder);
  const std::vector<PointResult> results = collect(campaign, manifest, store);
  const std::size_t open = missing(manifest, store).size();
  const bool drawn = campaign.axes.size() <= 2;
  if (drawn) write_svg(phase_diagram(campaign, results), folder.file("phase.svg"));
  write_text_atomically(folder.file("phase.csv"), phase_csv(campaign, results));
  const std::string page = fmt::format(
      "# {}\n\n{}{}Structures are told by the density modes (verify/estimators/density_structure.hpp): the class of "
      "most "
      "replicas, with a\nquestion mark where it is not sure at 95 % that more than half of all replicas have it.\n\n{}",
      markdown_text(campaign.title), open > 0 ? fmt::format("{} run(s) are missing.\n\n", open) : "",
      drawn ? "![Phase diagram](phase.svg)\n\n[Data of all points](phase.csv)\n\n" : "",
      phase_table(campaign, results));
  write_text_atomically(folder.file("phase.md"), page);
  if (const std::string pictures = draw_snapshots(campaign, manifest, store, folder.file("snapshots"));
      !pictures.empty())
    write_text_atomically(folder.file("snapshots.md"),
                          fmt::format("# {}: snapshots\n\n{}", markdown_text(campaign.title), pictures));
  return folder.file("phase.md");
}

}  // namespace gpf
