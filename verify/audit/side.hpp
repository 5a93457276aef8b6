// One of the two versions that an audit compares: where its records are, and how they are made.
#pragma once

#include <csignal>
#include <filesystem>
#include <string>
#include <vector>

namespace gpf {

struct SideOptions {
  std::filesystem::path work = "build/audit";  ///< trees, programs and stores of revisions
  int replicas = 8;
  int jobs = 1;
  std::vector<std::string> claims;  ///< ids; empty: all
  bool rebuild = false;             ///< do everything again
  const volatile std::sig_atomic_t* stop = nullptr;
};

struct Side {
  std::string name;                ///< as given: a folder or a revision
  std::string commit;              ///< of a revision that is not the working tree
  std::filesystem::path tree;      ///< sources; empty for a store
  std::filesystem::path program;   ///< its gpf; empty for a store
  std::filesystem::path store;     ///< records and verdicts
  std::vector<std::string> notes;  ///< what went wrong on the way, for the page

  [[nodiscard]] bool has_program() const { return !program.empty(); }
};

/// Throws Error with ExitStatus::interrupted after a signal.
void stop_if_asked(const SideOptions& options);

/// What `name` stands for: a folder that is a store, the working tree (.), or a revision of the repository in the
/// current folder. Throws InputError when it is none of these.
Side side_named(const std::string& name, const SideOptions& options);

/// Builds the program of a revision, in <work>/<commit> (the working tree: in <work>/working-tree, where it stands),
/// with ccache when there is one. Nothing for a store. Throws InputError with the end of the log when it does not
/// build.
void build(const Side& side, const SideOptions& options);

/// Runs and judges with the revision's own program what its store lacks. Nothing for a store. A run that the engine
/// refuses is a note of the side. Throws InputError when the program fails otherwise.
void fill_store(Side& side, const SideOptions& options);

}  // namespace gpf
