// Claim waves.pictures: what an eye called the pictures of real runs, against the classifier.
#include <fmt/format.h>

#include <cmath>
#include <map>

#include "gpf/base/error.hpp"
#include "gpf/io/snapshot.hpp"
#include "verify/estimators/density_structure.hpp"
#include "verify/estimators/estimators.hpp"

namespace gpf {
namespace {

/// The record of "<scene> #<replica>", replicas counted from 1.
const Record& run_named(const std::string& name, const SceneRecords& records) {
  const std::size_t mark = name.rfind(" #");
  const auto found = mark == std::string::npos ? records.end() : records.find(name.substr(0, mark));
  const std::string digits = mark == std::string::npos ? "" : name.substr(mark + 2);
  const bool number =
      !digits.empty() && digits.size() < 4 && digits.find_first_not_of("0123456789") == std::string::npos;
  if (found != records.end() && number) {
    const auto replica = static_cast<std::size_t>(std::stoi(digits));
    if (replica >= 1 && replica <= found->second.size()) return found->second[replica - 1];
  }
  throw InputError(fmt::format("no run '{}'", name),
                   "[structures] names runs of the claim's scenes as '<scene> #<replica>'", "correct the claim file");
}

}  // namespace

// [structures] holds what an eye called the last state of each run, from a picture without any label; the run's label
// rests on its density modes over all of its measured time. At least parameter `agreeing` of all runs agree. Shown: the
// first picture of each pair of labels.
Evidence estimate_picture_labels(const Claim& claim, Tier, const SceneRecords& records) {
  Evidence evidence;
  Check check{.label = "runs of which the eye and the density modes say the same",
              .values = {},
              .band = {claim.parameter("agreeing"), 1},
              .reference = NAN,
              .share = true};
  std::map<std::pair<std::string, std::string>, int> count;
  for (const auto& [name, eye] : claim.structures) {
    if (eye != name_of(std::nullopt) && structures_named(eye).size() != 1)
      throw InputError(fmt::format("'{}' of run '{}' is more than one structure", eye, name),
                       "an eye that cannot tell says 'between the classes'", "correct the claim file");
    const Record& record = run_named(name, records);
    const std::string label = name_of(classify(density_contrasts(SceneValues(name, {record})).front()));
    check.values.push_back(eye == label ? 1 : 0);
    if (++count[{eye, label}] == 1) {
      const std::string title = fmt::format("{}: {} to the eye, {} by its modes", name, eye, label);
      evidence.drawings.push_back({title, snapshot_svg(record.scene, record.final_state, title)});
    }
  }
  evidence.checks.push_back(std::move(check));
  for (const auto& [pair, runs] : count)
    evidence.notes.push_back(fmt::format("{} to the eye, {} by the modes: {} run(s).", pair.first, pair.second, runs));
  return evidence;
}

}  // namespace gpf
