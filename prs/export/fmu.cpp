#include "prs/export/fmu.h"

#include <sstream>

#include "modules/response/response.h"
#include "prs/embed.h"
#include "prs/export/zip.h"
#include "prs/report/report.h"
#include "prs/sha256.h"
#include "prs/version.h"

PRS_EMBED(drive_h, "modules/drive/drive.h")
PRS_EMBED(drive_c, "modules/drive/drive.c")
PRS_EMBED(dormand_prince_h, "modules/drive/dormand_prince.h")
PRS_EMBED(dormand_prince_c, "modules/drive/dormand_prince.c")
PRS_EMBED(curves_h, "modules/drive/curves.h")
PRS_EMBED(curves_c, "modules/drive/curves.c")
PRS_EMBED(fmi2_h, "prs/export/fmi2.h")
PRS_EMBED(description, "prs/export/modelDescription.xml")
PRS_EMBED(drive_variables, "prs/export/drive_variables.txt")
PRS_EMBED(unit_c, "prs/export/unit.c")
PRS_EMBED(licence, "LICENSE")
PRS_EMBED(library, "prs_unit.so")
PRS_EMBED(windows_library, "prs_unit.dll")
PRS_EMBED(modelica_functions, "prs/export/curves.mo")

namespace prs {
namespace {

/// Numbers as little-endian bytes.
std::string bytes_of(const std::vector<double>& numbers) {
  std::string bytes;
  for (const double number : numbers) {
    const auto bits = std::bit_cast<std::uint64_t>(number);
    for (int k = 0; k < 64; k += 8) bytes += static_cast<char>((bits >> k) & 0xff);
  }
  return bytes;
}

/// The variables of a drive in place of those of the screw alone: rows of drive_variables.txt, whose references are
/// those of unit.c.
std::string with_drive(std::string xml, const ResponseInput& in, double reach) {
  const auto& controller = in.motor.controller;
  const bool of_position = controller && controller->position;
  const auto stands = [&](std::string_view when) {
    return when == "all" || (when == (in.load.linkage ? "lever" : "along")) || (when == "torque" && in.motor.torque) ||
           (when == "speed" && in.motor.speed) || (when == "speed_loop" && controller && !of_position) ||
           (when == "position_loop" && of_position) ||
           (when == "feed_forward" && of_position && controller->speed_feed_forward);
  };
  std::string list, outputs;
  int index = 0;
  std::istringstream rows{std::string(drive_variables())};
  for (std::string row; std::getline(rows, row);) {
    std::vector<std::string> cells;
    std::istringstream parts(row);
    for (std::string cell; std::getline(parts, cell, '|');) cells.push_back(cell);
    if (!stands(cells[0])) continue;
    ++index;
    const bool is_input = cells[1] == "input";
    const double start = cells[3] == "motor_speed"                ? in.start.speed / reach
                         : cells[3] == "reference" && of_position ? in.start.position
                                                                  : 0.0;
    list += fmt::format(
        "    <ScalarVariable name=\"{}\" valueReference=\"{}\" causality=\"{}\" variability=\"continuous\"{} "
        "description=\"{}\"><Real unit=\"{}\"{}/></ScalarVariable>\n",
        cells[3], cells[2], cells[1], is_input ? "" : " initial=\"calculated\"", cells[5], cells[4],
        is_input ? fmt::format(" start=\"{:.17g}\"", start) : "");
    if (!is_input) outputs += fmt::format("    <Unknown index=\"{}\"/>\n", index);
  }
  const auto replace = [&](std::string_view from, std::string_view to, const std::string& content) {
    const std::size_t first = xml.find(from) + from.size();
    xml.replace(first, xml.find(to) - first, content);
  };
  replace("<ModelVariables>\n", "  </ModelVariables>", list);
  replace("<Outputs>\n", "    </Outputs>", outputs);
  replace("<InitialUnknowns>\n", "    </InitialUnknowns>", outputs);
  const std::string_view units = "<UnitDefinitions>\n";
  xml.insert(xml.find(units) + units.size(),
             "    <Unit name=\"m/s\"><BaseUnit m=\"1\" s=\"-1\"/></Unit>\n"
             "    <Unit name=\"m/s2\"><BaseUnit m=\"1\" s=\"-2\"/></Unit>\n"
             "    <Unit name=\"rad\"><BaseUnit rad=\"1\"/></Unit>\n");
  return xml;
}

std::string description_xml(const SystemModel& model, const std::string& guid) {
  const SystemCurves& curves = model.curves;
  const ModelText& text = model.text;
  std::string xml = fmt::format(
      fmt::runtime(description()), fmt::arg("name", text.name), fmt::arg("guid", guid),
      fmt::arg("file", html(text.case_file)), fmt::arg("sha", text.case_sha256), fmt::arg("version", kVersion),
      fmt::arg("stop", model.drive ? model.drive->duration : 1.0),
      fmt::arg("step", model.drive ? model.drive->interval() : 1e-3), fmt::arg("range", html(curves_text(curves))));
  return model.drive ? with_drive(std::move(xml), *model.drive, curves.lead / (2.0 * std::numbers::pi)) : xml;
}

/// Numbers of the drive and the accuracy of its events [s].
std::vector<double> drive_numbers(const SystemModel& model) {
  PrsDrive drive = drive_of(*model.case_with_drive, *model.drive, model.curves);
  std::vector<double> numbers(PRS_DRIVE_NUMBERS);
  prs_drive_numbers(&drive, numbers.data(), 1);
  numbers.push_back(1e-12 * model.drive->duration);
  return numbers;
}

std::string documentation(const SystemCurves& curves, const ModelText& text) {
  std::string page = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><meta "
      "charset=\"utf-8\"><title>{0}</title>\n<h1>{0}</h1>\n"
      "<p>Planetary roller screw of {1}, SHA-256 {2}, by prs {3}.</p>\n<p>{4}</p>\n",
      text.name, html(text.case_file), text.case_sha256, kVersion, html(curves_text(curves)));
  if (!curves.load_case.empty())
    page += fmt::format("<p>Under the conditions of the load case {}.</p>\n", html(curves.load_case));
  for (const std::string& warning : sentences(curves.warnings)) page += fmt::format("<p>{}</p>\n", html(warning));
  return page +
         "<p>Other platforms: compile the files of <code>sources</code> into one shared library, "
         "for several units in one program with "
         "<code>-DFMI2_FUNCTION_PREFIX=NAME_</code>.</p>\n</html>\n";
}

/// A GUID computed from the content.
std::string guid_of(const std::string& content) {
  const std::string hash = sha256(content);
  return fmt::format("{{{}-{}-{}-{}-{}}}", hash.substr(0, 8), hash.substr(8, 4), hash.substr(12, 4), hash.substr(16, 4),
                     hash.substr(20, 12));
}

constexpr std::size_t kNumbersPerLine = 4;

std::string numbers(const std::vector<double>& values) {
  std::string text = "{";
  for (std::size_t k = 0; k < values.size(); ++k)
    text += fmt::format("{}{:.17g}", k == 0 ? "" : k % kNumbersPerLine == 0 ? ",\n      " : ", ", values[k]);
  return text + "}";
}

/// Rows of one matrix.
std::string rows(const std::vector<double>& values, std::size_t columns) {
  if (values.empty()) return "fill(0.0, 0, 0)";
  std::string text = "{";
  for (std::size_t k = 0; k < values.size(); k += columns)
    text += (k == 0 ? "" : ",\n      ") + numbers({values.begin() + static_cast<std::ptrdiff_t>(k),
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
      name, table.origin, table.over_root, numbers(table.at), numbers(table.force), numbers(table.slope));
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
      list(table.root_force), list(table.speed), rows(table.forward, columns), rows(table.backward, columns));
}

/// A string literal of Modelica.
std::string quoted(const std::string& text) {
  std::string escaped;
  for (const char c : input::shown(text)) {
    if (c == '"' || c == '\\') escaped += '\\';
    escaped += c;
  }
  return escaped;
}

}  // namespace

