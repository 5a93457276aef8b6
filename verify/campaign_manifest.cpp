#include "verify/campaign_manifest.hpp"

#include <fmt/format.h>

#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "gpf/base/error.hpp"
#include "gpf/io/atomic_file.hpp"
#include "gpf/io/record.hpp"
#include "verify/command_text.hpp"
#include "verify/run_pool.hpp"

namespace gpf {
Manifest plan(const Campaign& campaign, const std::vector<int>& replicas, const Manifest& before) {
  Manifest manifest = before;
  std::map<std::string, std::size_t> known;
  for (ManifestEntry& entry : manifest) {
    entry.wanted = false;
    known.emplace(entry.record, entry.index);
  }
  for (std::size_t p = 0; p < campaign.points.size(); ++p)
    for (int r = 0; r < replicas[p]; ++r) {
      const SceneFile file = replica_of(campaign.points[p].scene, r, 0);
      ManifestEntry entry{manifest.size(), static_cast<std::size_t>(r), record_name(file.scene, file.run),
                          fmt::format("{} #{}", campaign.points[p].label, r + 1), canonical_text(file.scene, file.run)};
      if (const auto found = known.find(entry.record); found != known.end()) {
        manifest[found->second].wanted = true;
        manifest[found->second].label = entry.label;
        continue;
      }
      known.emplace(entry.record, entry.index);
      manifest.push_back(std::move(entry));
    }
  return manifest;
}

Manifest load_manifest(const CampaignFolder& folder) {
  const std::filesystem::path path = folder.file("manifest.jsonl");
  if (!std::filesystem::exists(path))
    throw InputError(fmt::format("'{}' holds no campaign", folder.folder.string()),
                     fmt::format("there is no '{}'", path.string()),
                     "plan one: gpf campaign plan CAMPAIGN.toml -o " + folder.folder.string());
  std::istringstream text(read_text(path));
  Manifest manifest;
  std::optional<std::size_t> stated;
  const auto damaged = [&](std::size_t line, std::string why) {
    return InputError(fmt::format("{}:{}: not an entry of a manifest", path.string(), line), std::move(why),
                      "plan the campaign again: finished runs are found");
  };
  for (std::string line; std::getline(text, line);) {
    try {
      const auto json = nlohmann::json::parse(line);
      if (json.contains("entries")) {
        stated = json.at("entries").get<std::size_t>();
        continue;
      }
      manifest.push_back({json.at("index"), json.at("replica"), json.at("record"), json.at("label"), json.at("scene"),
                          json.at("wanted")});
    } catch (const nlohmann::json::exception&) {
      throw damaged(manifest.size() + 1, "the line is no entry");
    }
    const ManifestEntry& entry = manifest.back();
    if (entry.index != manifest.size() - 1) throw damaged(manifest.size(), "its number is out of order");
    const SceneFile file = job_of(entry).file;
    if (record_name(file.scene, file.run) != entry.record)
      throw damaged(manifest.size(), "its scene and its record are not of the same run");
  }
  if (stated != manifest.size()) throw damaged(manifest.size() + 1, "the end of the file is missing");
  return manifest;
}

void write_manifest(const Manifest& manifest, const CampaignFolder& folder) {
  std::string text;
  for (const ManifestEntry& e : manifest)
    text += nlohmann::json{{"index", e.index}, {"replica", e.replica}, {"record", e.record},
                           {"label", e.label}, {"scene", e.scene},     {"wanted", e.wanted}}
                .dump() +
            "\n";
  text += nlohmann::json{{"entries", manifest.size()}}.dump() + "\n";
  write_text_atomically(folder.file("manifest.jsonl"), text);
}

std::vector<ManifestEntry> missing(const Manifest& manifest, const RecordStore& store) {
  std::vector<ManifestEntry> entries;
  for (const ManifestEntry& entry : manifest)
    if (entry.wanted && !is_done(store, job_of(entry).file)) entries.push_back(entry);
  return entries;
}

RunJob job_of(const ManifestEntry& entry) {
  return {parse_scene(entry.scene, fmt::format("manifest entry {}", entry.index)), entry.label};
}

std::string index_ranges(const std::vector<ManifestEntry>& entries) {
  std::string text;
  for (std::size_t from = 0; from < entries.size();) {
    std::size_t to = from;
    while (to + 1 < entries.size() && entries[to + 1].index == entries[to].index + 1) ++to;
    if (!text.empty()) text += ",";
    text += from == to ? fmt::format("{}", entries[from].index)
                       : fmt::format("{}-{}", entries[from].index, entries[to].index);
    from = to + 1;
  }
  return text;
}

std::string slurm_script(const CampaignFolder& folder, const std::filesystem::path& program, const std::string& title) {
  const std::string place = shell_word(std::filesystem::absolute(folder.folder).string());
  std::string name;
  for (const char c : title) name += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '-';
  return fmt::format(R"sh(#!/bin/sh
# A job array for: {}
# Submit what is missing:   sbatch --array="$(gpf campaign missing --array {})" {}
#SBATCH --job-name={}
#SBATCH --ntasks=1
#SBATCH --cpus-per-task=1
#SBATCH --requeue
#SBATCH --open-mode=append
#SBATCH --signal=B:USR1@60

# Before its time is up, or when it is to make room, the task gets USR1: the run writes a checkpoint and ends with status
# 75, and the task is put back into the queue, to go on from there. TERM is how a cancelled task is told: it stays out.
run='' signal='' status=75
trap 'signal=USR1; [ -z "$run" ] || kill -USR1 "$run"' USR1
trap 'signal=TERM; [ -z "$run" ] || kill -TERM "$run"' TERM
{} campaign run {} --task "$SLURM_ARRAY_TASK_ID" &
run=$!
[ -z "$signal" ] || kill -"$signal" "$run"
wait "$run"; status=$?
while kill -0 "$run" 2> /dev/null; do wait "$run"; status=$?; done
early=$(kill -l "$status" 2> /dev/null) # USR1: it came before the program listened
if [ "$signal" = USR1 ] && {{ [ "$status" -eq 75 ] || [ "$early" = USR1 ]; }}; then
  scontrol requeue "${{SLURM_ARRAY_JOB_ID}}_${{SLURM_ARRAY_TASK_ID}}"
fi
exit "$status"
)sh",
                     title, place, shell_word(std::filesystem::absolute(folder.file("job.slurm")).string()),
                     name.substr(0, 40), shell_word(program.string()), place);
}

}  // namespace gpf
