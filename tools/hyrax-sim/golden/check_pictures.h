// What `check --summary` writes beside the Markdown file: a picture for each cause, and a page.
#pragma once

#include <string>
#include <vector>

#include "tools/hyrax-sim/golden/check_report.h"

namespace hyrax {

/// So many causes get a picture.
inline constexpr std::size_t kPicturesMax = 3;

/// The files that may be written for the summary at `path`, FILE.md: FILE-1.svg and so on, in the order of
/// the groups, then FILE.html.
[[nodiscard]] std::vector<std::string> picture_paths(const std::string& path);

/// Draws both paths of the worst scenario of each of the first groups, and writes the page on which the worst
/// of all can be played, where this program has the page. What cannot be drawn changes no verdict: the text
/// says why.
[[nodiscard]] std::vector<GroupPicture> write_pictures(const CheckReport& report, const std::string& path);

}  // namespace hyrax
