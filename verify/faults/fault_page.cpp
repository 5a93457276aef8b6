#include "verify/faults/fault_page.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "gpf/io/atomic_file.hpp"
#include "gpf/io/markdown.hpp"
#include "verify/report_markdown.hpp"

namespace gpf {
namespace {

/// The claims that catch it, those that do so by their verdict first.
std::vector<std::string> catchers(const FaultTrial& trial) {
  std::vector<std::string> ids;
  for (const Caught how : {Caught::yes, Caught::health})
    for (const auto& [claim, answer] : trial.claims)
      if (answer.caught == how) ids.push_back(how == Caught::yes ? claim : fmt::format("{} (health)", claim));
  return ids;
}

std::string some_of(const std::vector<std::string>& ids) {
  constexpr std::size_t most = 4;
  if (ids.size() <= most) return fmt::format("{}", fmt::join(ids, ", "));
  return fmt::format("{} and {} more", fmt::join(ids.begin(), ids.begin() + most, ", "), ids.size() - most);
}

const char* colour_of(Caught caught) {
  return caught == Caught::yes         ? "#b2182b"
         : caught == Caught::health    ? "#e08214"
         : caught == Caught::undecided ? "#fee0b6"
                                       : "#eeeeee";
}

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else
      result += c;
  }
  return result;
}

std::string table_of_faults(const FaultMatrix& matrix) {
  std::vector<std::vector<std::string>> rows;
  for (const FaultTrial& trial : matrix.trials) {
    const Fault& fault = fault_named(trial.fault);
    const auto ids = catchers(trial);
    rows.push_back({trial.fault, std::string(fault.what), fmt::format("{:.3g} ({})", trial.dose, fault.dose_means),
                    std::string(fault.shows_in), ids.empty() ? "-" : fmt::format("{}: {}", ids.size(), some_of(ids))});
  }
  return markdown_table({"fault", "what is wrong", "dose", "shows in", "caught by"}, rows);
}

std::string table_of_claims(const FaultMatrix& matrix) {
  std::vector<std::vector<std::string>> rows;
  for (const Claim& claim : matrix.claims) {
    std::vector<std::string> caught;
    for (const FaultTrial& trial : matrix.trials) {
      const auto answer = trial.claims.find(claim.id);
      if (answer != trial.claims.end() && is_caught(answer->second.caught)) caught.push_back(trial.fault);
    }
    rows.push_back({claim.id, std::to_string(caught.size()), fmt::format("{}", fmt::join(caught, ", "))});
  }
  return markdown_table({"claim", "faults", "caught"}, rows);
}

std::string table_of_doses(const FaultMatrix& matrix) {
  std::vector<std::vector<std::string>> rows;
  for (const SmallestDose& s : matrix.smallest) {
    const Fault& fault = fault_named(s.fault);
    rows.push_back({s.fault, s.claim, std::string(fault.dose_means), fmt::format("{:.3g}", s.caught),
                    s.missed > 0 ? fmt::format("{:.3g}", s.missed) : "none was missed"});
  }
  return markdown_table({"fault", "claim", "dose counts", "caught from", "missed at"}, rows);
}

}  // namespace

std::vector<std::string> FaultMatrix::missed() const {
  std::vector<std::string> names;
  for (const FaultTrial& trial : trials)
    if (catchers(trial).empty()) names.push_back(trial.fault);
  return names;
}

