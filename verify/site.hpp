// Reports and guide as HTML pages that need no server and no network.
#pragma once

#include <filesystem>
#include <string>

namespace gpf {

struct SiteOptions {
  std::filesystem::path reports = "reports", reference = "reference";
  std::filesystem::path output;  ///< folder of the site
};

/// A page for README.md, CHANGELOG.md (beside `reference`, where they are there), every *.md below `reports`,
/// `reference`/guide and `reference`/claims, and every *.md that one of these links to, at the same place below
/// `output`, where `reports` is reports/ and `reference` is reference/; the files that they link to or show; and
/// index.html, which lists the pages. Links to *.md become links to *.html.
///
/// cmark-gfm converts in its safe mode: no HTML in a page and no javascript: link survives, but for the folded tables
/// of claims' pages. Returns the path of index.html. Throws InputError when there is nothing to convert or a page
/// links to what is not there or not among these folders; StorageError when cmark-gfm is missing or fails, or a file
/// cannot be read or written.
std::filesystem::path write_site(const SiteOptions& options);

/// The body of one page: markdown as safe HTML. Throws StorageError as above.
std::string html_of(const std::string& markdown);

}  // namespace gpf
