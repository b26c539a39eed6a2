#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace prs {

/// An image of few colours, row by row from above.
struct Image {
  std::size_t width = 0, height = 0;
  std::vector<std::string> colours = {};  ///< `#rrggbb`, at most 255.
  std::string pixels = {};                ///< 0: transparent, else the index of the colour plus 1.
};

/// The image as a PNG file.
std::string png(const Image& image);

/// The PNG file as an address: `data:image/png;base64,..`.
std::string png_address(const Image& image);

}  // namespace prs
