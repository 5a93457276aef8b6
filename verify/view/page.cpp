#include "verify/view/page.hpp"

#include <fmt/format.h>

#include "gpf/base/error.hpp"
#include "gpf_view_parts.hpp"  // generated: the files of verify/view/page, and uPlot's
#include "verify/view/page_data.hpp"

namespace gpf {

bool has_page_parts() { return !view_parts::plot_script.empty(); }

void require_page_parts() {
  if (!has_page_parts())
    throw InputError("this gpf cannot write pages", "it was built without the plotting library uPlot",
                     "install npm, configure again with -D GPF_VIEW=ON and build; --svg and --movie need none of that");
}

std::string html_text(std::string_view text) {
  std::string result;
  for (const char c : text) switch (c) {
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '&':
        result += "&amp;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\'':
        result += "&#39;";
        break;
      default:
        result += c;
    }
  return result;
}

std::string filled(std::string_view form, const std::function<std::string(std::string_view)>& text_of) {
  std::string result;
  while (true) {
    const std::size_t open = form.find('@');
    if (open == std::string_view::npos) return result.append(form);
    const std::size_t close = form.find('@', open + 1);
    if (close == std::string_view::npos) return result.append(form);
    result.append(form.substr(0, open)).append(text_of(form.substr(open + 1, close - open - 1)));
    form.remove_prefix(close + 1);
  }
}

std::string view_page(const ViewSource& source, const FramePlan& plan, const std::function<void(int)>& shown) {
  PackedFrames frames(source.scene, source.run.bins, source.run.density_modes);
  int count = 0;
  const std::uint64_t hash = run_frames(source.scene, source.start, plan, [&](const Snapshot& frame) {
    frames.add(frame.state);
    shown(++count);
  });
  return filled(view_parts::form, [&](std::string_view name) -> std::string {
    if (name == "TITLE") return html_text(source.name);
    if (name == "PLOT_LICENCE") return std::string(view_parts::plot_licence);
    if (name == "PLOT_STYLE") return std::string(view_parts::plot_style);
    if (name == "PLOT_SCRIPT") return std::string(view_parts::plot_script);
    if (name == "STYLE") return std::string(view_parts::style);
    if (name == "SCRIPT") return std::string(view_parts::script);
    if (name == "DATA") return page_data(source, frames, plan.interval, hash);
    throw InputError(fmt::format("the form of the page asks for '{}'", name), "there is no such part",
                     "this is a bug: report it");
  });
}

}  // namespace gpf
