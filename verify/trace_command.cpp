// gpf trace: a run epoch by epoch, and all contacts of one epoch.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>

#include "gpf/base/error.hpp"
#include "gpf/io/checkpoint.hpp"
#include "gpf/scene/scene_file.hpp"
#include "verify/audit/trace.hpp"
#include "verify/commands.hpp"

namespace gpf {

void add_trace_command(CLI::App& app, int& status) {
  struct Options {
    std::string scene, checkpoint;
    std::int64_t epochs = 16, epoch = 0;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("trace", "Print a run in such detail that two programs can be compared");
  command->add_option("scene", options->scene, "Scene file (TOML)")->required();
  CLI::Option* epochs = command->add_option("--epochs", options->epochs, "Number of epochs, one line for each")
                            ->check(CLI::NonNegativeNumber)
                            ->capture_default_str();
  command->add_option("--epoch", options->epoch, "Every contact of this epoch (from 1) instead")
      ->check(CLI::PositiveNumber)
      ->excludes(epochs);
  command->add_option("--checkpoint", options->checkpoint, "Go on from what gpf run left when it was stopped");
  command->footer(
      "Without --epoch a line for the start and one for each epoch: number, trace hash, contacts so far, hash of all\n"
      "positions and velocities. With it a line for each contact: time since the start of the epoch, disk, disk (or "
      "-1\n"
      "for the lower wall, -2 for the upper), v_x and v_y after it of the one and of the other, in the laboratory.\n"
      "Equal lines are equal bits.\n"
      "Examples:\n"
      "  gpf trace reference/scenes/quick-rough-nu30-e99.toml --epochs 100\n"
      "  gpf trace reference/scenes/quick-rough-nu30-e99.toml --epoch 7\n");
  command->callback([options, &status] {
    const SceneFile file = load_scene(options->scene);
    std::optional<EngineState> from;
    if (!options->checkpoint.empty()) from = read_checkpoint(file.scene, file.run, options->checkpoint).engine;
    if (options->epoch > 0)
      for (const TracedContact& contact : trace_contacts(file.scene, from, options->epoch))
        fmt::print("{}\n", text_of(contact));
    else
      trace_epochs(file.scene, from, options->epochs, [](const EpochMark& mark) { fmt::print("{}\n", text_of(mark)); });
    status = static_cast<int>(ExitStatus::success);
  });
}

}  // namespace gpf
