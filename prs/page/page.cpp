#include "prs/page/page.h"

#include <fmt/ranges.h>
#include <nettle/base64.h>
#include <zlib.h>

#include <cctype>

#include "prs/embed.h"
#include "prs/input/force_history.h"
#include "prs/input/schema.h"
#include "prs/page/live_parts.h"
#include "prs/report/findings.h"
#include "prs/report/tables.h"
#include "prs/run/analyses.h"
#include "prs/run/response_lists.h"
#include "prs/sha256.h"
#include "prs/text.h"
#include "prs/version.h"

PRS_EMBED(page, "prs/page/live/page.html")
PRS_EMBED(panel, "prs/page/live/panel.html")
PRS_EMBED(thread_form, "prs/page/live/thread.html")
PRS_EMBED(scripts, "prs/page/live/scripts.html")
PRS_EMBED(style_sheet, "prs/page/live/page.css")
PRS_EMBED(workbench_frame, "prs/page/live/workbench.html")
PRS_EMBED(workbench_style, "prs/page/live/workbench.css")
PRS_EMBED(loader, "prs/page/live/engine.js")

namespace prs {
namespace {

constexpr std::size_t kLargestLivePage = 2'900'000;  ///< Size in bytes.

/// Space for everything but the engine, and smaller amounts that are tried if the page is too large.
constexpr ReportRoom kRoomsWithEngine[] = {{500'000, 300'000, 150'000}, {200'000, 150'000, 50'000}};

std::string base64(std::string_view bytes) {
  std::string text(BASE64_ENCODE_RAW_LENGTH(bytes.size()), '\0');
  base64_encode_raw(text.data(), bytes.size(), reinterpret_cast<const std::uint8_t*>(bytes.data()));
  return text;
}

/// Number of bytes, then five letters for each four of them, a sixteenth less than base64: the characters from `(` to
/// `|`, but `}` and `~` in place of `<` and the backslash.
std::string base85(std::string_view bytes) {
  std::string text = fmt::format("{} ", bytes.size());
  for (std::size_t k = 0; k < bytes.size(); k += 4) {
    std::uint32_t four = 0;
    for (std::size_t j = k; j < k + 4; ++j)
      four = four << 8 | (j < bytes.size() ? static_cast<std::uint8_t>(bytes[j]) : 0U);
    std::array<char, 5> five;
    for (std::size_t j = 5; j-- > 0; four /= 85) {
      const char letter = static_cast<char>('(' + four % 85);
      five[j] = letter == '<' ? '}' : letter == '\\' ? '~' : letter;
    }
    text.append(five.data(), five.size());
  }
  return text;
}

std::string deflated(std::string_view text) {
  uLongf size = compressBound(text.size());
  std::string packed(size, '\0');
  if (compress2(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(text.data()),
                text.size(), Z_BEST_COMPRESSION) != Z_OK)
    throw std::bad_alloc();
  packed.resize(size);
  return packed;
}

/// Hash by which policies allow the text of a style or a script.
std::string policy_hash(std::string_view text) {
  const std::string digest = sha256(text);
  std::string bytes;
  for (std::size_t k = 0; k < digest.size(); k += 2)
    bytes += static_cast<char>(std::stoi(digest.substr(k, 2), nullptr, 16));
  return "sha256-" + base64(bytes);
}

/// Data in a script element, which may contain neither `<` nor characters that turn the direction of writing.
std::string data_block(const char* id, const Json& json) {
  std::string text;
  for (const char c : printable_json(json.dump(-1, ' ', false, Json::error_handler_t::replace)))
    if (c == '<')
      text += "\\u003c";
    else
      text += c;
  return fmt::format("<script type=\"application/json\" id=\"{}\">{}</script>\n", id, text);
}

Json texts_of(const input::Source& source) {
  Json json{{"file", source.name}, {"yaml", source.text}, {"set", Json::array()}};
  for (const std::string& text : source.overrides) {
    const std::size_t equals = text.find('=');
    json["set"].push_back({text.substr(0, equals), text.substr(equals + 1)});
  }
  return json;
}

/// Case for the engine of the page.
Json case_of(const input::Source& source) {
  const input::CaseInput in = input::read_case_input(source, Command::check);
  Json json = texts_of(source);
  json["histories"] = Json::object();
  if (in.values.life && in.values.life->history)
    json["histories"][in.values.life->history->file] = input::force_history_text(*in.values.life->history, source);
  for (const input::EchoEntry& field : in.fields)
    if (field.path.starts_with("references[") && field.path.ends_with("].file"))
      json["histories"][field.value] = input::named_file_text(field.value, field.path, source);
  return json;
}

/// A text as a string of CSS.
std::string css_string(std::string_view content) {
  std::string text = "\"";
  for (const char c : printable(content)) {
    const auto byte = static_cast<unsigned char>(c);
    text += byte == ' ' || byte >= 0x80 || std::isalnum(byte) != 0 ? std::string(1, c) : fmt::format("\\{:x} ", byte);
  }
  return text + '"';
}

/// Style of the footer of every printed sheet.
std::string sheet_style(const ReportParts& parts) {
  return fmt::format(
      "@page{{@bottom-left{{content:{}}}@bottom-right{{content:\"Sheet \" counter(page) \" of \" "
      "counter(pages)}}}}\n",
      css_string(parts.mark));
}

std::string section_html(const ReportSection& section, bool hidden, std::string_view before = {}) {
  return fmt::format(
      "<section id=\"{0}\" aria-labelledby=\"{0}-title\"{3}>\n<h2 id=\"{0}-title\">{1}</h2>\n{4}"
      "<div class=\"body\">\n{2}</div></section>\n",
      section.id, section.title, section.body, hidden ? " hidden" : "", before);
}

/// Policy that allows a page to run its scripts, of which its own and that of the mechanism are packed in it.
std::string script_policy(const LiveParts& parts, const LiveParts::Packed& own) {
  return fmt::format("; script-src '{}' '{}' '{}' 'wasm-unsafe-eval'; worker-src blob:; connect-src 'none'",
                     policy_hash(parts.start), own.hash, parts.mechanism.hash);
}

/// The style of all pages: their rules, those of pictures and the colours of scales.
std::string style_of_pages() {
  return fmt::format("{}{}:root{{--scale:{}}}\n", style_sheet(), svg_style(), fmt::join(kScaleColours, ","));
}

/// The whole file. Without `live` it has no scripts, and gives the reason if `still` does.
std::string page_html(const input::Source& source, const ReportParts& parts, const LiveParts* live,
                      std::string_view still = {}) {
  const std::string style = style_of_pages() + sheet_style(parts);
  const std::string panel_or_reason =
      live            ? fmt::format(fmt::runtime(panel()), parts.controls)
      : still.empty() ? ""
                      : fmt::format("<p id=\"static\">This page is static: {}.</p>\n", prose_html(still));
  std::string links, body;
  const auto add = [&](const ReportSection& section, bool hidden, std::string_view before = {}) {
    links += fmt::format("<li{}><a href=\"#{}\">{}</a></li>", hidden ? " hidden" : "", section.id, section.title);
    body += section_html(section, hidden, before);
  };
  for (const ReportSection& section : parts.sections) {
    if (!section.body.empty() || live) add(section, section.body.empty());
    if (live && section.id == "pressures") add({"thread", "One thread", ""}, true, thread_form());
  }
  std::string data = data_block("data", parts.shown);
  if (live)
    data += data_block("case", case_of(source)) + data_block("threads", parts.threads) +
            fmt::format(fmt::runtime(scripts()), loader(), live->worker, base85(live->engine),
                        base85(live->report.script), base85(live->mechanism.script), live->start);
  const std::string policy = live ? script_policy(*live, live->report) : "";
  return fmt::format(
      fmt::runtime(page()), fmt::arg("units", table_system() == UnitSystem::us ? " data-units=\"us\"" : ""),
      fmt::arg("style_hash", policy_hash(style)), fmt::arg("scripts", policy), fmt::arg("title", html(parts.title)),
      fmt::arg("style", style), fmt::arg("changed", live ? "<p id=\"changed\" hidden></p>\n" : ""),
      fmt::arg("kind", live                         ? " is-live"
                       : parts.sections.size() == 1 ? " is-summary"
                                                    : ""),
      fmt::arg("head", parts.head), fmt::arg("links", links),
      // Shown by the script only.
      fmt::arg("panel", panel_or_reason), fmt::arg("body", body), fmt::arg("foot", parts.foot), fmt::arg("data", data));
}

}  // namespace

std::string workbench_page(const LiveParts& parts, const std::optional<input::Source>& opened,
                           const std::vector<NamedText>& texts) {
  Json data{{"version", kVersion},
            {"schemas", {{"case", input::schema()}}},
            {"units", us_units_json()},
            {"lubricants", lubricants_json()["lubricants"]},
            {"responses", responses_json(known_responses())["responses"]},
            {"commands", Json::array()},
            {"sections", Json::array()},
            {"lessons", Json::array()},
            {"opened", nullptr}};
  for (const OtherFile& file : other_files()) {
    data["schemas"][std::string(file.name)] = file.schema();
    data["commands"].push_back({{"name", name(file.command)}, {"help", file.help}, {"key", file.key}});
  }
  for (const AnyAnalysis& row : analyses())
    if (row.run) data["commands"].push_back({{"name", name(row.command)}, {"help", row.help}});
  for (const SectionRow& row : section_rows()) data["sections"].push_back({{"id", row.id}, {"title", row.title}});
  for (const NamedText& text : texts)
    data["lessons"].push_back({{"name", text.name}, {"title", text.title}, {"text", text.text}});
  if (opened) data["opened"] = texts_of(*opened);
  const std::string style = style_of_pages() + std::string(workbench_style());
  return fmt::format(fmt::runtime(workbench_frame()), fmt::arg("style_hash", policy_hash(style)),
                     fmt::arg("scripts", script_policy(parts, parts.workbench)), fmt::arg("style", style),
                     fmt::arg("loader", loader()), fmt::arg("worker", parts.worker),
                     fmt::arg("engine", base85(parts.engine)), fmt::arg("mechanism", base85(parts.mechanism.script)),
                     fmt::arg("data", base85(deflated(data.dump(-1, ' ', false, Json::error_handler_t::replace)))),
                     fmt::arg("script", base85(parts.workbench.script)), fmt::arg("start", parts.start));
}

Report make_report(const input::Source& source, const PageOptions& options) {
  const bool asked_live = options.live && !options.summary && !other_file(source);
  const LiveParts live = asked_live ? read_live_parts(options.live_parts) : LiveParts{};
  ReportOptions asked{.command = options.command, .results = options.results, .summary = options.summary};
  const auto report = [](std::string page, ReportParts parts) {
    return Report{std::move(page), std::move(parts.data), std::move(parts.notes), parts.converged};
  };
  std::string still = live.absent;
  if (asked_live && still.empty()) {
    std::size_t size = 0;
    for (const ReportRoom& room : kRoomsWithEngine) {
      asked.room = room;
      ReportParts parts = report_parts(source, asked);
      std::string page = page_html(source, parts, &live);
      size = page.size();
      if (size <= kLargestLivePage) return report(std::move(page), std::move(parts));
    }
    still = fmt::format(
        "with the engine, the file and its force history it would have {} kB; expected at most {} kB; shorten "
        "the file or the history",
        (size + 999) / 1000, kLargestLivePage / 1000);
  }
  asked.room = {};
  ReportParts parts = report_parts(source, asked);
  if (!still.empty()) parts.notes.push_back("the page is static: " + still);
  std::string page = page_html(source, parts, nullptr, still);
  return report(std::move(page), std::move(parts));
}

}  // namespace prs
