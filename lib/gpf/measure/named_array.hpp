// Sums with an axis or more, as a run collects them and a record keeps them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <numeric>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "gpf/base/error.hpp"

namespace gpf {

/// Numbers in row-major order; the last axis is contiguous.
struct NamedArray {
  std::string name;
  std::vector<std::size_t> shape;
  std::vector<double> values;

  NamedArray(std::string name_, std::vector<std::size_t> shape_)
      : name(std::move(name_)),
        shape(std::move(shape_)),
        values(std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>())) {}

  double& at(std::size_t row, std::size_t column) { return values[row * shape.back() + column]; }
  [[nodiscard]] double at(std::size_t row, std::size_t column) const { return values[row * shape.back() + column]; }
};
using NamedArrays = std::vector<NamedArray>;

/// The array of that name. Throws InputError when there is none.
inline const NamedArray& array_named(const NamedArrays& arrays, std::string_view name) {
  const auto found = std::find_if(arrays.begin(), arrays.end(), [name](const NamedArray& a) { return a.name == name; });
  if (found != arrays.end()) return *found;
  throw InputError("a record lacks the array " + std::string(name), "its run measured less than is asked for",
                   R"(give the scene detail = "distributions" or "correlations" in [run] and run it again)");
}

}  // namespace gpf
