// The reference data files as tables of numbers.
#pragma once

#include <boost/test/unit_test.hpp>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

/// Rows of reference/data/<name>: comment lines (#) and the header row left out, commas between numbers.
inline std::vector<std::vector<double>> reference_table(const std::string& name) {
  std::ifstream file(std::string(GPF_REFERENCE_DATA) + "/" + name);
  BOOST_REQUIRE_MESSAGE(file, "cannot open reference data " << name);
  std::vector<std::vector<double>> rows;
  bool header = true;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line.front() == '#') continue;
    if (header) {
      header = false;
      continue;
    }
    std::vector<double> row;
    std::istringstream fields(line);
    for (std::string field; std::getline(fields, field, ',');) row.push_back(std::stod(field));
    rows.push_back(row);
  }
  BOOST_REQUIRE(!rows.empty());
  return rows;
}
