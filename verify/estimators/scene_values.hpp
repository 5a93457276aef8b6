// The replicas of one scene as numbers: every derived quantity once per replica, ready to become a check's values.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "gpf/io/plot.hpp"
#include "gpf/stats/estimate.hpp"
#include "verify/evidence.hpp"

namespace gpf {

/// Sums of all tallies over the measured window, in the order of TallyLayout(record.run).
std::vector<double> totals_of(const Record& record);

/// When the blocks of a record were measured: block b from start + b length on. What was measured after the last one
/// is in none.
struct BlockTimes {
  double start, length;
};
BlockTimes block_times(const Record& record);

/// Whether a quantity keeps or changes its sign when the channel is seen in a mirror at its centre plane.
enum class Parity { even, odd };

/// Bins b and bins - 1 - b of a steady channel are two measurements of the same thing; both are used, as one bin.
class SceneValues {
 public:
  /// Throws InputError without records, or when they are not of one scene (seeds apart).
  SceneValues(std::string name, const std::vector<Record>& records);

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] const Scene& scene() const { return records_->front().scene; }
  [[nodiscard]] const std::vector<Record>& records() const { return *records_; }
  [[nodiscard]] std::size_t replicas() const { return records_->size(); }
  [[nodiscard]] int bins() const { return records_->front().run.bins; }
  /// Bins on one side of the centre plane, the middle one of an odd number included.
  [[nodiscard]] int half() const { return (bins() + 1) / 2; }
  [[nodiscard]] double centre(int bin) const { return (bin + 0.5) / bins(); }

  /// A quantity of derive_quantities, one value per replica. Throws InputError when there is none of that name.
  [[nodiscard]] std::vector<double> of(std::string_view quantity, int bin = 0) const;
  /// Mean of `bin` and its mirror image, one value per replica.
  [[nodiscard]] std::vector<double> mirrored(std::string_view quantity, int bin, Parity parity = Parity::even) const;
  /// mirrored() for each bin of one side, averaged over the replicas.
  [[nodiscard]] std::vector<double> mean_profile(std::string_view quantity) const;

 private:
  std::string name_;
  const std::vector<Record>* records_;
  std::vector<std::map<std::string, std::vector<double>, std::less<>>> quantities_;  // by replica
};

/// The scenes of the evidence, by area fraction.
std::vector<SceneValues> by_area_fraction(const SceneRecords& records);

/// f(0), f(1), ... f(count - 1).
template <class F>
std::vector<double> per_replica(std::size_t count, F&& f) {
  std::vector<double> values;
  for (std::size_t r = 0; r < count; ++r) values.push_back(f(r));
  return values;
}

/// a - b, replica by replica; as long as the shorter one.
std::vector<double> difference(const std::vector<double>& a, const std::vector<double>& b);
/// The absolute value in every replica.
std::vector<double> magnitude(std::vector<double> values);

/// Mean and standard error over replicas; the error is NaN for one.
Estimate over_replicas(const std::vector<double>& values);

/// Appends a point with its error bar.
void add_point(Series& series, double x, const std::vector<double>& values);

/// +-half_width about `reference`.
Interval band_about(double reference, double half_width);

/// Processor time of this process, all threads, in seconds.
double process_cpu_seconds();

}  // namespace gpf
