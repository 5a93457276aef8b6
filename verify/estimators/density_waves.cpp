// Chapter 5: waves.classifier on made configurations, and the waves.* claims, which say what structure a scene has.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "gpf/base/error.hpp"
#include "gpf/io/markdown.hpp"
#include "gpf/io/snapshot.hpp"
#include "gpf/measure/density_spectrum.hpp"
#include "verify/estimators/density_structure.hpp"
#include "verify/estimators/estimators.hpp"
#include "verify/estimators/made_structures.hpp"
#include "verify/estimators/wave_motion.hpp"

namespace gpf {
namespace {

constexpr int all_classes = static_cast<int>(structures.size());

/// How often each label is given to runs that are drawn from `structure`.
std::map<std::string, int> labels_of(Structure structure, const MadeChannel& channel, int modes, int snapshots,
                                     int runs) {
  std::map<std::string, int> count;
  for (int run = 0; run < runs; ++run)
    ++count[name_of(classify(made_contrast(structure, channel, modes, snapshots, static_cast<std::uint64_t>(run))))];
  return count;
}

/// A time in the words of a claim: "t from 3 to 5".
struct Window {
  double from = 0, to = INFINITY;

  [[nodiscard]] std::string text() const {
    return std::isinf(to) ? fmt::format("t from {:.3g} on", from) : fmt::format("t {:.3g} to {:.3g}", from, to);
  }
};

/// A walled scene's rougher wall is the one with the smaller beta_w: +1 when it is the upper one, 0 when they are
/// alike.
int rougher_side(const Scene& scene) {
  const auto& beta = scene.wall_tangential_restitution;
  return beta[upper] < beta[lower] ? 1 : beta[upper] > beta[lower] ? -1 : 0;
}

/// Where the walls differ: the shift of the band toward the rougher wall (`toward` 1) or the smoother one (-1), and
/// that the wall to which it should go is the colder one.
void check_shift(const SceneValues& scene, double toward, Evidence& evidence) {
  const int rougher = rougher_side(scene.scene());
  if (rougher == 0 || toward == 0) return;
  const double side = rougher * toward;
  const char* wall = toward > 0 ? "rougher" : "smoother";
  const auto signed_by = [&](std::vector<double> values) {
    for (double& value : values) value *= side;
    return values;
  };
  evidence.checks.push_back({.label = fmt::format("{}: shift of the band toward the {} wall, in W", scene.name(), wall),
                             .values = signed_by(scene.of("band_shift")),
                             .band = {0, INFINITY}});
  evidence.checks.push_back(
      {.label = fmt::format("{}: T at the other wall less that at the {} one, in m g W", scene.name(), wall),
       .values = signed_by(
           difference(scene.of("granular_temperature", 0), scene.of("granular_temperature", scene.bins() - 1))),
       .band = {0, INFINITY}});
}

void check_class(const SceneValues& scene, const Window& window, const std::string& stated, Evidence& evidence) {
  const std::vector<Structure> wanted = structures_named(stated);
  std::vector<std::optional<Structure>> labels;
  std::vector<double> hits;
  for (const Record& record : scene.records()) {
    const DensityContrast contrast = density_contrast_between(record, window.from, window.to);
    labels.push_back(classify(contrast));
    hits.push_back(is_one_of(wanted, contrast) ? 1 : 0);
  }
  evidence.checks.push_back({.label = fmt::format("{}, {}: replicas with a {}", scene.name(), window.text(), stated),
                             .values = std::move(hits),
                             .band = majority,
                             .reference = NAN,
                             .share = true});
  evidence.notes.push_back(fmt::format("{}, {}: {}.", scene.name(), window.text(), tally_of(labels)));
}

constexpr std::size_t blocks_per_window = 8;  // of the plot against time, and of the onset

double window_length(const Record& record) {
  return static_cast<double>(blocks_per_window) * block_times(record).length;
}

/// When the strongest mode came up, and how fast it moves.
void note_motion(const SceneValues& scene, const Window& late, Evidence& evidence) {
  std::vector<double> onsets, speeds, flows, lags;
  for (const Record& record : scene.records()) {
    const StrongestMode mode = strongest_mode(density_contrast_between(record, late.from, late.to));
    if (mode.contrast < visible_contrast) continue;
    const bool from_the_start = record.run.start_up == 0;  // else it may have come up before anything was measured
    if (const auto onset = onset_time(record, mode.shape, mode.k, blocks_per_window); onset && from_the_start)
      onsets.push_back(*onset);
    if (const auto speed = mode_speed(record, mode.shape, mode.k)) {
      speeds.push_back(*speed);
      flows.push_back(snapshot_flow(record));
      lags.push_back(*speed / flows.back());
    }
  }
  const auto text = [](const std::vector<double>& values) {
    const ReplicaSummary s = summarise(values);
    return fmt::format("{:.3g} +- {:.2g}", s.mean, s.standard_error());
  };
  if (onsets.size() > 1)
    evidence.notes.push_back(fmt::format(
        "{}: the strongest mode of a run is first visible, and in half of the time from then on, at t = {} ({} of "
        "{} runs; windows of {:.2g}).",
        scene.name(), text(onsets), onsets.size(), scene.replicas(), window_length(scene.records().front())));
  if (speeds.size() > 1)
    evidence.notes.push_back(
        fmt::format("{}: it moves along the channel at {} (gW)^1/2, {} of the mean velocity of the disks, {}, the "
                    "nearest to that of the speeds which its phase allows (last "
                    "snapshots of {} runs).",
                    scene.name(), text(speeds), text(lags), text(flows), speeds.size()));
}

/// P(kx, ky) over its noise, averaged over the states that a run kept from `from` on and over ky and -ky. Power does
/// not depend on where along the channel a wave stands: this is what an average in the frame of the wave would show.
std::map<std::pair<int, int>, double> mean_spectrum(const Record& record, double from) {
  constexpr int along = 64, across = 32, most_kx = 8, most_ky = 3;
  std::vector<const State*> states{&record.final_state};
  for (const Snapshot& s : record.snapshots)
    if (s.time >= from) states.push_back(&s.state);
  const double unit = noise_of_spectrum(record.scene) * static_cast<double>(states.size());
  std::map<std::pair<int, int>, double> mean;
  for (const State* state : states) {
    const DensitySpectrum spectrum(density_field(record.scene, *state, along, across));
    for (int kx = 0; kx <= most_kx; ++kx)
      for (int ky = 0; ky <= most_ky; ++ky)
        if (kx + ky > 0) mean[{kx, ky}] += (spectrum.power(kx, ky) + spectrum.power(kx, -ky)) / (2 * unit);
  }
  return mean;
}

/// The highest peaks of the replicas' mean spectra, with their errors.
void note_spectrum(const SceneValues& scene, const Window& late, Evidence& evidence) {
  constexpr std::size_t shown = 6;
  std::map<std::pair<int, int>, std::vector<double>> powers;
  for (const Record& record : scene.records())
    for (const auto& [mode, power] : mean_spectrum(record, late.from)) powers[mode].push_back(power);
  std::vector<std::pair<double, std::string>> peaks;
  for (const auto& [mode, values] : powers) {
    const Estimate e = over_replicas(values);
    peaks.emplace_back(e.mean, fmt::format("({}, {}) {}", mode.first, mode.second, number_with_error(e.mean, e.error)));
  }
  std::sort(peaks.rbegin(), peaks.rend());
  peaks.resize(std::min(peaks.size(), shown));
  std::vector<std::string> texts;
  for (const auto& [power, text] : peaks) texts.push_back(text);
  evidence.notes.push_back(
      fmt::format("{}: highest peaks (kx, ky) of the two-dimensional spectrum of the density, averaged over the states "
                  "kept from t = {:.3g} on and over {} replicas, in units of the noise 2 nu^2/N: {}.",
                  scene.name(), late.from, scene.replicas(), fmt::join(texts, ", ")));
}

/// The first replica's snapshots, without the last, which is there for the speed.
void draw_snapshots(const SceneValues& scene, Evidence& evidence) {
  const Record& record = scene.records().front();
  for (std::size_t s = 0; s + 1 < record.snapshots.size(); ++s) {
    const Snapshot& snapshot = record.snapshots[s];
    const std::string title = fmt::format("{}, t = {:.4g}", scene.name(), snapshot.time);
    evidence.drawings.push_back({title, snapshot_svg(record.scene, snapshot.state, title)});
  }
}

/// Contrast of the strongest mode of each shape against time, and the kinetic energy of a disk, replicas averaged. Of
/// more than two scenes, `crowded`, only the shape that is the strongest in the end.
void draw(const SceneValues& scene, bool crowded, Plot& plot) {
  const Record& first = scene.records().front();
  const double window = window_length(first), begin = first.run.start_up;
  const ModeShape strongest = strongest_mode(density_contrast_between(first, first.time - 2 * window, INFINITY)).shape;
  for (const auto& [name, shape, member] : {std::tuple{"even (slug, clumps)", ModeShape::even, &DensityContrast::even},
                                            {"odd (wave)", ModeShape::odd, &DensityContrast::odd},
                                            {"varicose", ModeShape::varicose, &DensityContrast::varicose}}) {
    if (crowded && shape != strongest) continue;
    Series series{.label = fmt::format("{}, {}", scene.name(), name), .style = SeriesStyle::line};
    for (std::size_t w = 0; (w + 1) * blocks_per_window <= first.blocks; ++w) {
      const double from = begin + static_cast<double>(w) * window, to = from + window;
      double sum = 0;
      for (const Record& record : scene.records()) {
        const std::vector<double> c = density_contrast_between(record, from, to).*member;
        sum += *std::max_element(c.begin(), c.end());
      }
      series.x.push_back((from + to) / 2);
      series.y.push_back(sum / static_cast<double>(scene.replicas()));
    }
    plot.series.push_back(std::move(series));
  }
  Series energy{.label = fmt::format("{}, energy", scene.name()), .style = SeriesStyle::line};
  std::size_t moments = first.history.time.size();
  for (const Record& record : scene.records()) moments = std::min(moments, record.history.time.size());
  for (std::size_t h = 0; h < moments; ++h) {
    double sum = 0;
    for (const Record& record : scene.records()) sum += record.history.energy[h];
    energy.x.push_back(first.history.time[h]);
    energy.y.push_back(sum / static_cast<double>(scene.replicas()));
  }
  plot.series.push_back(std::move(energy));
}

}  // namespace

// Claim waves.classifier: `runs` made runs of each structure, in the middle of the channel and shifted toward a wall,
// and as many of a gas without any: at least `right` of them get their own label, and none that of another class.
Evidence estimate_structure_classes(const Claim& claim, Tier, const SceneRecords&) {
  const int runs = static_cast<int>(claim.parameter("runs")), modes = static_cast<int>(claim.parameter("modes")),
            snapshots = static_cast<int>(claim.parameter("snapshots"));
  MadeChannel channel{.disks = static_cast<int>(claim.parameter("disks")), .length = 4};
  Evidence evidence;
  const auto add = [&](const std::string& name, Structure structure) {
    const auto count = labels_of(structure, channel, modes, snapshots, runs);
    const auto of = [&](const std::string& label) { return count.contains(label) ? count.at(label) : 0; };
    const int right = of(name_of(structure)), abstained = of(name_of(std::nullopt));
    evidence.checks.push_back({.label = name + ": share with the right label",
                               .values = {static_cast<double>(right) / runs},
                               .band = {claim.parameter("right"), 1},
                               .exact = true});
    evidence.checks.push_back({.label = name + ": share with the label of another structure",
                               .values = {static_cast<double>(runs - right - abstained) / runs},
                               .band = {0, 0},
                               .exact = true});
    std::string row = fmt::format("{} ({} runs):", name, runs);
    for (const auto& [label, n] : count) row += fmt::format(" {} {},", n, label);
    row.back() = '.';
    evidence.notes.push_back(std::move(row));
  };
  for (const double shift : {0.0, claim.parameter("shift")})
    for (const Structure structure : structures) {
      channel.shift = shift;
      add(fmt::format("{}{}", name_of(structure), shift == 0 ? "" : ", shifted toward a wall"), structure);
    }
  channel.shift = 0, channel.uniform_across = true;
  add("gas without structure", Structure::plug);
  channel.uniform_across = false;

  evidence.plot = {.title = "Made runs with the right label",
                   .xlabel = "strength of the structure",
                   .ylabel = "share of the runs",
                   .yrange = {{-0.05, 1.05}}};
  for (int s = 1; s < all_classes; ++s) {
    const Structure structure = structures[static_cast<std::size_t>(s)];
    Series series{.label = name_of(structure)};
    const int half = runs / 2;
    for (int step = 0; step <= 10; ++step) {
      channel.strength = step / 10.0;
      const auto count = labels_of(structure, channel, modes, snapshots, half);
      const auto found = count.find(name_of(structure));
      series.x.push_back(channel.strength);
      series.y.push_back(found == count.end() ? 0 : static_cast<double>(found->second) / half);
    }
    evidence.plot.series.push_back(std::move(series));
  }
  return evidence;
}

// Claims waves.*: in the window of time from `late_from` on (0 where it is not given) more than half of the replicas of
// each scene have the structure that [structures] states; from `early_from` to `early_to`, where given, no mode is
// `seen` beside the plug's peak. Where the walls differ and `toward_rougher` is 1 (-1) the band lies nearer to the
// rougher (smoother) one, and that is the colder.
Evidence estimate_density_waves(const Claim& claim, Tier, const SceneRecords& records) {
  const auto parameter = [&](const char* name, double otherwise) {
    return claim.parameters.contains(name) ? claim.parameter(name) : otherwise;
  };
  const Window late{parameter("late_from", 0)}, early{parameter("early_from", 0), parameter("early_to", 0)};
  Evidence evidence;
  evidence.plot = {.title = "Density modes and kinetic energy",
                   .xlabel = "t",
                   .ylabel = "contrast of a mode; energy, m g W",
                   .logy = true};
  for (const auto& [name, stated] : claim.structures)
    if (!records.contains(name))
      throw InputError(fmt::format("claim {} states the structure of '{}', which it does not read", claim.id, name),
                       "[structures] and [scenes] differ", "correct the claim file");
  for (const auto& [name, replicas] : records) {
    const SceneValues scene(name, replicas);
    const auto stated = claim.structures.find(name);
    if (stated == claim.structures.end())
      throw InputError(fmt::format("claim {} does not state the structure of '{}'", claim.id, name),
                       "every scene of a waves claim has one", fmt::format("add \"{}\" to [structures]", name));
    if (early.to > early.from)
      evidence.checks.push_back(
          {.label = fmt::format("{}, {}: highest peak along the channel over the plug's", name, early.text()),
           .values = per_replica(
               replicas.size(), [&](auto r) { return highest_peak_between(scene.records()[r], early.from, early.to); }),
           .band = {0, claim.parameter("seen")}});
    check_class(scene, late, stated->second, evidence);
    check_shift(scene, parameter("toward_rougher", 0), evidence);
    note_motion(scene, late, evidence);
    note_spectrum(scene, late, evidence);
    draw(scene, records.size() > 2, evidence.plot);
    draw_snapshots(scene, evidence);
  }
  return evidence;
}

// Claim waves.clumps.peaks: how many peaks the density has along k_x. Of the powers c_k - 1 of the even modes above
// those of independent disks the effective number (sum)^2/(sum of squares) is at least `peaks`.
Evidence estimate_density_peaks(const Claim& claim, Tier, const SceneRecords& records) {
  Evidence evidence;
  evidence.plot = {.title = "Power along the channel",
                   .xlabel = "k",
                   .ylabel = "contrast of the even mode",
                   .logx = true,
                   .logy = true};
  for (const auto& [name, replicas] : records) {
    const SceneValues scene(name, replicas);
    const std::vector<DensityContrast> contrasts = density_contrasts(scene);
    evidence.checks.push_back({.label = fmt::format("{}: number of peaks along k_x", name),
                               .values = per_replica(contrasts.size(),
                                                     [&](auto r) {
                                                       double sum = 0, squares = 0;
                                                       for (const double c : contrasts[r].even)
                                                         sum += c - 1, squares += square(c - 1);
                                                       return sum * sum / squares;
                                                     }),
                               .band = {claim.parameter("peaks"), INFINITY},
                               .reference = NAN});
    Series series{.label = name};
    for (std::size_t k = 0; k < contrasts.front().even.size(); ++k)
      add_point(series, static_cast<double>(k) + 1,
                per_replica(contrasts.size(), [&](auto r) { return contrasts[r].even[k]; }));
    evidence.plot.series.push_back(std::move(series));
  }
  return evidence;
}

}  // namespace gpf