std::string matrix_svg(const FaultMatrix& matrix) {
  constexpr int cell = 16, left = 170, top = 290;
  const int width = left + cell * static_cast<int>(matrix.trials.size()) + 20;
  const int height = top + cell * static_cast<int>(matrix.claims.size()) + 40;
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
      "font-family=\"sans-serif\" font-size=\"11\">\n<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n",
      width, height);
  for (std::size_t f = 0; f < matrix.trials.size(); ++f) {
    const int x = left + cell * static_cast<int>(f);
    svg += fmt::format("<text transform=\"translate({},{}) rotate(-90)\">{}</text>\n", x + 12, top - 6,
                       escaped(matrix.trials[f].fault));
    for (std::size_t c = 0; c < matrix.claims.size(); ++c) {
      const int y = top + cell * static_cast<int>(c);
      if (f == 0)
        svg += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"end\">{}</text>\n", left - 6, y + 12,
                           escaped(matrix.claims[c].id));
      const auto answer = matrix.trials[f].claims.find(matrix.claims[c].id);
      const Caught caught = answer == matrix.trials[f].claims.end() ? Caught::no : answer->second.caught;
      const char* colour = colour_of(caught);
      svg += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\"/>\n", x + 1, y + 1, cell - 2,
                         cell - 2, colour);
    }
  }
  int x = left;
  for (const auto& [caught, words] :
       {std::pair{Caught::yes, "caught by the verdict"}, std::pair{Caught::health, "by a health check"},
        std::pair{Caught::undecided, "inconclusive"}, std::pair{Caught::no, "not caught"}}) {
    svg += fmt::format(
        "<rect x=\"{}\" y=\"{}\" width=\"12\" height=\"12\" fill=\"{}\"/>\n"
        "<text x=\"{}\" y=\"{}\">{}</text>\n",
        x, height - 26, colour_of(caught), x + 18, height - 16, words);
    x += 150;
  }
  return svg + "</svg>\n";
}

std::string matrix_csv(const FaultMatrix& matrix) {
  std::string text = "claim,fault,tier,dose,caught\n";
  for (const FaultTrial& trial : matrix.trials)
    for (const auto& [claim, answer] : trial.claims)
      text += fmt::format("{},\"{}\",{},{:.6g},{}\n", claim, trial.fault, name_of(trial.tier), trial.dose,
                          name_of(answer.caught));
  return text;
}

void write_fault_page(const FaultMatrix& matrix, const std::filesystem::path& folder) {
  const auto missed = matrix.missed();
  std::string text = fmt::format(
      "<!-- Written by `gpf faults`: do not edit. -->\n"
      "# Does the suite catch faults?\n\n"
      "{} faults are put into the physics, one at a time, where the rules of the engine and its observer stand, and "
      "the\n"
      "claims of tier quick are judged as ever. {} of the faults are caught by at least one of {} claims{}. A fault\n"
      "is caught when a verdict is decided against its expectation, when a run or an estimator stops with an error, or "
      "when\n"
      "a health check of the claim's runs fails as it would by chance in less than {:g} of cases.\n"
      "With no fault every claim is as expected. Tier standard judges these claims, too, with no fewer runs. All "
      "answers:\n[faults.csv](faults.csv).\n\n"
      "![Matrix of claims and faults](faults.svg)\n\n## Faults\n\n{}\n",
      matrix.trials.size(), matrix.trials.size() - missed.size(), matrix.claims.size(),
      missed.empty() ? ""
                     : fmt::format("; none catches: {}", markdown_text(fmt::format("{}", fmt::join(missed, ", ")))),
      alarm_chance, table_of_faults(matrix));
  if (!matrix.smallest.empty())
    text += fmt::format(
        "## Smallest doses\n\nBy bisection to a factor 1.2, with the seeds of tier quick: the claim catches the fault "
        "from\n"
        "the one dose on and misses it at the other.\n\n{}\n",
        table_of_doses(matrix));
  text += fmt::format(
      "## Claims\n\nIdentities, equations of state and the two codes are there to find faults. The others judge "
      "statements of the\nsource, with bands as wide as its figures: a fault of a few per cent moves no verdict of "
      "theirs, "
      "and what catches\nit there is the health of their runs.\n\n{}\nThese claims of tier quick read no records - "
      "they run the engine, its oracle or the classifier "
      "themselves,\nwhere no fault is put - and are not tried here: {}.\n",
      table_of_claims(matrix), fmt::join(matrix.others, ", "));
  std::error_code ignored;
  std::filesystem::create_directories(folder, ignored);
  write_text_atomically(folder / "faults.svg", matrix_svg(matrix));
  write_text_atomically(folder / "faults.csv", matrix_csv(matrix));
  write_text_atomically(folder / "faults.md", text);
}

}  // namespace gpf
