// What must hold for every record before a verdict may rest on it.
#pragma once

#include <vector>

#include "verify/claim.hpp"
#include "verify/evidence.hpp"

namespace gpf {

/// Two-sided rate of |z| > 3: how often a healthy claim fails one of the two statistical health checks, however many
/// records and fields it reads.
inline constexpr double health_false_alarm_rate = 0.0027;

/// Fewest blocks of a record that is to show that it is steady: eight in each quarter of the window.
inline constexpr std::size_t fewest_blocks_of_a_steady_run = 32;

/// Deepest overlap in diameters where positions are known well enough, and imbalance of the energy budget over the
/// measured window in units of the energy that turned over. Both are round-off, far below these limits, unless an event
/// was missed or resolved wrongly.
inline constexpr double deepest_healthy_overlap = 1e-12;
inline constexpr double largest_healthy_imbalance = 1e-12;

/// Deepest overlap in diameters that round-off explains in a scene: deepest_healthy_overlap, but no less than two
/// quanta of the grid on which positions lie (PositionGrid; 2^-52 of the longest side). Each coordinate of two disks in
/// contact is off by up to half a quantum, their distance hence by up to sqrt(2). In a channel 300 W long with W = 31 d
/// a quantum is 3.5e-12 d.
double healthy_overlap(const Scene& scene);

/// The checks that hold for every record of a claim; each is one line, with its most extreme case in `detail`.
///
/// For every record:
/// - no two replicas of a scene have the same trace hash;
/// - no overlap deeper than healthy_overlap();
/// - gravity's work = energy lost in contacts and at walls + kinetic energy gained.
///
/// Where the claim makes statistical checks and does not read the transient, for scenes that can be steady:
/// - the main fields (main_fields) do not drift: drift_test's two contrasts for each scene and field. "|z| < 3" is for
///   one test; with m of them each has the error rate health_false_alarm_rate/m (Bonferroni), so that a claim with many
///   scenes raises no more false alarms than one with a single scene. Records with fewer than
///   fewest_blocks_of_a_steady_run blocks fail: they cannot show it;
/// - replicas scatter no less than their block errors (R >= 8 and at least 20 blocks): else they are not independent,
///   and the verdict, which rests on their scatter alone, is too sure. The ratio of block error to scatter is at most
///   2, or departs from 1 by no more than chance, with the same error rate and correction. (With R = 8 the scatter
///   itself is known to 27 %: for true ratios of 1, 3 % of the measured ones exceed 2.) Block errors are too large by
///   themselves where neighbouring blocks undo each other - a rate whose integral is bounded, such as the virial of a
///   crystal whose disks keep their places -: correlations at lags 1 and 2 that sum up to -3/8 or below make the
///   variance of a run's mean 1 + 2 (rho_1 + rho_2) <= 1/4 of what the blocks' scatter says, and explain a ratio
///   above 2. A ratio below 1/2 is told, but no failure: runs that keep to long-lived states of their own (plugs do)
///   are what replicas are for.
std::vector<HealthCheck> check_records(const Claim& claim, const SceneRecords& records, bool statistical);

}  // namespace gpf
