#include "support/drawn.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <regex>
#include <sstream>

#include "prs/svg/elements.h"
#include "prs/svg/panel.h"

namespace test {
namespace {

/// Value of an attribute in a tag; empty if there is none.
std::string attribute(const std::string& tag, const std::string& name) {
  const std::size_t at = tag.find(" " + name + "=\"");
  if (at == std::string::npos) return {};
  const std::size_t from = at + name.size() + 3;
  return tag.substr(from, tag.find('"', from) - from);
}

std::string unescaped(std::string text) {
  for (const auto& [mark, letter] :
       {std::pair{"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&#39;", "'"}, {"&amp;", "&"}})
    for (std::size_t at = 0; (at = text.find(mark)) != std::string::npos;)
      text.replace(at, std::string(mark).size(), letter);
  return text;
}

/// First tag that is not closed as required; empty if there is none.
std::string malformed(const std::string& svg) {
  std::vector<std::string> open;
  for (std::size_t at = svg.find("<svg"); (at = svg.find('<', at)) != std::string::npos; ++at) {
    const std::size_t end = svg.find('>', at);
    const std::string tag = svg.substr(at + 1, end - at - 1);
    if (std::ranges::count(tag, '"') % 2 != 0 || tag.find('<') != tag.npos) return tag.substr(0, 99);
    const std::string name = tag.substr(0, tag.find_first_of(" /", 1));
    if (tag.starts_with('/')) {
      if (open.empty() || "/" + open.back() != tag) return tag;
      open.pop_back();
    } else if (!tag.ends_with('/')) {
      open.push_back(name);
    }
  }
  return open.empty() ? "" : open.back();
}

/// Whether an edge of the first text separates it from the second.
bool is_apart(const DrawnText& a, const DrawnText& b) {
  constexpr double kTouch = 1.0;  // Margin in pixels that letters do not reach.
  for (int k = 0; k < 2; ++k) {
    const double x = a.corners[k + 1][0] - a.corners[k][0];
    const double y = a.corners[k + 1][1] - a.corners[k][1];
    double length = std::hypot(x, y), least[2] = {1e9, 1e9}, most[2] = {-1e9, -1e9};
    if (!(length > 0.0)) return true;
    for (const DrawnText* text : {&a, &b})
      for (const auto& corner : text->corners) {
        const double at = (corner[0] * x + corner[1] * y) / length;
        least[text == &b] = std::min(least[text == &b], at);
        most[text == &b] = std::max(most[text == &b], at);
      }
    if (most[0] - kTouch <= least[1] || most[1] - kTouch <= least[0]) return true;
  }
  return false;
}

}  // namespace

std::vector<DrawnText> drawn_texts(const std::string& svg) {
  std::vector<DrawnText> all;
  for (std::size_t at = svg.find("<rect"); (at = svg.find('<', at)) != std::string::npos; ++at) {
    const std::size_t end = svg.find('>', at);
    const std::string tag = svg.substr(at, end - at);
    if (!tag.starts_with("<text ")) continue;
    DrawnText drawn{unescaped(svg.substr(end + 1, svg.find('<', end) - end - 1)), {}};
    const double x = std::stod(attribute(tag, "x")), y = std::stod(attribute(tag, "y"));
    const std::string classes = " " + attribute(tag, "class") + " ";
    const double share = classes.find(" m ") != classes.npos || classes.find(" n ") != classes.npos ? 0.5
                         : classes.find(" e ") != classes.npos                                      ? 1.0
                                                                                                    : 0.0;
    const prs::TextBox box = prs::text_box(drawn.content, x, y, share);
    const std::string turn = attribute(tag, "transform");
    double angle = 0.0, centre_x = x, centre_y = y;
    if (!turn.empty()) std::istringstream(turn.substr(7)) >> angle >> centre_x >> centre_y;
    angle *= 0.017453292519943295;
    const double corners[4][2] = {
        {box.left, box.top}, {box.right, box.top}, {box.right, box.bottom}, {box.left, box.bottom}};
    for (int k = 0; k < 4; ++k) {
      const double dx = corners[k][0] - centre_x, dy = corners[k][1] - centre_y;
      drawn.corners[k][0] = centre_x + std::cos(angle) * dx - std::sin(angle) * dy;
      drawn.corners[k][1] = centre_y + std::sin(angle) * dx + std::cos(angle) * dy;
    }
    all.push_back(drawn);
  }
  return all;
}

void expect_drawn(const std::string& svg) {
  EXPECT_EQ(malformed(svg), "");
  std::smatch size;
  static const std::regex pattern("viewBox=\"0 ([0-9]+) ([0-9]+) ([0-9]+)\"");
  const std::string head = svg.substr(0, 300);
  ASSERT_TRUE(std::regex_search(head, size, pattern)) << head;
  const double top = std::stod(size[1]), right = std::stod(size[2]);
  const double bottom = top + std::stod(size[3]);
  const std::vector<DrawnText> texts = drawn_texts(svg);
  for (std::size_t k = 0; k < texts.size(); ++k) {
    for (const auto& [x, y] : texts[k].corners)
      EXPECT_TRUE(x > -0.5 && x < right + 0.5 && y > top - 0.5 && y < bottom + 0.5)
          << texts[k].content << " leaves the picture at " << x << ", " << y;
    for (std::size_t other = 0; other < k; ++other)
      EXPECT_TRUE(is_apart(texts[k], texts[other]) || is_apart(texts[other], texts[k]))
          << texts[k].content << " covers " << texts[other].content;
  }
}

void expect_drawn(const prs::Figure& figure) {
  SCOPED_TRACE(figure.name);
  expect_drawn(prs::svg_file(figure));
}

void expect_drawn(const std::vector<prs::Figure>& figures) {
  EXPECT_FALSE(figures.empty());
  for (const prs::Figure& figure : figures) expect_drawn(figure);
}

}  // namespace test
