// What must hold for every text: parse_campaign gives a campaign or throws an InputError that can be acted upon, and a
// campaign that it gives can be planned: its manifest names one record for each run, neighbours are mutual, and its
// title adds no line to the batch script.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "fuzz/check.hpp"
#include "verify/campaign.hpp"
#include "verify/campaign_manifest.hpp"

namespace {

using gpf::fuzz::require;

void check_neighbours(const gpf::Campaign& campaign) {
  for (std::size_t p = 0; p < campaign.points.size(); ++p)
    for (const std::size_t n : campaign.neighbours(p)) {
      require(n < campaign.points.size() && n != p, "a neighbour that is no point");
      const std::vector<std::size_t> back = campaign.neighbours(n);
      require(std::find(back.begin(), back.end(), p) != back.end(), "a neighbour that is not mutual");
    }
}

void check_sound(const gpf::Campaign& campaign) {
  require(campaign.replicas >= 1 && campaign.most_replicas >= campaign.replicas, "wrong replicas");
  const std::string script = gpf::slurm_script({"folder"}, "gpf", campaign.title),
                    plain = gpf::slurm_script({"folder"}, "gpf", "plain");
  require(std::count(script.begin(), script.end(), '\n') == std::count(plain.begin(), plain.end(), '\n'),
          "a title with a line of its own in the script");
  const auto commands = [](const std::string& text) { return text.substr(text.find("\ntrap")); };
  require(commands(script) == commands(plain), "a title among the commands");
  if (campaign.points.size() > 100) return;
  check_neighbours(campaign);
  const std::vector<int> once(campaign.points.size(), 1);
  const gpf::Manifest manifest = plan(campaign, once, {});
  std::set<std::string> records;
  for (const gpf::ManifestEntry& entry : manifest) {
    require(entry.record.find_first_not_of("0123456789abcdef") == std::string::npos, "a record with another name");
    require(records.insert(entry.record).second, "two runs with one record");
    require(entry.label.find('\n') == std::string::npos, "a label of two lines");
    static_cast<void>(job_of(entry));
  }
  const gpf::Manifest again = plan(campaign, once, manifest);
  require(again.size() == manifest.size(), "planned again, it has other runs");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(data, data + size);
  try {
    check_sound(gpf::parse_campaign(text, "fuzz"));
  } catch (const gpf::InputError& error) {
    gpf::fuzz::require_usable(error, "fuzz");
  }
  return 0;
}
