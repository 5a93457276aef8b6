#include "verify/audit/cost.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "gpf/base/error.hpp"
#include "gpf/io/atomic_file.hpp"
#include "gpf/io/record.hpp"
#include "verify/audit/child.hpp"

namespace gpf {
namespace {

/// Neither dilute nor dense, every kind of event, 1 to 2 million collisions.
constexpr std::string_view scene = R"([scene]
geometry = "channel"
particles = 900
area_fraction = 0.3
width_over_diameter = 31
normal_restitution = 0.9
wall_tangential_restitution = 0.9
seed = 1
[run]
start_up = 5
duration = 75
)";

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return (values[(n - 1) / 2] + values[n / 2]) / 2;
}

struct OneRun {
  double seconds_per_contact, memory;
};

OneRun run_once(const std::filesystem::path& program, const std::filesystem::path& folder,
                const volatile std::sig_atomic_t* stop) {
  const std::filesystem::path file = folder / "cost.toml", record = folder / "cost.h5", log = folder / "cost.log";
  std::filesystem::remove(log);
  const ChildResult child =
      run_child({program.string(), "run", file.string(), "-o", record.string(), "--force"}, log, stop);
  std::error_code ignored;
  std::filesystem::remove(record.string() + ".checkpoint", ignored);
  if (child.exit_status != 0)
    throw InputError(fmt::format("{} cannot run the scene by which cost is measured", program.string()), read_text(log),
                     fmt::format("see {}", file.string()));
  return {child.cpu_seconds / static_cast<double>(read_record(record).counts.pair_contacts), child.peak_memory};
}

}  // namespace

CostComparison cost_of_rounds(std::vector<double> before, std::vector<double> after) {
  if (before.empty() || before.size() != after.size())
    throw InputError("costs that cannot be compared", "each side needs as many rounds as the other", "measure again");
  CostComparison cost;
  cost.ratio = median(after) / median(before);
  cost.least = cost.most = after[0] / before[0];
  for (std::size_t k = 1; k < before.size(); ++k) {
    cost.least = std::min(cost.least, after[k] / before[k]);
    cost.most = std::max(cost.most, after[k] / before[k]);
  }
  cost.before = std::move(before);
  cost.after = std::move(after);
  return cost;
}

CostComparison measure_cost(const std::filesystem::path& before, const std::filesystem::path& after,
                            const std::filesystem::path& folder, int rounds, const volatile std::sig_atomic_t* stop) {
  write_text_atomically(folder / "cost.toml", scene);
  std::vector<double> first, second;
  double memory_before = 0, memory_after = 0;
  for (int k = 0; k < rounds; ++k) {
    const OneRun a = run_once(before, folder, stop), b = run_once(after, folder, stop);
    first.push_back(a.seconds_per_contact);
    second.push_back(b.seconds_per_contact);
    memory_before = std::max(memory_before, a.memory);
    memory_after = std::max(memory_after, b.memory);
  }
  CostComparison cost = cost_of_rounds(std::move(first), std::move(second));
  cost.interleaved = true;
  cost.memory_before = memory_before;
  cost.memory_after = memory_after;
  return cost;
}

std::optional<CostComparison> cost_of_records(const EvidenceSet& before, const EvidenceSet& after) {
  double seconds_before = 0, seconds_after = 0, contacts_before = 0, contacts_after = 0;
  for (const auto& [key, a] : before.runs) {
    const auto other = after.runs.find(key);
    if (other == after.runs.end()) continue;
    seconds_before += a.cpu_seconds;
    contacts_before += static_cast<double>(a.contacts);
    seconds_after += other->second.cpu_seconds;
    contacts_after += static_cast<double>(other->second.contacts);
  }
  if (!(seconds_before > 0 && seconds_after > 0 && contacts_before > 0 && contacts_after > 0)) return std::nullopt;
  return cost_of_rounds({seconds_before / contacts_before}, {seconds_after / contacts_after});
}

}  // namespace gpf
