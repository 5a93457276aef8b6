// The page "Speed against accuracy": plots, Pareto fronts and tables of the chart's points.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "verify/methods/chart.hpp"

namespace gpf {

/// Which of the points no other one beats in both cost and total error of the observable; those that gave up or do not
/// give it are not among them. All of one scene.
std::vector<bool> pareto_front(const std::vector<const ChartPoint*>& points, std::string_view observable);

/// Writes methods.md into `folder`, its pictures into `folder`/methods. Throws StorageError.
void write_chart_page(const ChartPlan& plan, const std::vector<ChartPoint>& points,
                      const std::filesystem::path& folder);

}  // namespace gpf
