// gpf: granular Poiseuille flow, simulated event by event and judged against reference data.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <new>
#include <system_error>

#include "gpf/base/error.hpp"
#include "verify/commands.hpp"
#include "verify/out_of_memory.hpp"
#include "verify/version_text.hpp"

namespace {

int report(const gpf::Error& error) {
  std::fprintf(stderr, "gpf: %s\n", error.what());
  return static_cast<int>(error.status());
}

}  // namespace

int main(int argc, char** argv) {
  int status = 0;
  CLI::App app{
      "gpf simulates granular Poiseuille flow - inelastic hard disks driven by gravity through a channel - event by "
      "event,\n"
      "and checks every claim about it against reference data.\n"};
  bool json = false;  // read before --version, which ends the program
  CLI::Option* as_json = app.add_flag("--json", json, "With --version: as one JSON object");
  as_json->needs(app.set_version_flag(
      "--version", [&json] { return json ? gpf::version_json() : gpf::version_text(); }, "Say how gpf was built"));
  app.require_subcommand(1);
  app.footer(
      "Exit status: 0 success or all green; 1 a claim is red; 2 bad input; 3 the engine refused to go on (overlap, "
      "inelastic\n"
      "collapse); 4 a file could not be read or written; 75 stopped by a signal, --resume goes on; 77 a claim needs "
      "more data.\n\n"
      "Examples:\n"
      "  gpf run reference/scenes/channel-smooth-nu30.toml -o nu30.h5 --json\n"
      "  gpf validate --tier quick\n"
      "  gpf explain eos.global\n");
  gpf::add_run_command(app, status);
  gpf::add_validate_command(app, status);
  gpf::add_explain_command(app, status);
  gpf::add_report_command(app, status);
  gpf::add_campaign_command(app, status);
  gpf::add_flow_command(app, status);
  gpf::add_chart_command(app, status);
  gpf::add_advise_command(app, status);
  gpf::add_faults_command(app, status);
  gpf::add_trial_command(app, status);
  gpf::add_trace_command(app, status);
  gpf::add_audit_command(app, status);
  gpf::add_view_command(app, status);
  gpf::add_export_command(app, status);
  gpf::add_pages_command(app, status);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : static_cast<int>(gpf::ExitStatus::bad_input);
  } catch (const gpf::Error& error) {
    return report(error);
  } catch (const std::bad_alloc&) {
    return report(gpf::out_of_memory());
  } catch (const std::filesystem::filesystem_error& error) {
    return report(gpf::StorageError("a file or folder cannot be used", error.what(),
                                    "check its place, the room there and your rights"));
  } catch (const std::system_error& error) {
    if (error.code() == std::errc::resource_unavailable_try_again) return report(gpf::out_of_memory());  // a thread
    std::fprintf(stderr, "gpf: cannot write the output (%s): make room, or write it elsewhere\n", error.what());
    return static_cast<int>(gpf::ExitStatus::storage);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "gpf: %s (this should not happen): report it with the command that led here\n", error.what());
    return static_cast<int>(gpf::ExitStatus::physics);
  }
  // What a pipe or a full disk did not take is lost: the exit status must not say otherwise.
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    std::fprintf(stderr, "gpf: cannot write the output: make room, or write it elsewhere\n");
    return static_cast<int>(gpf::ExitStatus::storage);
  }
  return status;
}
