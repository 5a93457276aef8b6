#include "verify/site.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <deque>
#include <fstream>
#include <map>
#include <set>
#include <string_view>
#include <system_error>

#include "gpf/base/error.hpp"
#include "gpf/io/atomic_file.hpp"
#include "gpf/io/subprocess.hpp"
#include "verify/writable.hpp"

namespace gpf {
namespace {

namespace fs = std::filesystem;

constexpr const char* frame = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; img-src 'self' file:; style-src 'unsafe-inline'">
<title>{title}</title>
<style>
body {{ max-width: 60em; margin: 0 auto; padding: 0 1em 3em; font: 16px/1.5 sans-serif; color: #222; }}
nav {{ border-bottom: 1px solid #ccc; padding: .6em 0; }}
nav a {{ margin-right: 1em; }}
pre {{ background: #f5f5f5; padding: .7em; overflow-x: auto; }}
code {{ font-size: 90%; }}
table {{ border-collapse: collapse; display: block; overflow-x: auto; font-size: 90%; }}
th, td {{ border: 1px solid #ccc; padding: .25em .5em; vertical-align: top; }}
blockquote {{ border-left: 4px solid #ccc; margin-left: 0; padding-left: 1em; }}
img {{ max-width: 100%; }}
</style>
</head>
<body>
{nav}<main>
{body}</main>
</body>
</html>
)";

/// The parts of the index, and the pages that each lists: those whose path starts so and no earlier part has taken.
constexpr std::array<std::pair<std::string_view, std::string_view>, 6> parts{{{"reference/guide/", "Guide"},
                                                                              {"reports/claims/", "Claims"},
                                                                              {"reports/full/", "Claims, tier full"},
                                                                              {"reports/audit/", "Audits"},
                                                                              {"reports/", "Reports"},
                                                                              {"", "More"}}};

bool is_page(const fs::path& path) { return path.extension() == ".md"; }

std::string html_name(const fs::path& page) { return fs::path(page).replace_extension(".html").generic_string(); }

/// An attribute's text: %41, &amp; and &quot; undone.
std::string plain(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i)
    if (text[i] == '%' && i + 2 < text.size() && std::isxdigit(static_cast<unsigned char>(text[i + 1])) != 0 &&
        std::isxdigit(static_cast<unsigned char>(text[i + 2])) != 0) {
      result += static_cast<char>(std::stoi(std::string(text.substr(i + 1, 2)), nullptr, 16));
      i += 2;
    } else if (text.substr(i, 5) == "&amp;") {
      result += '&';
      i += 4;
    } else if (text.substr(i, 6) == "&quot;") {
      result += '"';
      i += 5;
    } else {
      result += text[i];
    }
  return result;
}

/// "https:", "mailto:" and so on; "#part" of the page itself; "//host".
bool leads_elsewhere(std::string_view link) {
  const std::size_t end = link.find_first_of(":/?#");
  return link.empty() || link.front() == '#' || link.starts_with("//") ||
         (end != std::string_view::npos && link[end] == ':');
}

/// The text between the first <h1> and </h1>; the path where there is none. HTML.
std::string title_of(const std::string& html, const std::string& path) {
  const std::size_t begin = html.find("<h1>"), end = html.find("</h1>");
  return begin == std::string::npos || end < begin ? path : html.substr(begin + 4, end - begin - 4);
}

std::string without_tags(const std::string& html) {
  std::string text;
  bool inside = false;
  for (const char c : html) {
    inside = inside || c == '<';
    if (!inside) text += c;
    inside = inside && c != '>';
  }
  return text;
}

class Site {
 public:
  explicit Site(const SiteOptions& options) : options_(options) {}

  fs::path write() {
    find_pages();
    if (waiting_.empty())
      throw InputError(fmt::format("no page in '{}'", options_.reports.string()), "there is no *.md",
                       "write a report first, or name the folder that holds one: --output");
    require_writable_folder(options_.output);
    while (!waiting_.empty()) {
      const std::string page = waiting_.front();
      waiting_.pop_front();
      convert(page);
    }
    for (const std::string& file : files_) put(file, read_text(source_of(file)));
    return put("index.html", framed("index.html", "gpf", index_body()));
  }

 private:
  /// Where a file of the site comes from.
  [[nodiscard]] fs::path source_of(const std::string& file) const {
    if (file.starts_with("reports/")) return options_.reports / file.substr(8);
    if (file.starts_with("reference/")) return options_.reference / file.substr(10);
    return fs::absolute(options_.reference).lexically_normal().parent_path() / file;
  }

  void find_pages() {
    for (const char* page : {"README.md", "CHANGELOG.md"})
      if (fs::exists(source_of(page))) add(page);
    for (const char* folder : {"reports", "reference/guide", "reference/claims"}) {
      const fs::path source = source_of(folder + std::string("/"));
      if (!fs::is_directory(source)) continue;
      for (const auto& entry : fs::recursive_directory_iterator(source))
        if (entry.is_regular_file() && is_page(entry.path()))
          add((folder / fs::relative(entry.path(), source)).generic_string());
    }
  }

  void add(const std::string& page) {
    if (titles_.emplace(page, "").second) waiting_.push_back(page);
  }

  void convert(const std::string& page) {
    const std::string body = relinked(html_of(read_text(source_of(page))), page);
    titles_[page] = title_of(body, page);
    put(html_name(page), framed(page, without_tags(titles_[page]), body));
  }

  /// A site is soon made again: hundreds of files are not worth the wait for each to be safe on the disk.
  fs::path put(const std::string& file, const std::string& text) const {
    fs::path path = options_.output / file;
    std::error_code failure;
    fs::create_directories(path.parent_path(), failure);  // what follows tells when it is not there
    std::ofstream stream(path, std::ios::binary);
    stream << text;
    stream.close();
    if (!stream)
      throw StorageError(fmt::format("cannot write '{}'", path.string()), std::generic_category().message(errno),
                         "make room, or choose another folder with --html");
    return path;
  }

  /// cmark-gfm escapes every quote in texts, so that these attributes are its own.
  std::string relinked(const std::string& html, const std::string& page) {
    std::string result;
    std::size_t done = 0;
    for (std::size_t at = 0; at < html.size();) {
      const std::size_t href = html.find("href=\"", at), src = html.find("src=\"", at), next = std::min(href, src);
      if (next == std::string::npos) break;
      const std::size_t begin = html.find('"', next) + 1, end = html.find('"', begin);
      result += html.substr(done, begin - done) + relinked_to(html.substr(begin, end - begin), page);
      done = at = end;
    }
    return result + html.substr(done);
  }

  std::string relinked_to(const std::string& link, const std::string& page) {
    if (leads_elsewhere(link)) return link;
    const std::size_t end = std::min(link.find_first_of("?#"), link.size());
    const fs::path target = (fs::path(page).parent_path() / plain(link.substr(0, end))).lexically_normal();
    const std::string file = target.generic_string();
    if (target.is_absolute() || file.starts_with("..") || !fs::is_regular_file(source_of(file)))
      throw InputError(fmt::format("'{}' links to '{}'", source_of(page).string(), link),
                       "there is no such file beside it", "mend the link, or write the report anew");
    if (!is_page(target)) {
      files_.insert(file);
      return link;
    }
    add(file);
    return html_name(link.substr(0, end)) + link.substr(end);
  }

  [[nodiscard]] std::string framed(const std::string& page, const std::string& title, const std::string& body) const {
    std::string up;
    for (auto slashes = std::count(page.begin(), page.end(), '/'); slashes > 0; --slashes) up += "../";
    std::string nav = fmt::format("<nav><a href=\"{}index.html\">All pages</a>", up);
    for (const auto& [target, name] : std::initializer_list<std::pair<std::string, const char*>>{
             {"README.md", "gpf"}, {"reference/guide/README.md", "Guide"}, {"reports/README.md", "Report"}})
      if (titles_.contains(target)) nav += fmt::format(" <a href=\"{}{}\">{}</a>", up, html_name(target), name);
    return fmt::format(frame, fmt::arg("title", title), fmt::arg("nav", nav + "</nav>\n"), fmt::arg("body", body));
  }

  [[nodiscard]] std::string index_body() const {
    std::map<std::string_view, std::string> lists;
    for (const auto& [page, title] : titles_) {
      const auto part =
          std::find_if(parts.begin(), parts.end(), [&page = page](const auto& p) { return page.starts_with(p.first); });
      lists[part->second] += fmt::format("<li><a href=\"{}\">{}</a></li>\n", html_name(page), without_tags(title));
    }
    std::string body = "<h1>gpf: all pages</h1>\n";
    for (const std::string_view part : {"Guide", "Reports", "Claims", "Claims, tier full", "Audits", "More"})
      if (lists.contains(part)) body += fmt::format("<h2>{}</h2>\n<ul>\n{}</ul>\n", part, lists[part]);
    return body;
  }

  const SiteOptions& options_;
  std::deque<std::string> waiting_;
  std::map<std::string, std::string> titles_;  ///< by page
  std::set<std::string> files_;                ///< that pages link to or show
};

std::string converted(const std::string& markdown) {
  const ProcessResult result =
      run_program({"cmark-gfm", "-e", "table", "-e", "autolink", "-e", "strikethrough", "--to", "html"}, markdown);
  if (result.exit_status != 0)
    throw StorageError(fmt::format("cmark-gfm failed (status {})", result.exit_status), result.errors,
                       "check that cmark-gfm 0.29 or later runs");
  return result.output;
}

}  // namespace

std::string html_of(const std::string& markdown) {
  // Reports fold long tables in HTML of three fixed lines. These are kept, everything else of the kind is dropped.
  constexpr std::string_view summary = "<summary>All ", summary_end = " checks</summary>";
  std::string html, part;
  bool fenced = false, open = false;
  for (std::size_t begin = 0; begin < markdown.size();) {
    const std::size_t end = std::min(markdown.find('\n', begin), markdown.size());
    const std::string line = markdown.substr(begin, end - begin);
    begin = end + 1;
    if (line.starts_with("```") || line.starts_with("~~~")) fenced = !fenced;
    const bool folds = !fenced && line == (open ? "</details>" : "<details>");
    if (folds) {
      html += converted(part) + line + "\n";
      part.clear();
      open = !open;
    } else if (!fenced && open && part.empty() && line.starts_with(summary) && line.ends_with(summary_end) &&
               std::all_of(line.begin() + summary.size(), line.end() - summary_end.size(),
                           [](unsigned char c) { return std::isdigit(c) != 0; })) {
      html += line + "\n";
    } else {
      part += line + "\n";
    }
  }
  html += converted(part);
  return open ? html + "</details>\n" : html;
}

fs::path write_site(const SiteOptions& options) { return Site(options).write(); }

}  // namespace gpf
