#include "prs/output/plots.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <string_view>
#include <system_error>

#include "prs/output/files.h"
#include "prs/output/gnuplot.h"
#include "prs/output/gnuplot_script.h"
#include "prs/output/run_files.h"
#include "prs/output/unfinished.h"

namespace prs {
namespace {

namespace fs = std::filesystem;

constexpr const char* kImageTypes[] = {".svg", ".png"};

std::string script_name(const Figure& figure) { return figure.name + ".gp"; }

void remove_images(const Figure& figure, const fs::path& directory) {
  std::error_code ignored;
  for (const char* type : kImageTypes) fs::remove(directory / (figure.name + type), ignored);
}

void write_scripts(const std::vector<Figure>& figures, const fs::path& directory) {
  std::vector<OutputFile> scripts;
  for (const Figure& figure : figures)
    scripts.push_back({script_name(figure), gnuplot_script(figure)});
  write_files(directory, scripts);
}

/// A folder inside another for the images of figures; gone with the object, and what is in it.
class StagingFolder {
 public:
  StagingFolder(const fs::path& parent, const std::vector<Figure>& figures) {
    const SignalsHeld held;
    for (int attempt = 0; path_.empty(); ++attempt) {
      const fs::path path = parent / fmt::format("pictures.{}-{}.tmp", ::getpid(), attempt);
      if (::mkdir(path.c_str(), 0777) == 0)
        path_ = path;
      else if (errno != EEXIST)
        throw std::system_error(errno, std::generic_category(),
                                fmt::format("cannot write '{}'", path.string()));
    }
    unfinished_.emplace_back(path_);
    for (const Figure& figure : figures)
      for (const char* type : kImageTypes) unfinished_.emplace_back(path_ / (figure.name + type));
  }
  StagingFolder(const StagingFolder&) = delete;
  StagingFolder& operator=(const StagingFolder&) = delete;
  ~StagingFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }

  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
  std::vector<UnfinishedPath> unfinished_;
};

/// Whether a picture ends as its format does; gnuplot does not say that a disk was full.
bool is_whole(const fs::path& image) {
  constexpr std::string_view kSvgEnd = "</svg>";
  constexpr std::string_view kPngEnd("\0\0\0\0IEND\xAE\x42\x60\x82", 12);
  std::string bytes(64, '\0');
  std::ifstream file(image, std::ios::binary | std::ios::ate);
  const auto size = static_cast<std::streamoff>(file.tellg());
  file.seekg(std::max<std::streamoff>(0, size - static_cast<std::streamoff>(bytes.size())));
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(file.gcount()));
  if (image.extension() == ".png") return bytes.ends_with(kPngEnd);
  bytes.resize(bytes.find_last_not_of(" \r\n") + 1);
  return bytes.ends_with(kSvgEnd);
}

/// Moves the images of a figure between folders; why that does not work, else empty.
std::string publish_images(const Figure& figure, const fs::path& from, const fs::path& to) {
  for (const char* type : kImageTypes)
    if (const std::string image = figure.name + type; !is_whole(from / image))
      return fmt::format(
          "cannot write '{}': gnuplot left it incomplete, as on a full disk; make "
          "space and run again",
          (to / image).string());
  for (const char* type : kImageTypes) {
    const std::string image = figure.name + type;
    std::error_code error;
    fs::rename(from / image, to / image, error);
    if (error) return fmt::format("cannot write '{}': {}", (to / image).string(), error.message());
    record_written(to / image);
  }
  return {};
}

/// All figures at the same time, aside, so that nobody meets half a picture.
std::vector<std::string> draw(const std::vector<Figure>& figures, const fs::path& directory) {
  const StagingFolder staging(directory, figures);
  std::vector<GnuplotProcess> processes;
  for (const Figure& figure : figures)
    processes.emplace_back(staging.path(), "../" + script_name(figure));
  std::vector<std::string> errors;
  for (std::size_t k = 0; k < figures.size(); ++k) {
    std::string error = processes[k].wait();
    if (!error.empty())
      error = fmt::format("{} was not drawn: {}", figures[k].name, error);
    else
      error = publish_images(figures[k], staging.path(), directory);
    if (error.empty()) continue;
    remove_images(figures[k], directory);
    errors.push_back(std::move(error));
  }
  return errors;
}

}  // namespace

Undrawn draw_figures(const std::vector<Figure>& figures, const fs::path& directory) {
  if (figures.empty()) return {};
  const fs::path plots = directory / "plots";
  write_scripts(figures, plots);
  for (const Figure& figure : figures) remove_images(figure, plots);
  try {
    return {{}, draw(figures, plots)};
  } catch (const std::system_error& error) {
    const std::string text = fmt::format("plots were not drawn: {}; their scripts stand in {}",
                                         error.what(), plots.string());
    if (error.code() == std::errc::no_such_file_or_directory) return {{text}, {}};
    return {{}, {text}};
  }
}

}  // namespace prs
