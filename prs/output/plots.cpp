#include "prs/output/plots.h"

#include <fmt/format.h>

#include <span>
#include <system_error>

#include "prs/output/contact_figures.h"
#include "prs/output/files.h"
#include "prs/output/gnuplot.h"
#include "prs/output/result_figures.h"
#include "prs/output/slip_figures.h"

namespace prs {
namespace {

namespace fs = std::filesystem;

using FigureOf = std::optional<Figure> (*)(const Result&);

constexpr FigureOf kLoadFigures[] = {load_distribution_figure, peak_pressure_figure,
                                     stiffness_figure, butterfly_figure};
constexpr FigureOf kContactFigures[] = {contact_section_figure, contact_xy_figure,
                                        contact_ellipse_figure};

std::vector<Figure> figures(std::span<const FigureOf> makers, const Result& result) {
  std::vector<Figure> all;
  for (const FigureOf make : makers)
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

/// Writes the scripts of the figures and has them drawn.
std::vector<std::string> draw_below(const fs::path& directory, const std::vector<Figure>& all) {
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

}  // namespace

std::vector<std::string> draw_plots(const Result& result, const fs::path& directory) {
  return draw_below(directory, figures(kLoadFigures, result));
}

std::vector<std::string> draw_contact_plots(const Result& result, const fs::path& directory) {
  std::vector<std::string> notes = draw_below(directory, figures(kContactFigures, result));
  for (const Interface i : kInterfaces)
    if (!result.contacts.interfaces[i].geometry.ok())
      notes.push_back(fmt::format(
          "pictures of the contacts were not drawn: the {} threads have no contact point ({})",
          label(i), failure(result.contacts, i).reason));
  return notes;
}

std::vector<std::string> draw_figures(const std::vector<Figure>& figures,
                                      const fs::path& directory) {
  return draw_below(directory, figures);
}

std::vector<std::string> draw_slip_plots(
    const Result& result, const std::vector<std::pair<std::size_t, SlipPictures>>& pictures,
    const fs::path& directory) {
  std::vector<Figure> all = power_over_load_figures(result);
  if (std::optional<Figure> figure = thread_power_figure(result)) all.push_back(*figure);
  for (std::size_t k = 0; k < pictures.size(); ++k) {
    const auto& [index, shown] = pictures[k];
    for (const auto make : {slip_patch_figure, slip_residue_figure}) {
      Figure& figure = all.emplace_back(make(result.load_cases[index], shown));
      if (pictures.size() > 1) figure.name += fmt::format("_{}", k + 1);
    }
  }
  return draw_below(directory, all);
}

}  // namespace prs
