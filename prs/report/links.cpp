#include <fmt/format.h>

#include "prs/report/report.h"
#include "prs/report/svg.h"

namespace prs {
namespace {

/// A text as a URL has it; the page escapes quotes and markup besides.
std::string data_url(std::string_view type, std::string_view content) {
  std::string url = fmt::format("data:{};charset=utf-8,", type);
  for (const char c : content) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte <= 0x20 || byte >= 0x7f ||
        std::string_view("%#\"'<>&\\^`{|}").find(c) != std::string_view::npos)
      url += fmt::format("%{:02X}", byte);
    else
      url += c;
  }
  return url;
}

}  // namespace

std::string download_link(std::string_view name, std::string_view type, std::string_view content) {
  return fmt::format("<a download=\"{0}\" href=\"{1}\">{0}</a>", html(name),
                     data_url(type, content));
}

}  // namespace prs
