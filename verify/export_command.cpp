// gpf export: a record in the files of other programs.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "gpf/base/error.hpp"
#include "gpf/io/atomic_file.hpp"
#include "verify/commands.hpp"
#include "verify/export/csv.hpp"
#include "verify/export/h5md.hpp"
#include "verify/export/xyz.hpp"
#include "verify/frame_command.hpp"
#include "verify/stop_signals.hpp"

namespace gpf {
namespace {

struct Options {
  std::filesystem::path input, output;
  std::string format = "h5md", author;
  ViewStart start;
  FramePlan frames{.count = 0};
  bool force = false;
};

std::filesystem::path default_output(const Options& options) {
  const std::string end = options.format == "h5md-2d" ? "-2d.h5md" : "." + options.format;
  std::filesystem::path output = options.input;
  return output.replace_extension() += end;
}

/// `output` with a word before its end.
std::filesystem::path beside(const std::filesystem::path& output, const std::string& word) {
  std::filesystem::path path = output;
  return (path.replace_extension() += "-" + word) += output.extension();
}

void write_tables(const Options& options, const ViewSource& source) {
  if (options.frames.count > 0)
    throw InputError("--frames makes states, and a table holds none", "csv is for what the record measured",
                     "leave --frames out, or choose --format h5md or xyz");
  if (!source.record)
    throw InputError(fmt::format("'{}' is a scene file", options.input.string()), "nothing is measured yet",
                     "name the record that `gpf run` wrote of it");
  const CsvTables tables = csv_tables(*source.record);
  std::vector<std::pair<std::filesystem::path, const std::string*>> files{
      {options.output, &tables.profiles}, {beside(options.output, "scalars"), &tables.scalars}};
  if (!tables.modes.empty()) files.emplace_back(beside(options.output, "modes"), &tables.modes);
  for (const auto& [path, text] : files) require_free(path, options.input, options.force);
  for (const auto& [path, text] : files) {
    write_text_atomically(path, *text);
    fmt::print("{}\n", path.string());
  }
}

void write_states(Options& options, const ViewSource& source) {
  require_free(options.output, options.input, options.force);
  if (options.frames.interval == 0) options.frames.interval = default_interval(source.start.state);
  if (options.frames.count > 0) warn_of_other_physics(source);
  const ExportedStates states(source, options.frames);
  {
    FrameProgress progress(static_cast<int>(states.count()));
    if (options.format == "xyz")
      write_xyz(states, options.output, std::ref(progress));
    else
      write_h5md(states, {options.format == "h5md" ? 3 : 2, options.author.empty() ? name_of_user() : options.author},
                 options.output, std::ref(progress));
  }
  fmt::print("{}\n", options.output.string());
}

int run_export(Options options) {
  if (options.output.empty()) options.output = default_output(options);
  const ViewSource source = load_view_source(options.input, options.start);
  if (options.format == "csv")
    write_tables(options, source);
  else
    write_states(options, source);
  return static_cast<int>(ExitStatus::success);
}

}  // namespace

void add_export_command(CLI::App& app, int& status) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("export", "Write states or profiles for MDAnalysis, OVITO, ASE, pandas, ...");
  command->add_option("input", options->input, "Record (HDF5), or scene file (*.toml)")->required();
  command->add_option("--format", options->format, "h5md, h5md-2d, xyz or csv")
      ->check(CLI::IsMember({"h5md", "h5md-2d", "xyz", "csv"}))
      ->capture_default_str();
  command->add_option("-o,--output", options->output,
                      "File to write (default: INPUT with the end .h5md, -2d.h5md, .xyz or .csv)");
  CLI::Option* frames = add_frame_options(*command, options->frames, options->start);
  for (const char* name : {"--interval", "--from-start", "--from-snapshot"}) command->get_option(name)->needs(frames);
  command->add_option("--author", options->author, "Name for H5MD's /h5md/author (default: yours)");
  command->add_flag("--force", options->force, "Replace files that exist");
  command->footer(
      "h5md     H5MD 1.1 in three dimensions, z = 0: h5py; MDAnalysis.Universe.empty(disks, trajectory=True)\n"
      "         .load_new(\"x.h5md\", convert_units=False)\n"
      "h5md-2d  H5MD 1.1 in the two dimensions of the flow: h5py, pyh5md\n"
      "xyz      extended XYZ: OVITO, ase.io.read(\"x.xyz\", \":\")\n"
      "csv      OUTPUT: profiles, a row per bin; OUTPUT with -scalars, -modes before its end: numbers of the whole\n"
      "         flow, and density modes if they were measured. An error stands beside each number.\n"
      "The states are those that the record keeps: its snapshots and its last one. With --frames they are simulated\n"
      "anew, from the last one unless --from-start or --from-snapshot is given. Lengths are in W, masses in m.\n"
      "Examples:\n"
      "  gpf export nu30.h5\n"
      "  gpf export nu30.h5 --format xyz --frames 500 --from-snapshot 1\n"
      "  gpf export nu30.h5 --format csv -o profiles.csv\n"
      "  gpf export scene.toml --frames 1000 --interval 0.01 -o start.h5md\n"
      "Stopped by a signal it leaves nothing and exits with 75.\n");
  command->callback([options, &status] {
    options->frames.stop = stop_on_signals();
    status = run_export(*options);
  });
}

}  // namespace gpf
