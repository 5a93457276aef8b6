// Which source text simulates: the fingerprint by which records of an edited program are told from those of this one.
#pragma once

#include <cstdint>

namespace gpf {

/// Hash of the source files that a record's content depends on (base, scene, event, measure, io and simulate), taken
/// when the program was built. The physics version only changes when somebody says so; this changes with every edit.
std::uint64_t simulation_sources();

/// Hash of the source files that decide about a record's verdict: statistics, theory, estimators, judge - and the
/// faults that may have been put into it.
std::uint64_t judging_sources();

}  // namespace gpf
