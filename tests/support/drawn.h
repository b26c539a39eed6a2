#pragma once

#include <string>
#include <vector>

#include "prs/record/figure.h"

namespace test {

/// A text of a picture, by its corners, in pixels from the upper left.
struct DrawnText {
  std::string content;
  double corners[4][2];
};

std::vector<DrawnText> drawn_texts(const std::string& svg);

/// Fails if the picture is not a well-formed file, if one of its texts covers another or if one leaves the picture.
void expect_drawn(const std::string& svg);
void expect_drawn(const prs::Figure& figure);
void expect_drawn(const std::vector<prs::Figure>& figures);

}  // namespace test
