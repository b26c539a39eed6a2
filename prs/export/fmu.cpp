#include <fmt/format.h>

#include <bit>
#include <cstdint>

#include "prs/embed.h"
#include "prs/export/system_model.h"
#include "prs/export/zip.h"
#include "prs/report/svg.h"
#include "prs/sha256.h"
#include "prs/version.h"

PRS_EMBED(curves_h, PRS_UNIT_SOURCES "/curves.h")
PRS_EMBED(curves_c, PRS_UNIT_SOURCES "/curves.c")
PRS_EMBED(fmi2_h, PRS_UNIT_SOURCES "/fmi2.h")
PRS_EMBED(description, PRS_UNIT_SOURCES "/modelDescription.xml")
PRS_EMBED(unit_c, PRS_UNIT_SOURCES "/unit.c")
PRS_EMBED(licence, PRS_LICENCE)
PRS_EMBED(library, PRS_UNIT_LIBRARY)

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

/// Variables have the order of the value references in unit.c.
std::string description_xml(const SystemCurves& curves, const ModelText& text,
                            const std::string& guid) {
  return fmt::format(fmt::runtime(description()), fmt::arg("name", text.name),
                     fmt::arg("guid", guid), fmt::arg("file", html(text.case_file)),
                     fmt::arg("sha", text.case_sha256), fmt::arg("version", kVersion),
                     fmt::arg("range", html(curves_text(curves))));
}

std::string documentation(const SystemCurves& curves, const ModelText& text) {
  std::string page = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><meta "
      "charset=\"utf-8\"><title>{0}</title>\n<h1>{0}</h1>\n"
      "<p>Planetary roller screw of {1}, SHA-256 {2}, by prs {3}.</p>\n<p>{4}</p>\n",
      text.name, html(text.case_file), text.case_sha256, kVersion, html(curves_text(curves)));
  if (!curves.load_case.empty())
    page +=
        fmt::format("<p>Under the conditions of the load case {}.</p>\n", html(curves.load_case));
  for (const std::string& warning : sentences(curves.warnings))
    page += fmt::format("<p>{}</p>\n", html(warning));
  return page +
         "<p>Other platforms: compile the files of <code>sources</code> into one shared library, "
         "for several units in one program with "
         "<code>-DFMI2_FUNCTION_PREFIX=NAME_</code>.</p>\n</html>\n";
}

/// Made of the content, in the form of a GUID.
std::string guid_of(const std::string& content) {
  const std::string hash = sha256(content);
  return fmt::format("{{{}-{}-{}-{}-{}}}", hash.substr(0, 8), hash.substr(8, 4), hash.substr(12, 4),
                     hash.substr(16, 4), hash.substr(20, 12));
}

}  // namespace

std::string functional_mockup_unit(const SystemCurves& curves, const ModelText& text) {
  const std::string data = bytes_of(curves.data());
  const std::string guid =
      guid_of(description_xml(curves, text, "") + data + std::string(library()));
  std::vector<OutputFile> files{{"modelDescription.xml", description_xml(curves, text, guid)}};
#if defined(__x86_64__) && defined(__linux__)  // The standard has names for few platforms.
  files.push_back({fmt::format("binaries/linux64/{}.so", text.name), std::string(library())});
#endif
  files.push_back({"documentation/index.html", documentation(curves, text)});
  const auto add = [&](const char* name, std::string_view content) {
    files.push_back({name, std::string(content)});
  };
  add("documentation/licenses/license.txt", licence());
  add("resources/curves.bin", data);
  add("resources/guid.txt", guid);
  add("sources/curves.c", curves_c());
  add("sources/curves.h", curves_h());
  add("sources/fmi2.h", fmi2_h());
  add("sources/unit.c", unit_c());
  return zip(files);
}

}  // namespace prs
