// The page of errata of a report.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "verify/errata.hpp"

namespace gpf {

/// The page as markdown; claims with a page in this report (`pages`, their ids) are linked, others named.
std::string errata_page(const std::vector<Erratum>& errata, const std::set<std::string>& pages);

}  // namespace gpf
