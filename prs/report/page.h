#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace prs {

/// A section of the page; empty ones are left out.
struct PageSection {
  std::string id;
  std::string title;
  std::string body;  ///< HTML.
};

struct Page {
  std::string title;  ///< Text.
  std::string head;   ///< HTML above the sections.
  std::vector<PageSection> sections;
  std::string foot;
  std::string data;  ///< JSON.
};

/// The whole file: it asks for nothing from anywhere, and its policy lets it ask for nothing.
std::string page_html(const Page& page);

/// A link by which the browser saves a text as a file.
std::string download_link(std::string_view name, std::string_view type, std::string_view content);

/// A picture in the page.
std::string embedded_svg(std::string_view svg, std::string_view title);

}  // namespace prs
