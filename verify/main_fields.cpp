#include "verify/main_fields.hpp"

#include <cmath>
#include <functional>
#include <span>

#include "gpf/measure/tallies.hpp"

namespace gpf {
namespace {

/// One block's row of tallies.
class Row {
 public:
  Row(const TallyLayout& layout, std::span<const double> sums) : layout_(layout), sums_(sums) {}

  [[nodiscard]] double operator()(Tally tally) const { return sums_[layout_.at(tally)]; }
  [[nodiscard]] double over_bins(Tally tally) const {
    double total = 0;
    for (int bin = 0; bin < layout_.bins(); ++bin) total += sums_[layout_.at(tally, bin)];
    return total;
  }

 private:
  const TallyLayout& layout_;
  std::span<const double> sums_;
};

double granular_temperature(const Row& row) {
  return 0.5 * (row.over_bins(Tally::ux2) / row.over_bins(Tally::freedom) +
                row.over_bins(Tally::cy2) / row.over_bins(Tally::count));
}

}  // namespace

bool has_steady_state(const Scene& scene) {
  const auto& beta = scene.wall_tangential_restitution;
  const bool channel = scene.geometry == Geometry::channel;
  const bool rough = channel && (std::abs(beta[lower]) < 1 || std::abs(beta[upper]) < 1);
  if (scene.gravity != 0) return rough;
  return scene.normal_restitution == 1 && !rough && (!channel || scene.wall_normal_restitution == 1);
}

std::vector<BlockedField> main_fields(const Record& record) {
  if (!has_steady_state(record.scene)) return {};
  const TallyLayout layout(record.run);
  const auto field = [&](std::string name, const std::function<double(const Row&)>& of_block) {
    BlockedField result{std::move(name), {}};
    for (std::size_t b = 0; b < record.blocks; ++b)
      result.blocks.push_back(of_block({layout, std::span(record.sums).subspan(b * layout.size(), layout.size())}));
    return result;
  };
  using enum Tally;
  if (record.scene.gravity != 0)
    return {field("mean flow", [](const Row& row) { return row(momentum) / row.over_bins(count); }),
            field("kinetic energy", [](const Row& row) { return row(energy) / row.over_bins(count); }),
            field("granular temperature", granular_temperature)};
  return {field("virial", [](const Row& row) { return row(virial) / row(measured_time); }),
          field("collision rate", [](const Row& row) { return row(pair_contacts) / row(measured_time); })};
}

}  // namespace gpf
