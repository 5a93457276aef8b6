#include "verify/explain.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "verify/command_text.hpp"
#include "verify/judge.hpp"

namespace gpf {
namespace {

/// `text` broken at spaces into lines of at most `width` characters, all but the first indented.
std::string wrapped(std::string_view text, std::size_t indent, std::size_t width = 100) {
  std::string result;
  std::size_t column = indent;
  while (!text.empty()) {
    const std::string_view word = text.substr(0, text.find(' '));
    text.remove_prefix(std::min(text.size(), word.size() + 1));
    if (column > indent && column + 1 + word.size() > width) {
      result += '\n' + std::string(indent, ' ');
      column = indent;
    }
    if (column > indent) {
      result += ' ';
      ++column;
    }
    result += word;
    column += word.size();
  }
  return result;
}

std::string line(std::string_view name, std::string_view text) {
  constexpr std::size_t indent = 14;
  return fmt::format("{:<{}}{}\n", name, indent, wrapped(text, indent));
}

std::string budget(const Claim& claim) {
  if (claim.tolerance.empty()) return line("tolerance", "none: the claim is about signs or orders, or exact");
  std::size_t width = 5;
  for (const ToleranceTerm& term : claim.tolerance) width = std::max(width, term.name.size());
  std::string text = line("tolerance", claim.tolerance_unit);
  for (const ToleranceTerm& term : claim.tolerance)
    text += fmt::format("  {:<{}}  {:>10.4g}  {}\n", term.name, width, term.value, wrapped(term.evidence, width + 16));
  return text + fmt::format("  {:<{}}  {:>10.4g}\n", "total", width, claim.tolerance_total());
}

std::string runs(const Claim& claim) {
  if (claim.scenes.empty()) return line("runs", "none: the claim is judged without a simulation of a scene");
  std::string text;
  for (const Tier tier : {Tier::quick, Tier::standard, Tier::full}) {
    if (!claim.judged_in(tier)) continue;
    text += line(fmt::format("{}", name_of(tier)),
                 fmt::format("{}; looks at {} replica(s)", fmt::join(claim.scenes_in(tier), ", "),
                             fmt::join(looks_up_to(claim.replicas_in(tier)), ", ")));
  }
  return text;
}

/// What `gpf validate` needs to be told when the claim is not judged in its usual tier.
std::string tier_option(const Claim& claim) {
  for (const Tier tier : {Tier::quick, Tier::standard, Tier::full})
    if (claim.judged_in(tier)) return tier == Tier::quick ? "" : fmt::format(" --tier {}", name_of(tier));
  return "";
}

std::string wanted(const ClaimCheck& check) {
  std::string text = check.value;
  if (check.label != check.value) text = fmt::format("{}: {}", check.label, text);
  if (check.reference) text += fmt::format(" = {:.6g} within the tolerance", *check.reference);
  if (check.least) text += fmt::format(" >= {:.6g}", *check.least);
  if (check.most) text += fmt::format("{} <= {:.6g}", check.least ? " and" : "", *check.most);
  return text;
}

}  // namespace

std::string explain(const Claim& claim, const std::filesystem::path& reference) {
  std::string text = fmt::format("{} - {}\n\n", claim.id, claim.title);
  text += line("source", fmt::format("chapter {}, {}", claim.chapter, claim.source));
  text += line("statement", claim.statement);
  text += line("method", claim.method);
  text += line("kind", name_of(claim.kind));
  text += line("estimator", claim.estimator);
  text += line("expected", claim.expected_because.empty()
                               ? std::string(name_of(claim.expected))
                               : fmt::format("{}: {}", name_of(claim.expected), claim.expected_because));
  text += budget(claim) + runs(claim);
  for (const auto& [name, value] : claim.parameters) text += line("parameter", fmt::format("{} = {:.6g}", name, value));
  for (const ClaimCheck& check : claim.checks) text += line("check", wanted(check));
  for (const std::string& fault : claim.catches) text += line("to catch", fault);
  return text +
         line("reproduce", fmt::format("gpf validate{}{} {}", tier_option(claim), folder_options(reference), claim.id));
}

}  // namespace gpf
