// Does a quantity drift during the averaging window? Judged across replicas, by how they agree on it.
#pragma once

#include <vector>

namespace gpf {

/// Two contrasts of a quantity's mean course over the window, each with the two-sided p-value of "no drift".
struct DriftTest {
  double halves_p;         ///< second half against first
  double first_quarter_p;  ///< first quarter against the rest: would a longer start-up cut change the mean?
};

/// One series per replica, its blocks in order of time; the replicas' lengths may differ. The windows are cut into
/// quarters (blocks beyond a multiple of four, at the start, are left out) and the table replicas x quarters is
/// analysed by two-way analysis of variance: a drift common to the replicas against what remains when means of replicas
/// and of quarters are taken off, with 3 (R - 1) degrees of freedom.
///
/// Block errors within a run would give one z per run, but when the correlation time is longer than a block - slow
/// modes of a flow are - they are too small: of independent stationary AR(1) series of 256 blocks with a correlation
/// time of 10 blocks, 2 % have |z| > 3 by the halves' block errors, and 6 % of such series of 128 blocks. This test's
/// rate stays at its nominal 0.27 %, and at 0.4 %, for the same series and four replicas. Both p-values are NaN with
/// fewer than two replicas or a series of fewer than four blocks; 1 when nothing moves.
DriftTest drift_test(const std::vector<std::vector<double>>& replicas);

}  // namespace gpf
