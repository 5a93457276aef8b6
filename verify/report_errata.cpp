#include "verify/report_errata.hpp"

#include <fmt/format.h>

#include "verify/report_claim_page.hpp"
#include "verify/report_markdown.hpp"

namespace gpf {
namespace {

std::string claim_links(const std::vector<std::string>& claims, const std::set<std::string>& pages) {
  std::string text;
  for (const std::string& id : claims) {
    const std::string name = markdown_text(id);
    text += (text.empty() ? "" : ", ") + (pages.contains(id) ? fmt::format("[{}](claims/{}.md)", name, id) : name);
  }
  return text;
}

}  // namespace

std::string errata_page(const std::vector<Erratum>& errata, const std::set<std::string>& pages) {
  std::string text = page_marker;
  text += fmt::format(
      "# Errata of the source\n\n{} place(s) where the source cannot mean what it prints, in its order; from "
      "`reference/errata.toml`.\nWhat it means but the simulation contradicts is not listed here: those are refuted "
      "claims, on the [front page](README.md).\n",
      errata.size());
  for (const Erratum& e : errata) {
    text += fmt::format("\n## {}\n\n{}\n\n- printed: {}\n- correct: {}\n- evidence: {}\n", markdown_text(e.id),
                        markdown_text(e.place), markdown_text(e.printed), markdown_text(e.correct),
                        markdown_text(e.evidence));
    if (!e.claims.empty()) text += fmt::format("- tested by: {}\n", claim_links(e.claims, pages));
  }
  return text;
}

}  // namespace gpf
