// Verdicts on disk: JSON beside the records, complete, so that pages are written without judging again.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "verify/judge.hpp"

namespace gpf {

/// <store>/verdicts/<tier>/<claim id>.json
std::filesystem::path verdict_path(const std::filesystem::path& store, Tier tier, std::string_view claim_id);

/// One JSON object with everything that the verdict holds, plot and values of each replica included. Numbers that are
/// not finite are the strings "nan", "inf" and "-inf".
std::string verdict_text(const Verdict& verdict);

/// The verdict of such a text. Throws InputError, with `name` in the message, when it is damaged or incomplete.
Verdict parse_verdict(std::string_view text, std::string_view name);

/// Written atomically; creates the folders. Throws StorageError.
void write_verdict(const Verdict& verdict, const std::filesystem::path& store);

/// Throws StorageError when there is none or it cannot be read, InputError as parse_verdict.
Verdict read_verdict(const std::filesystem::path& store, Tier tier, std::string_view claim_id);

}  // namespace gpf
