// What a record measured, as tables of comma-separated values.
#pragma once

#include <string>

#include "gpf/io/record.hpp"

namespace gpf {

/// Texts with a line of names each, then rows. Numbers read back to the same bits; nan: not measured, or without an
/// error.
struct CsvTables {
  std::string profiles;  ///< a row per bin: bin (from 1), y (of its centre), each profile and its standard error
  std::string scalars;   ///< a row per number of the whole flow: quantity, mean, error
  std::string modes;  ///< a row per wavenumber k (from 1), as the profiles; empty where no density modes were measured
};

CsvTables csv_tables(const Record& record);

}  // namespace gpf
