// kn.paths: the distribution of the displacement of a disk between successive contacts.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "gpf/measure/distributions.hpp"
#include "verify/estimators/estimators.hpp"
#include "verify/estimators/scans.hpp"

namespace gpf {
namespace {

/// The share of paths longer than s, at the edges of the record's cells, with s in units of the mean path.
struct Survival {
  std::vector<double> s, share;

  Survival(const Record& record, const char* paths) {
    const std::vector<double>& counts = array_named(record.arrays, paths).values;
    const double step =
        std::log(Distributions::path_most / Distributions::path_least) / static_cast<double>(counts.size());
    double paths_seen = 0, sum = 0;
    for (std::size_t k = 0; k <= counts.size(); ++k)
      s.push_back(Distributions::path_least * std::exp(step * static_cast<double>(k)));
    for (std::size_t k = 0; k < counts.size(); ++k) {
      paths_seen += counts[k];
      sum += counts[k] * std::sqrt(s[k] * s[k + 1]);
    }
    double longer = paths_seen;
    for (std::size_t k = 0; k <= counts.size(); ++k) {
      share.push_back(longer / paths_seen);
      if (k < counts.size()) longer -= counts[k];
      s[k] *= paths_seen / sum;
    }
  }

  /// -d ln(share)/ds from `from` to `to` mean paths, at the edges nearest to them.
  [[nodiscard]] double decay_rate(double from, double to) const {
    const std::size_t a = edge_at(from), b = edge_at(to);
    return std::log(share[a] / share[b]) / (s[b] - s[a]);
  }

 private:
  [[nodiscard]] std::size_t edge_at(double mean_paths) const {
    const auto above = std::lower_bound(s.begin() + 1, s.end() - 1, mean_paths);
    const auto k = static_cast<std::size_t>(above - s.begin());
    return mean_paths / s[k - 1] < s[k] / mean_paths ? k - 1 : k;
  }
};

/// ln of the rate of decay from 3 to 6 mean paths over that from 1 to 3: 0 for an exponential.
constexpr double near = 1, middle = 3, far = 6;
std::vector<double> change_of_rate(const SceneValues& scene, const char* paths) {
  return per_replica(scene.replicas(), [&](std::size_t r) {
    const Survival survival(scene.records()[r], paths);
    return std::log(survival.decay_rate(middle, far) / survival.decay_rate(near, middle));
  });
}

}  // namespace

// Claim kn.paths (fig. 4.14 b), at the area fraction `judged_at`: on a logarithmic scale the rate's change is nearer to
// an exponential's, none, than to a power law's on the one side and a Gaussian's on the other.
Evidence estimate_kn_paths(const Claim& claim, Tier, const SceneRecords& records) {
  // A share s^-a has ln(to/from) a/(to - from), whatever a; exp(-s^2) has to + from.
  const double power_law =
                   std::log(std::log(far / middle) / (far - middle) / (std::log(middle / near) / (middle - near))),
               gaussian = std::log((far + middle) / (middle + near));
  Evidence evidence;
  evidence.plot = {.title = "Displacement between contacts, rough walls",
                   .xlabel = "s/(mean displacement)",
                   .ylabel = "share of longer ones",
                   .logy = true,
                   .xrange = {{0, 8}},
                   .yrange = {{1e-4, 1}}};
  for (const auto& [nu, scan] : scans_by(area_fraction, normal_restitution, records, any_scene)) {
    const bool judged = std::abs(nu - claim.parameter("judged_at")) < 1e-6;
    std::string seen;
    for (const SceneValues& scene : scan) {
      const std::vector<double> change = change_of_rate(scene, "free_path/lab");
      const double restitution = normal_restitution(scene.scene());
      seen += fmt::format(" e_n {:.2g}: {:.2f} ({:.2f}),", restitution, std::exp(over_replicas(change).mean),
                          std::exp(over_replicas(change_of_rate(scene, "free_path/peculiar")).mean));
      if (!judged) continue;
      evidence.checks.push_back(
          {.label = fmt::format("nu {:.2g}, e_n {:.2g}: ln of the rate of decay beyond {:.0f} mean "
                                "displacements over that before",
                                nu, restitution, middle),
           .values = change,
           .band = {power_law / 2, gaussian / 2},
           .x = restitution,
           .reference = 0});
      const Survival survival(scene.records().front(), "free_path/lab");
      Series curve{.label = fmt::format("e_n {:.2g}", restitution), .style = SeriesStyle::line};
      for (std::size_t k = 0; k < survival.s.size() && survival.s[k] < 8; ++k) {
        if (survival.s[k] < 0.02) continue;
        curve.x.push_back(survival.s[k]);
        curve.y.push_back(survival.share[k]);
      }
      evidence.plot.series.push_back(std::move(curve));
    }
    seen.back() = '.';
    evidence.notes.push_back(
        fmt::format("nu {:.2g}: rate from {:.0f} to {:.0f} mean displacements over that from {:.0f} to {:.0f} (that of "
                    "peculiar paths):{}",
                    nu, middle, far, near, middle, seen));
  }
  evidence.notes.push_back(fmt::format("An exponential has the ratio 1, a power law {:.2f}, a Gaussian {:.2f}.",
                                       std::exp(power_law), std::exp(gaussian)));
  return evidence;
}

}  // namespace gpf
