// Runs of a program with a fault in it.
#pragma once

#include <filesystem>

#include "verify/faults/fault.hpp"
#include "verify/run_pool.hpp"

namespace gpf {

/// simulate() with a fault of this dose: its record says that it is of the scene asked for. A fault in the sums alone
/// is put into a copy of the right record, where `right` has it. Leaves no checkpoint. Throws what simulate() throws.
RunFunction simulate_with(const Fault& fault, double dose, std::filesystem::path right);

}  // namespace gpf
