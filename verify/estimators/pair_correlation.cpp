// gr.liquid, gr.crystal, gr.dense: the class of order that g(r) and the bond angles show, bin by bin.
#include <fmt/format.h>

#include <map>
#include <string>
#include <vector>

#include "verify/estimators/estimators.hpp"
#include "verify/estimators/local_order.hpp"

namespace gpf {
namespace {

/// What the thesis calls a bin (counted from 0, with its mirror image).
struct Expected {
  int bin;
  Order order;
};

/// "4 liquid" or "3 liquid, 1 crystal".
std::string tally_of(const std::vector<LocalOrder>& orders) {
  std::map<std::string, int> count;
  for (const LocalOrder& order : orders) ++count[name_of(classify(order))];
  std::string text;
  for (const auto& [name, n] : count) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", n, name);
  return text;
}

/// Checks the criteria of each bin's class in every scene. g(r) is eq. 3.3 normalised by the strip's own geometry
/// (Strip).
Evidence class_evidence(const SceneRecords& records, const std::function<std::vector<Expected>(int half)>& expected) {
  Evidence evidence;
  evidence.plot = {.title = "Pair correlation function",
                   .xlabel = "r/d",
                   .ylabel = "g(r)",
                   .xrange = {{0.9, 8}},
                   .yrange = {{0, 6}}};
  for (const auto& [name, replicas] : records) {
    const SceneValues scene(name, replicas);
    const std::string label = label_of(scene.scene());
    std::string note;
    for (const auto& [bin, order] : expected(scene.half())) {
      const std::vector<PairFunctions> pairs = pair_functions(scene, bin);
      std::vector<LocalOrder> orders;
      for (const PairFunctions& p : pairs) orders.push_back(local_order(p));
      const auto values = [&](double LocalOrder::*value) {
        return per_replica(orders.size(), [&](std::size_t r) { return orders[r].*value; });
      };
      const std::string bins = fmt::format("bins {} and {}", bin + 1, scene.bins() - bin);
      for (const OrderCriterion& criterion : criteria_of(order))
        evidence.checks.push_back(
            {.label = fmt::format("{}, {}: {}, for a {}", label, bins, criterion.name, name_of(order)),
             .values = values(criterion.value),
             .band = criterion.range,
             .x = scene.centre(bin)});
      note += fmt::format(
          "; {} (local nu {:.3f}): {}, second shell {:.3f}, split {:.2f}, |psi_6| {:.3f}, {:.2f} "
          "neighbours",
          bins, over_replicas(scene.mirrored("area_fraction", bin)).mean, tally_of(orders),
          over_replicas(values(&LocalOrder::shell)).mean, over_replicas(values(&LocalOrder::split)).mean,
          over_replicas(values(&LocalOrder::hexatic)).mean,
          over_replicas(per_replica(pairs.size(), [&](auto r) { return pairs[r].neighbours(); })).mean);
      evidence.plot.series.push_back(curve_of(fmt::format("{}, bin {}", label, bin + 1), pairs,
                                              [](const PairFunctions& p) { return p.pair_correlation(); }));
    }
    evidence.notes.push_back(label + note + ".");
  }
  evidence.notes.emplace_back(
      "Classes (thresholds from equilibrium hard disks seen through the same strips): gas, no second shell (g over "
      "1.95 ... 2.35 d not above g over 1.4 ... 1.7 d; nu below .40); liquid, a second shell (.13 and more; nu above "
      ".45), of one hump, |psi_6| below .70 (freezing); crystal, the second shell split, |psi_6| above .80 (melting). "
      "g(r) is normalised by the strip's own geometry, the bins y and W - y together; with 2 pi r instead it would "
      "fall off with r in every bin alike. The plot cuts off the first peaks of crystals.");
  return evidence;
}

}  // namespace

Evidence estimate_liquid_order(const Claim&, Tier, const SceneRecords& records) {
  return class_evidence(records, [](int half) {
    std::vector<Expected> all;
    for (int bin = 0; bin < half; ++bin) all.push_back({bin, Order::liquid});
    return all;
  });
}

Evidence estimate_plug_order(const Claim&, Tier, const SceneRecords& records) {
  return class_evidence(records, [](int half) {
    return std::vector<Expected>{{half - 1, Order::crystal}, {half / 2, Order::gas}, {0, Order::gas}};
  });
}

Evidence estimate_dense_order(const Claim&, Tier, const SceneRecords& records) {
  return class_evidence(records, [](int half) {
    return std::vector<Expected>{{half - 1, Order::crystal}, {1, Order::liquid}};
  });
}

}  // namespace gpf
