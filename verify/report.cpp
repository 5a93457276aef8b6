#include "verify/report.hpp"

#include <fmt/format.h>

#include <set>
#include <string_view>
#include <vector>

#include "gpf/base/error.hpp"
#include "gpf/io/atomic_file.hpp"
#include "gpf/io/plot.hpp"
#include "gpf/io/provenance.hpp"
#include "verify/plot_files.hpp"
#include "verify/report_claim_page.hpp"
#include "verify/report_errata.hpp"
#include "verify/report_front_page.hpp"
#include "verify/report_limits.hpp"
#include "verify/report_pictures.hpp"

namespace gpf {
namespace {

namespace fs = std::filesystem;

void create(const fs::path& folder) {
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (failure)
    throw StorageError(fmt::format("cannot create '{}'", folder.string()), failure.message(),
                       "choose another folder with --output");
}

/// Whether a plot holds anything that can be drawn.
bool is_drawable(const Plot& plot) {
  if (plot.series.empty()) return false;
  try {
    return !gnuplot_script(plot).empty();
  } catch (const InputError&) {
    return false;
  }
}

class ReportWriter {
 public:
  explicit ReportWriter(fs::path output) : output_(std::move(output)) {
    for (const char* folder : {"claims", "checks"}) create(output_ / folder);
  }

  void claim(const JudgedClaim& judged, const ReportData& data) {
    const std::string& id = judged.claim.id;
    ClaimPictures pictures;
    if (const auto picture = checks_picture(judged.verdict)) {
      pictures.checks = "../" + draw(picture->plot, fmt::format("checks/{}.svg", id));
      pictures.checks_caption = picture->caption;
    }
    // A plot without a single finite number belongs to a claim that failed; its page is wanted all the more.
    if (is_drawable(judged.verdict.plot)) {
      draw(judged.verdict.plot, fmt::format("claims/{}.svg", id));
      plots_.insert(id);
      pictures.plot = id + ".svg";
    }
    for (const Drawing& drawing : judged.verdict.drawings) {
      pictures.drawings.push_back(fmt::format("{}+{}.svg", id, pictures.drawings.size() + 1));
      write(drawing.svg, "claims/" + pictures.drawings.back());
    }
    const auto releases = data.history.find(id);
    write(claim_page(judged, pictures, releases == data.history.end() ? std::vector<ReleaseEntry>() : releases->second,
                     data.folders),
          fmt::format("claims/{}.md", id));
  }

  void errata(const ReportData& data) {
    if (data.errata.empty()) return;
    std::set<std::string> pages;
    for (const JudgedClaim& judged : data.claims) pages.insert(judged.claim.id);
    write(errata_page(data.errata, pages), "errata.md");
  }

  void limits(const ReportData& data) {
    const std::string page = limits_page(data, plots_);
    if (!page.empty()) write(page, "limits.md");
  }

  fs::path front(const ReportData& data) {
    std::string link, caption;
    if (const auto picture = bias_and_scatter(data.claims)) {
      link = draw(picture->plot, "bias-and-scatter.svg");
      caption = picture->caption;
    }
    return write(front_page(data, earlier_pages(data), link, caption), "README.md");
  }

  /// What an earlier report wrote and this one did not.
  void remove_leftovers() const {
    std::vector<std::string> ids;
    for (const auto& entry : fs::directory_iterator(output_ / "claims"))
      if (entry.path().extension() == ".md" && read_text(entry.path()).starts_with(page_marker))
        ids.push_back(entry.path().stem().string());
    for (const std::string& id : ids) {
      std::vector<std::string> names{"claims/" + id + ".md"};
      for (const char* folder : {"claims/", "checks/"})
        for (const char* extension : {".svg", ".csv"}) names.push_back(folder + id + extension);
      for (int k = 1; fs::exists(output_ / fmt::format("claims/{}+{}.svg", id, k)); ++k)
        names.push_back(fmt::format("claims/{}+{}.svg", id, k));  // '+' is in no id
      for (const std::string& name : names)
        if (!written_.contains(name)) fs::remove(output_ / name);
    }
    for (const char* name : {"errata.md", "limits.md"}) {
      const fs::path page = output_ / name;
      if (!written_.contains(name) && fs::exists(page) && read_text(page).starts_with(page_marker)) fs::remove(page);
    }
    for (const char* name : {"bias-and-scatter.svg", "bias-and-scatter.csv"})
      if (!written_.contains(name)) fs::remove(output_ / name);
  }

 private:
  /// Pages that earlier reports have left on claims which this one is not on.
  [[nodiscard]] std::vector<EarlierPage> earlier_pages(const ReportData& data) const {
    std::vector<EarlierPage> pages;
    for (const Claim& claim : data.others) {
      const fs::path path = output_ / "claims" / (claim.id + ".md");
      const std::string page = fs::exists(path) ? read_text(path) : std::string();
      constexpr std::string_view before = "\n**Verdict: ", after = ".**";
      const std::size_t start = page.find(before), end = page.find(after, start);
      if (page.starts_with(page_marker) && end != std::string::npos)
        pages.push_back({claim.id, page.substr(start + before.size(), end - start - before.size())});
    }
    return pages;
  }

  std::string draw(const Plot& plot, const std::string& name) {
    write_plot(plot, output_ / name);
    written_.insert(name);
    written_.insert(data_file_of(name));
    return name;
  }

  fs::path write(const std::string& text, const std::string& name) {
    write_text_atomically(output_ / name, text);
    written_.insert(name);
    return output_ / name;
  }

  fs::path output_;
  std::set<std::string> written_, plots_;
};

}  // namespace

fs::path write_report(const ReportData& data, const fs::path& output) {
  ReportWriter writer(output);
  for (const JudgedClaim& judged : data.claims) writer.claim(judged, data);
  writer.errata(data);
  writer.limits(data);
  fs::path front = writer.front(data);
  // A report on a part of the claims says nothing of the others' pages.
  if (data.claims.size() >= data.of_claims) writer.remove_leftovers();
  return front;
}

fs::path write_report(const ReportOptions& options) {
  ReportData data = load_report_data(options.tier, options.store, options.reference, options.claims);
  const fs::path history = options.output / "history";
  if (options.release) {
    std::vector<const Verdict*> verdicts;
    for (const JudgedClaim& judged : data.claims) verdicts.push_back(&judged.verdict);
    write_release(verdicts, build_provenance().version, history);
  }
  data.history = load_release_history(history);
  return write_report(data, options.output);
}

}  // namespace gpf
