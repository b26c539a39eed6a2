#include "prs/output/files.h"

#include <cstdlib>
#include <system_error>

#include "prs/components/picture.h"
#include "prs/output/run_files.h"
#include "prs/svg/file.h"
#include "prs/text.h"

namespace prs {
namespace {

void publish(const std::filesystem::path& directory, const std::vector<OutputFile>& files) {
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error) throw std::system_error(error, fmt::format("cannot write '{}'", directory.string()));

  std::vector<StagedFile> staged;
  for (const OutputFile& file : files) {
    staged.emplace_back(directory / file.name).append(file.content);
    staged.back().close();
  }
  for (StagedFile& file : staged) file.publish();
}

}  // namespace

void write_files(const std::filesystem::path& directory, const std::vector<OutputFile>& files) {
  publish(directory, files);
  for (const OutputFile& file : files) record_written(directory / file.name);
}

void write_case(const std::filesystem::path& file, const std::string& text) {
  const std::filesystem::path whole = std::filesystem::absolute(file);
  publish(whole.parent_path(), {{whole.filename().string(), text}});
}

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

std::filesystem::path temporary_folder() {
  const char* told = std::getenv("TMPDIR");
  const std::filesystem::path folder = told != nullptr && *told != '\0' ? told : "/tmp";
  std::error_code error;
  if (std::filesystem::is_directory(folder, error) && ::access(folder.c_str(), W_OK | X_OK) == 0)
    return folder;
  throw std::runtime_error(
      fmt::format("TMPDIR: got {}, which is no folder that can be written into; expected one for "
                  "temporary files; set TMPDIR to one, or name a place with --output",
                  printable(folder.string())));
}

}  // namespace prs
