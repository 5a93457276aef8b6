#include "verify/trial/trial_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "gpf/base/error.hpp"
#include "gpf/io/atomic_file.hpp"
#include "gpf/io/plot.hpp"
#include "verify/plot_files.hpp"

namespace gpf {
namespace {

constexpr const char* marker = "<!-- Written by `gpf trial`: do not edit. -->\n";

std::string answer(const Trial& trial) {
  const std::vector<TrialResult> all = trial.results(), outside = trial.outside();
  const auto stated = std::count_if(all.begin(), all.end(), [](const TrialResult& r) { return !r.stated.empty(); });
  std::string text = fmt::format("**{} of {} results lie within what is stated.**",
                                 static_cast<std::size_t>(stated) - outside.size(), stated);
  for (const TrialResult& r : outside)
    text += fmt::format("\nOutside: {}, {}; stated: {}.", r.what, r.measured, r.stated);
  return fmt::format("{}\n", text);
}

constexpr const char* about_judge =
    "Claims whose truth is known, some thousands of each kind and truth, judged by the judge itself: again with 4, 8, "
    "16\n"
    "(32) replicas until decided. The replicas' deviation is half the tolerance unless said otherwise, a truth "
    "\"outside\"\n"
    "lies one tolerance outside. Stated (`verify/judge.hpp`): with a true value on an edge or outside a claim passes "
    "with\n"
    "probability .01 at most (a class .05), with all true values in their bands it fails with .01 at most for each "
    "edge.\n"
    "What is not stated is shown for what it is: power, and what becomes of the rates when replicas are not "
    "normal.\n\n";

constexpr const char* about_seeds =
    "Replica r of a scene has a seed that is a hash of the scene and r. Correlations of start velocities are those of "
    "all\n"
    "components of two runs; of measured numbers, those over the runs of the audits above.\n\n";

std::string picture(const char* title, const char* file) {
  return plot_markdown(title, fmt::format("trial/{}", file)) + "\n";
}

}  // namespace

std::vector<TrialResult> Trial::results() const {
  std::vector<TrialResult> all = judge.results();
  for (const auto* part : {&audit.results, &seeds}) all.insert(all.end(), part->begin(), part->end());
  return all;
}

std::vector<TrialResult> Trial::outside() const {
  std::vector<TrialResult> found = results();
  std::erase_if(found, [](const TrialResult& r) { return !r.outside; });
  return found;
}

void write_trial_page(const Trial& trial, const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder / "trial", error);
  if (error)
    throw StorageError(fmt::format("cannot make the folder '{}'", folder.string()), error.message(),
                       "choose another --output");
  std::string page = fmt::format("{}# The judge on trial\n\n{}\n", marker, answer(trial));
  page += fmt::format(
      "Errors are binomial standard errors. A result is outside when sampling alone shows one so far off in at most "
      "{:g} "
      "of\ncases; `gpf trial` then ends with exit status 1. Made by `gpf trial{}` in {:.0f} s of CPU time; all seeds "
      "are "
      "fixed.\n\n",
      trial_alpha, trial.quick ? " --quick" : "", trial.cpu_seconds);
  page += "## Claims of known truth\n\n";
  page += about_judge;
  page += picture("pass and fail against the truth", "power.svg");
  page += "A one-sided band has no centre: its truths are counted from one tolerance inside the edge.\n\n";
  page += table_of(trial.judge.kinds);
  page += fmt::format("\n{}", table_of(trial.judge.fieller));
  page += fmt::format(
      "\n## Audits of unchanged physics\n\n{} audits of {} numbers, {} replicas a side, every run its own: real runs "
      "of "
      "small scenes\n({}),\ncompared as `gpf audit` compares two versions. Nothing has moved, so what is said to have "
      "moved is a false alarm.\n\n",
      trial.audit.audits, trial.audit.numbers, replicas_a_side, [] {
        std::string names;
        for (const SceneFile& s : trial_scenes()) names += fmt::format("{}{}", names.empty() ? "" : "; ", s.name);
        return names;
      }());
  page += picture("distribution of p-values", "p-values.svg");
  page += table_of(trial.audit.results);
  page += "\n## Seeds\n\n";
  page += about_seeds;
  page += table_of(trial.seeds);
  write_plot(trial.judge.power, folder / "trial" / "power.svg");
  write_plot(trial.audit.distribution, folder / "trial" / "p-values.svg");
  write_text_atomically(folder / "trial.md", page);
}

}  // namespace gpf
