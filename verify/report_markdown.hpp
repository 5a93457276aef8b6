// Texts from claim files and verdicts as markdown that shows them as they are.
#pragma once

#include <string>
#include <string_view>

namespace gpf {

/// `text` on one line, with everything escaped that markdown (CommonMark with GitHub's additions) or HTML would act
/// upon, and nothing else, so that the source stays readable. Good for a paragraph, a list item or, through
/// markdown_table, a cell: pipes are left to that.
std::string markdown_text(std::string_view text);

}  // namespace gpf
