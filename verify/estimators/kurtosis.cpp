// vdf.gauss.*, vdf.rough.uy: the kurtosis of both velocity components, or of u_y alone, in every bin.
#include <fmt/format.h>

#include <span>

#include "verify/estimators/estimators.hpp"
#include "verify/estimators/velocity_moments.hpp"

namespace gpf {
namespace {

constexpr double gaussian = 3;
constexpr VelocityMoment both[] = {kurtosis_x, kurtosis_y, kurtosis_x_long_time};

/// A check for each moment, flow and pair of bins. The plot shows the first moment, or two: u_x and u_y.
Evidence kurtosis_evidence(const Claim& claim, const SceneRecords& records, std::span<const VelocityMoment> moments) {
  const Interval band = band_about(gaussian, claim.tolerance_total());
  Evidence evidence;
  evidence.plot = {.title = "Kurtosis of the fluctuation velocities",
                   .xlabel = moments.size() > 1 ? "y/W (left half: u_x; right half, mirrored: u_y)" : "y/W",
                   .ylabel = moments.size() > 1 ? "kurtosis" : std::string(moments.front().name),
                   .xrange = {{0, 1}},
                   .series = {band_across(band, "band about a Gaussian")}};
  const std::vector<SceneValues> scenes = by_area_fraction(records);
  for (const SceneValues& scene : scenes) {
    const std::string flow = fmt::format("nu {:.3g}", scene.scene().area_fraction());
    Series points{.label = flow};
    for (const VelocityMoment& which : moments)
      for (int bin = 0; bin < scene.half(); ++bin) {
        Check check = moment_check(scene, which, bin, band);
        if (&which == &moments[0]) add_point(points, scene.centre(bin), check.values);
        if (moments.size() > 1 && &which == &moments[1]) add_point(points, 1 - scene.centre(bin), check.values);
        evidence.checks.push_back(std::move(check));
      }
    for (const VelocityMoment& which : moments) {
      const auto mean = [&](int bin) { return over_replicas(moment(scene, which, bin)).mean; };
      evidence.notes.push_back(fmt::format("{}: {} {:.3f} next to the wall and {:.3f} at the centre.", flow, which.name,
                                           mean(0), mean(scene.half() - 1)));
    }
    evidence.plot.series.push_back(std::move(points));
  }
  for (std::string& note : notes_on_definitions(scenes)) evidence.notes.push_back(std::move(note));
  return evidence;
}

}  // namespace

// The kurtosis of u_x about either mean and of u_y is 3 within the tolerance (figs. 3.2, 3.3). No units.
Evidence estimate_kurtosis(const Claim& claim, Tier, const SceneRecords& records) {
  return kurtosis_evidence(claim, records, both);
}

// The same of u_y alone (fig. 3.7b).
Evidence estimate_kurtosis_y(const Claim& claim, Tier, const SceneRecords& records) {
  return kurtosis_evidence(claim, records, std::span(&kurtosis_y, 1));
}

}  // namespace gpf
