// A claim in words, for somebody who wants to know what is tested and why it may be off by so much.
#pragma once

#include <filesystem>
#include <string>

#include "verify/claim.hpp"

namespace gpf {

/// Plain text: source, statement, method, expectation with its reason, the tolerance budget as a table with its sum,
/// scenes and replicas by tier, estimator, parameters, checks, the faults that it is there to catch, the command that
/// reproduces it.
std::string explain(const Claim& claim, const std::filesystem::path& reference = "reference");

}  // namespace gpf
