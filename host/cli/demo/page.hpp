// The page of `quell demo`: one HTML file with all pictures in it, to be opened in any browser without a network.
#pragma once

#include <quell/image_view.hpp>
#include <string>
#include <vector>

namespace quell::cli {

/// host/cli/demo/page.html, where DEMO_DATA stands for what is shown.
extern const char* const kDemoPageTemplate;

/// One frame: a comparison sheet (see comparisonSheet()) as a PNG file.
struct DemoSheet {
  int number = 0;    ///< frame
  int panes = 0;     ///< pictures side by side: 2, or 3 with a reference
  std::string path;  ///< of the PNG
  std::size_t bytes = 0;
};

struct DemoPage {
  std::string title;
  std::string subtitle;
  std::string report;              ///< preformatted text
  Size size;                       ///< of one picture
  std::vector<std::string> panes;  ///< what is side by side on a sheet, from the left
  std::vector<DemoSheet> sheets;
};

/// PNG bytes on a page: enough for an animation, small enough to send around.
constexpr std::size_t kMostPageBytes = 16u << 20;

/// Every k-th sheet and the last, with the smallest k >= 1 for which they take at most `mostBytes` together; one at
/// least.
std::vector<DemoSheet> sheetsWithin(const std::vector<DemoSheet>& sheets, std::size_t mostBytes);

/// The page as text, with the sheets that fit into kMostPageBytes. Throws Error(FileError) if a sheet cannot be read.
std::string makeDemoPage(const DemoPage& page);

}  // namespace quell::cli
