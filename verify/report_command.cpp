// gpf report: pages and pictures from the verdicts of a tier.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "gpf/base/error.hpp"
#include "verify/commands.hpp"
#include "verify/reference_option.hpp"
#include "verify/report.hpp"
#include "verify/site.hpp"

namespace gpf {

void add_report_command(CLI::App& app, int& status) {
  auto options = std::make_shared<ReportOptions>();
  auto tier = std::make_shared<std::string>("quick"), site = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("report", "Write the report of a tier from its verdicts; runs no physics");
  command->add_option("claims", options->claims, "Claims to report on; none: all of the tier")->type_name("CLAIM");
  command->add_option("--tier", *tier, "quick, standard or full")
      ->check(CLI::IsMember({"quick", "standard", "full"}))
      ->capture_default_str();
  command->add_option("--store", options->store, "Folder of records and verdicts")->capture_default_str();
  add_reference_option(*command, options->reference);
  CLI::Option* output =
      command->add_option("--output", options->output,
                          "Folder for the report (default: quick-report, reports for tier standard, reports/full)");
  command->add_flag("--release", options->release, "Keep what this version found in history/ of the report");
  CLI::Option* html = command->add_option(
      "--html", *site, "Write no report but turn the one in --output, and the guide, into HTML pages in this folder");
  html->excludes("--release")->excludes("claims")->excludes("--tier")->excludes("--store");
  command->footer(
      "The last line on standard output is the path of the front page. The exit status is 0 whatever the verdicts "
      "say.\n"
      "Examples:\n  gpf report        # of tier quick, into quick-report\n  gpf report --tier standard --release\n  "
      "gpf report --tier full --output reports/full "
      "phase.moderate waves.pictures\n"
      "  gpf report --html site\n");
  command->callback([options, tier, site, output, html, &status] {
    status = static_cast<int>(ExitStatus::success);
    if (output->count() == 0)  // what is released is not replaced by a report of a lower tier
      options->output = html->count() > 0 || *tier == "standard" ? "reports"
                        : *tier == "full"                        ? "reports/full"
                                                                 : "quick-report";
    if (html->count() > 0) {
      fmt::print("{}\n", write_site({options->output, options->reference, *site}).string());
      return;
    }
    if (!options->claims.empty() && options->release)
      throw InputError("a release of chosen claims", "its history would lack the others", "name no claims");
    if (!options->claims.empty() && output->count() == 0)
      throw InputError("a report on chosen claims without --output",
                       fmt::format("in '{}' it would replace the report of a whole tier", options->output.string()),
                       "name a folder: --output reports/full");
    options->tier = tier_named(*tier);
    fmt::print("{}\n", write_report(*options).string());
  });
}

}  // namespace gpf
