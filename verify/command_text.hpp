// Commands that somebody is to repeat, as text.
#pragma once

#include <filesystem>
#include <string>

namespace gpf {

/// One word for a shell, between single quotes.
std::string shell_word(const std::string& text);

/// " --reference mine --store there" for a command that reads these folders; nothing of a folder that has the name of
/// the suite's own.
std::string folder_options(const std::filesystem::path& reference, const std::filesystem::path& store = "records");

}  // namespace gpf