std::string functional_mockup_unit(const SystemModel& model) {
  const SystemCurves& curves = model.curves;
  const ModelText& text = model.text;
  const std::string data = bytes_of(curves.data());
  const std::string drive = model.drive ? bytes_of(drive_numbers(model)) : std::string();
  const std::string guid =
      guid_of(description_xml(model, "") + data + drive + std::string(library()) + std::string(windows_library()));
  std::vector<OutputFile> files{{"modelDescription.xml", description_xml(model, guid)}};
#if defined(__x86_64__) && defined(__linux__)  // The standard names only a few platforms.
  files.push_back({fmt::format("binaries/linux64/{}.so", text.name), std::string(library())});
#endif
  if (!windows_library().empty())
    files.push_back({fmt::format("binaries/win64/{}.dll", text.name), std::string(windows_library())});
  files.push_back({"documentation/index.html", documentation(curves, text)});
  const auto add = [&](const char* name, std::string_view content) { files.push_back({name, std::string(content)}); };
  add("documentation/licenses/license.txt", licence());
  add("resources/curves.bin", data);
  if (model.drive) add("resources/drive.bin", drive);
  add("resources/guid.txt", guid);
  add("sources/curves.c", curves_c());
  add("sources/curves.h", curves_h());
  add("sources/dormand_prince.c", dormand_prince_c());
  add("sources/dormand_prince.h", dormand_prince_h());
  add("sources/drive.c", drive_c());
  add("sources/drive.h", drive_h());
  add("sources/fmi2.h", fmi2_h());
  add("sources/unit.c", unit_c());
  return zip(files);
}

std::string modelica_package(const SystemCurves& curves, const ModelText& text) {
  std::string package = fmt::format(
      "within ;\npackage {} \"Planetary roller screw of {}\"\n  extends Modelica.Icons.Package;\n"
      "  // Made by prs {} of a case with the SHA-256 {}.\n  // {}\n",
      text.name, quoted(text.case_file), kVersion, text.case_sha256, curves_text(curves));
  if (!curves.load_case.empty())
    package += fmt::format("  // Under the conditions of the load case {}.\n", input::shown(curves.load_case));
  for (const std::string& warning : sentences(curves.warnings)) package += fmt::format("  // {}\n", warning);
  package += fmt::format(
      "\n  package Data \"Nodes of the curves\"\n    extends Modelica.Icons.Package;\n"
      "    constant Real lead(unit = \"m\") = {:.17g};\n",
      curves.lead);
  package += branch(curves.senses.tension, "tension");
  package += branch(curves.senses.compression, "compression");
  package += friction(curves.friction);
  package += "  end Data;\n\n";
  package += modelica_functions();
  return package + fmt::format("  annotation (uses(Modelica(version = \"4.0.0\")));\nend {};\n", text.name);
}

}  // namespace prs
