// gpf chart: cost and error of every method, measured.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <thread>

#include "gpf/base/error.hpp"
#include "gpf/io/atomic_file.hpp"
#include "verify/commands.hpp"
#include "verify/methods/chart_pages.hpp"
#include "verify/stop_signals.hpp"

namespace gpf {

void add_chart_command(CLI::App& app, int& status) {
  struct Options {
    std::filesystem::path reference = "reference", store = "records", output = "reports";
    int jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    bool redraw = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("chart", "Run the methods of reference/methods.toml and chart their cost against their error");
  command->add_option("-j,--jobs", options->jobs, "Runs at a time (default: one for each processor)")
      ->check(CLI::PositiveNumber);
  command->add_option("--store", options->store, "Folder of records; runs found there are not done again")
      ->capture_default_str();
  command->add_option("--reference", options->reference, "Folder that holds methods.toml and scenes/")
      ->capture_default_str();
  command->add_option("-o,--output", options->output, "Folder for the page")->capture_default_str();
  command->add_flag("--redraw", options->redraw, "Run nothing: draw the page anew from methods.csv");
  command->footer("Examples:\n  gpf chart\n  gpf chart -j 1 --output chart\n  gpf chart --redraw\n");
  command->callback([options, &status] {
    const std::filesystem::path table = options->reference / "methods.csv";
    const ChartPlan plan = load_chart_plan(options->reference / "methods.toml");
    if (!options->redraw) {
      const volatile std::sig_atomic_t* stop = stop_on_signals();
      for (const std::filesystem::path& folder : {options->reference, options->output}) {
        std::error_code ignored;
        std::filesystem::create_directories(folder, ignored);
        write_text_atomically(folder / ".gpf-chart", "");  // before an hour of work: can it be written to?
        std::filesystem::remove(folder / ".gpf-chart", ignored);
      }
      const RecordStore records(options->store, Trust::same_version,
                                [](const std::string& line) { fmt::print(stderr, "gpf: {}\n", line); });
      const MethodStore store(options->store / "methods");
      const auto points = chart_points(plan, options->reference, records, store, options->jobs, stop);
      if (points.empty()) {
        status = static_cast<int>(ExitStatus::interrupted);
        return;
      }
      write_text_atomically(table, csv_of(points));
    }
    write_chart_page(plan, points_in(read_text(table), table.string()), options->output);
    fmt::print("{}\n", (options->output / "methods.md").string());
    status = static_cast<int>(ExitStatus::success);
  });
}

}  // namespace gpf
