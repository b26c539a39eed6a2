#include "prs/embed.h"
#include "prs/export/system_model.h"
#include "prs/version.h"

PRS_EMBED(modelica_functions, PRS_UNIT_SOURCES "/curves.mo")

namespace prs {
namespace {

constexpr std::size_t kNumbersPerLine = 4;

std::string numbers(const std::vector<double>& values) {
  std::string text = "{";
  for (std::size_t k = 0; k < values.size(); ++k)
    text += fmt::format("{}{:.17g}",
                        k == 0                     ? ""
                        : k % kNumbersPerLine == 0 ? ",\n      "
                                                   : ", ",
                        values[k]);
  return text + "}";
}

/// Rows of one matrix.
std::string rows(const std::vector<double>& values, std::size_t columns) {
  if (values.empty()) return "fill(0.0, 0, 0)";
  std::string text = "{";
  for (std::size_t k = 0; k < values.size(); k += columns)
    text += (k == 0 ? "" : ",\n      ") +
            numbers({values.begin() + static_cast<std::ptrdiff_t>(k),
                     values.begin() + static_cast<std::ptrdiff_t>(k + columns)});
  return text + "}";
}

std::string branch(const BranchTable& table, std::string_view name) {
  return fmt::format(
      "    constant Real {0}_origin(unit = \"m\") = {1:.17g} \"Where the force begins\";\n"
      "    constant Boolean {0}_root = {2} \"Nodes over the root of the way, else over the way\";\n"
      "    constant Real {0}_at[:] = {3};\n"
      "    constant Real {0}_force[:](each unit = \"N\") = {4};\n"
      "    constant Real {0}_slope[:] = {5};\n",
      name, table.origin, table.over_root, numbers(table.at), numbers(table.force),
      numbers(table.slope));
}

std::string friction(const FrictionTable& table) {
  const std::size_t columns = table.root_force.size();
  const auto list = [](const std::vector<double>& values) {
    return values.empty() ? std::string("fill(0.0, 0)") : numbers(values);
  };
  return fmt::format(
      "    constant Real root_force[:] = {} \"Signed roots of the forces\";\n"
      "    constant Real slowest[:](each unit = \"rad/s\") = {};\n"
      "    constant Real forward[:, :](each unit = \"N.m\") = {} \"A row per speed\";\n"
      "    constant Real backward[:, :](each unit = \"N.m\") = {};\n",
      list(table.root_force), list(table.speed), rows(table.forward, columns),
      rows(table.backward, columns));
}

/// As a text of Modelica holds it.
std::string quoted(const std::string& text) {
  std::string escaped;
  for (const char c : input::shown(text)) {
    if (c == '"' || c == '\\') escaped += '\\';
    escaped += c;
  }
  return escaped;
}

}  // namespace

std::string modelica_package(const SystemCurves& curves, const ModelText& text) {
  std::string package = fmt::format(
      "within ;\npackage {} \"Planetary roller screw of {}\"\n  extends Modelica.Icons.Package;\n"
      "  // Made by prs {} of a case with the SHA-256 {}.\n  // {}\n",
      text.name, quoted(text.case_file), kVersion, text.case_sha256, curves_text(curves));
  if (!curves.load_case.empty())
    package += fmt::format("  // Under the conditions of the load case {}.\n",
                           input::shown(curves.load_case));
  for (const std::string& warning : sentences(curves.warnings))
    package += fmt::format("  // {}\n", warning);
  package += fmt::format(
      "\n  package Data \"Nodes of the curves\"\n    extends Modelica.Icons.Package;\n"
      "    constant Real lead(unit = \"m\") = {:.17g};\n",
      curves.lead);
  package += branch(curves.senses.tension, "tension");
  package += branch(curves.senses.compression, "compression");
  package += friction(curves.friction);
  package += "  end Data;\n\n";
  package += modelica_functions();
  return package +
         fmt::format("  annotation (uses(Modelica(version = \"4.0.0\")));\nend {};\n", text.name);
}

}  // namespace prs
