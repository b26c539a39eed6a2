#include "prs/output/plots.h"

#include <fmt/format.h>

#include <system_error>

#include "prs/output/files.h"
#include "prs/output/gnuplot.h"
#include "prs/output/result_figures.h"

namespace prs {
namespace {

namespace fs = std::filesystem;

std::vector<Figure> figures(const Result& result) {
  std::vector<Figure> all;
  for (const auto make :
       {load_distribution_figure, peak_pressure_figure, stiffness_figure, butterfly_figure})
    if (std::optional<Figure> figure = make(result)) all.push_back(std::move(*figure));
  return all;
}

std::string script_name(const Figure& figure) { return figure.name + ".gp"; }

void remove_images(const Figure& figure, const fs::path& directory) {
  std::error_code ignored;
  for (const char* extension : {".svg", ".png"})
    fs::remove(directory / (figure.name + extension), ignored);
}

void write_scripts(const std::vector<Figure>& figures, const fs::path& directory) {
  std::vector<OutputFile> scripts;
  for (const Figure& figure : figures)
    scripts.push_back({script_name(figure), gnuplot_script(figure)});
  write_files(directory, scripts);
}

/// All figures at the same time.
std::vector<std::string> draw(const std::vector<Figure>& figures, const fs::path& directory) {
  std::vector<GnuplotProcess> processes;
  for (const Figure& figure : figures) processes.emplace_back(directory, script_name(figure));
  std::vector<std::string> notes;
  for (std::size_t k = 0; k < figures.size(); ++k) {
    const std::string complaint = processes[k].wait();
    if (complaint.empty()) continue;
    remove_images(figures[k], directory);
    notes.push_back(fmt::format("{} was not drawn: {}", figures[k].name, complaint));
  }
  return notes;
}

}  // namespace

std::vector<std::string> draw_plots(const Result& result, const fs::path& directory) {
  const std::vector<Figure> all = figures(result);
  if (all.empty()) return {};
  const fs::path plots = directory / "plots";
  write_scripts(all, plots);
  for (const Figure& figure : all) remove_images(figure, plots);
  try {
    return draw(all, plots);
  } catch (const std::system_error& error) {
    return {fmt::format("plots were not drawn: {}; their scripts stand in {}", error.what(),
                        plots.string())};
  }
}

}  // namespace prs
