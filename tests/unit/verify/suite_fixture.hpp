// A small verification suite in a folder of its own: scenes, claims, runs without physics, and an estimator for them.
#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <fstream>
#include <string>

#include "gpf/io/atomic_file.hpp"
#include "unit/io/temporary_folder.hpp"
#include "unit/verify/claim_text.hpp"
#include "unit/verify/fake_run.hpp"
#include "verify/validate.hpp"
#include "verify/verdict_file.hpp"

namespace gpf::test {

/// One check per scene: the mean virial lies between the claim's parameters `lo` and `hi`. Fake runs of 64 blocks give
/// 10 with a deviation of 1/8 between replicas.
inline Evidence mean_virial(const Claim& claim, Tier, const SceneRecords& records) {
  Evidence evidence;
  for (const auto& [scene, replicas] : records) {
    Check check{"virial of " + scene, {}, {claim.parameter("lo"), claim.parameter("hi")}, false, 0, 10};
    for (const Record& record : replicas) {
      const TallyLayout layout(record.run);
      double sum = 0;
      for (std::size_t b = 0; b < record.blocks; ++b) sum += record.sums[b * layout.size() + layout.at(Tally::virial)];
      check.values.push_back(sum / static_cast<double>(record.blocks));
    }
    evidence.checks.push_back(std::move(check));
  }
  return evidence;
}

struct Suite {
  TemporaryFolder folder;
  ValidateOptions options;

  Suite() {
    std::filesystem::create_directories(folder / "claims");
    std::filesystem::create_directories(folder / "scenes");
    std::ofstream(folder / "scenes/alpha.toml") << periodic_scene;
    std::ofstream(folder / "scenes/beta.toml") << replaced(periodic_scene, "0.2", "0.3");
    options.reference = folder.path();
    options.store = folder / "records";
    options.jobs = 2;
    options.estimators = [](std::string_view) -> Estimator { return mean_virial; };
    options.run = [this](const SceneFile& file, const SimulationOptions&) {
      note();
      return fake_record(file);
    };
  }

  /// A claim about scene `scene`: virial within [lo, hi].
  void claim(const std::string& id, double lo, double hi, int replicas = 4, const std::string& expected = "reproduced",
             const std::string& scene = "alpha", const std::string& tier = "quick") const {
    std::ofstream(folder / ("claims/" + id + ".toml"))
        << "id = \"" << id << "\"\ntitle = \"t\"\nchapter = 2\nsource = \"s\"\nstatement = \"s\"\nmethod = \"m\"\n"
        << "kind = \"band\"\nexpected = \"" << expected << "\"\n"
        << (expected == "reproduced" ? "" : "expected_because = \"seen\"\n")
        << "estimator = \"mean_virial\"\ncatches = [\"a fault\"]\n"
        << "[scenes]\n"
        << tier << " = [\"" << scene << "\"]\n[replicas]\n"
        << tier << " = " << replicas << "\n"
        << "[parameters]\nlo = " << lo << "\nhi = " << hi << "\n";
  }

  /// Every run that is computed adds a byte to the log.
  void note() const {
    const int descriptor = ::open((folder / "log").c_str(), O_WRONLY | O_APPEND | O_CREAT, 0666);
    if (::write(descriptor, "x", 1) != 1) std::abort();
    ::close(descriptor);
  }
  [[nodiscard]] std::size_t runs() const {
    return std::filesystem::exists(folder / "log") ? read_text(folder / "log").size() : 0;
  }

  [[nodiscard]] Verdict verdict(const std::string& id) const { return read_verdict(options.store, options.tier, id); }
  [[nodiscard]] bool has_verdict(const std::string& id) const {
    return std::filesystem::exists(verdict_path(options.store, options.tier, id));
  }
};

}  // namespace gpf::test
