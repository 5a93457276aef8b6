// The page: one HTML file that needs nothing else.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "verify/view/frames.hpp"
#include "verify/view/view_source.hpp"

namespace gpf {

/// Whether this program was built with what pages are drawn with.
bool has_page_parts();
/// Throws InputError when it was not.
void require_page_parts();

/// Runs the frames and puts them into a page. `shown` is told how many are done. Throws what run_frames throws.
std::string view_page(const ViewSource& source, const FramePlan& plan, const std::function<void(int)>& shown);

/// `form` with each @NAME@ replaced by text_of(NAME); what is put in is not looked at again.
std::string filled(std::string_view form, const std::function<std::string(std::string_view)>& text_of);

/// A text as HTML shows it.
std::string html_text(std::string_view text);

}  // namespace gpf
