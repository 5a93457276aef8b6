// The JSON object that `gpf run --json` prints.
#pragma once

#include <string>

#include "gpf/io/record.hpp"

namespace gpf {

/// One object: counts, times and the hash plain, every measured quantity as {"mean", "error"} - numbers, or parallel
/// arrays over the bins whose centres are "y". What could not be measured is null.
std::string run_json(const Record& record);

}  // namespace gpf
