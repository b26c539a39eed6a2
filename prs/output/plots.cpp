#include "prs/output/plots.h"

#include <utility>

#include "prs/components/picture.h"
#include "prs/output/files.h"
#include "prs/svg/file.h"

namespace prs {

void draw_figures(const std::vector<Figure>& figures, const std::filesystem::path& directory,
                  bool png) {
  constexpr double kPngScale = 2.0;
  std::vector<OutputFile> files;
  for (const Figure& figure : figures) {
    std::string svg = svg_file(figure);
    if (png)
      files.push_back({figure.name + ".png", modules::loaded<PictureModule>().png(svg, kPngScale)});
    files.push_back({figure.name + ".svg", std::move(svg)});
  }
  if (!files.empty()) write_files(directory / "plots", files);
}

}  // namespace prs
