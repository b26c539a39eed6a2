#include "prs/page/page.h"

#include <nettle/base64.h>

#include <array>
#include <cctype>
#include <cstdint>

#include "prs/input/force_history.h"
#include "prs/input/reader.h"
#include "prs/report/svg.h"
#include "prs/run/commands.h"
#include "prs/sha256.h"
#include "prs/text.h"

namespace prs {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kLargestLivePage = 2'500'000;  ///< Bytes.

/// What the engine leaves for the rest, and what is tried where that is still too much.
constexpr ReportRoom kRoomsWithEngine[] = {{500'000, 300'000, 150'000}, {200'000, 150'000, 50'000}};

std::string base64(std::string_view bytes) {
  std::string text(BASE64_ENCODE_RAW_LENGTH(bytes.size()), '\0');
  base64_encode_raw(text.data(), bytes.size(), reinterpret_cast<const std::uint8_t*>(bytes.data()));
  return text;
}

/// Five letters for four bytes, a sixteenth less than base64, after their number: those from `(` to
/// `|`, but `}` and `~` for `<` and the backslash.
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

/// As policies name a style or a script by its text.
std::string policy_hash(std::string_view text) {
  const std::string digest = sha256(text);
  std::string bytes;
  for (std::size_t k = 0; k < digest.size(); k += 2)
    bytes += static_cast<char>(std::stoi(digest.substr(k, 2), nullptr, 16));
  return "sha256-" + base64(bytes);
}

/// Data in a script element, where no `<` may stand, nor what turns the direction of writing.
std::string data_block(const char* id, const Json& json) {
  std::string text;
  for (const char c : printable_json(json.dump(-1, ' ', false, Json::error_handler_t::replace)))
    if (c == '<')
      text += "\\u003c";
    else
      text += c;
  return fmt::format("<script type=\"application/json\" id=\"{}\">{}</script>\n", id, text);
}

/// What the page asks its engine about.
Json case_of(const input::Source& source) {
  const input::CaseInput in = input::read_case_input(source, Command::check);
  Json json{{"file", source.name}, {"yaml", source.text}, {"set", Json::array()}};
  for (const std::string& text : source.overrides) {
    const std::size_t equals = text.find('=');
    json["set"].push_back({text.substr(0, equals), text.substr(equals + 1)});
  }
  json["histories"] = Json::object();
  if (in.values.life && in.values.life->history)
    json["histories"][in.values.life->history->file] =
        input::force_history_text(*in.values.life->history, source);
  return json;
}

/// A text as a string of CSS.
std::string css_string(std::string_view content) {
  std::string text = "\"";
  for (const char c : printable(content)) {
    const auto byte = static_cast<unsigned char>(c);
    text += byte == ' ' || byte >= 0x80 || std::isalnum(byte) != 0 ? std::string(1, c)
                                                                   : fmt::format("\\{:x} ", byte);
  }
  return text + '"';
}

/// What stands at the foot of every sheet of a print.
std::string sheet_style(const ReportParts& parts) {
  return fmt::format(
      "@page{{@bottom-left{{content:{}}}@bottom-right{{content:\"Sheet \" counter(page) \" of \" "
      "counter(pages)}}}}\n",
      css_string(parts.mark));
}

/// The panel of the values. It is shown by the script alone.
std::string panel_html(const ReportParts& parts) {
  return fmt::format(R"(<aside id="live" aria-label="Other values" hidden>
<details open><summary>Try other values</summary>
<p id="state" role="status"></p>
<p id="trouble" role="alert"></p>
<form id="controls" autocomplete="off">
{}</form>
<p class="buttons"><button type="button" id="reset">Reset</button>
<button type="button" id="copy-set">Copy as --set</button>
<button type="button" id="copy-yaml">Copy as YAML</button></p>
</details></aside>
)",
                     parts.controls);
}

constexpr std::string_view kCopyDialog = R"(<dialog id="copy" aria-labelledby="copy-title">
<h2 id="copy-title"></h2><p id="copied" role="status"></p>
<textarea id="copy-text" readonly rows="12" aria-labelledby="copy-title"></textarea>
<form method="dialog"><button>Close</button></form></dialog>
)";

constexpr std::string_view kThreadForm =
    R"(<p>Click a thread in a picture, or choose one here.</p>
<form id="thread-form" autocomplete="off">
<label>Load case <select id="thread-case"></select></label>
<label id="roller-label">Roller <input id="thread-roller" type="number" min="1" value="1"></label>
<label>Thread <input id="thread-number" type="number" min="1" value="1"></label></form>
)";

std::string section_html(const ReportSection& section, bool hidden, std::string_view before = {}) {
  return fmt::format(
      "<section id=\"{0}\" aria-labelledby=\"{0}-title\"{3}>\n<h2 id=\"{0}-title\">{1}</h2>\n{4}"
      "<div class=\"body\">\n{2}</div></section>\n",
      section.id, section.title, section.body, hidden ? " hidden" : "", before);
}

/// The whole file. `engine` is empty for a page without scripts.
std::string page_html(const input::Source& source, const ReportParts& parts,
                      std::string_view engine) {
  const bool live = !engine.empty();
  const std::string style = std::string(page_style()) + svg_style() + sheet_style(parts);
  std::string links, body;
  const auto add = [&](const ReportSection& section, bool hidden, std::string_view before = {}) {
    links += fmt::format("<li{}><a href=\"#{}\">{}</a></li>", hidden ? " hidden" : "", section.id,
                         section.title);
    body += section_html(section, hidden, before);
  };
  for (const ReportSection& section : parts.sections) {
    if (!section.body.empty() || live) add(section, section.body.empty());
    if (live && section.id == "pressures") add({"thread", "One thread", ""}, true, kThreadForm);
  }
  const std::string scripts =
      live ? fmt::format(
                 "; script-src '{}' 'wasm-unsafe-eval'; worker-src blob:; connect-src "
                 "'none'",
                 policy_hash(page_script()))
           : "";
  std::string text = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"{}>\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src "
      "'{}'; img-src data:{}; "
      "base-uri 'none'; form-action 'none'\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"referrer\" content=\"no-referrer\">\n"
      "<title>{}</title>\n<style>{}</style>\n</head>\n<body>\n{}<div class=\"page{}\">\n"
      "<header>\n{}</header>\n<div class=\"side\"><nav aria-label=\"Contents\"><ol>{}</ol></nav>\n"
      "{}</div>\n<main>\n{}</main>\n<footer>{}</footer>\n</div>\n",
      table_system() == UnitSystem::us ? " data-units=\"us\"" : "", policy_hash(style), scripts,
      html(parts.title), style, live ? "<p id=\"changed\" hidden></p>\n" : "",
      live ? " is-live" : "", parts.head, links, live ? panel_html(parts) : "", body, parts.foot);
  text += data_block("data", parts.shown);
  if (live) {
    text += data_block("case", case_of(source));
    text += data_block("threads", parts.threads);
    text += fmt::format(
        "{}<script type=\"text/plain\" id=\"worker\">{}{}</script>\n"
        "<script type=\"text/plain\" id=\"engine\">{}</script>\n"
        "<script type=\"module\">{}</script>\n",
        kCopyDialog, engine_loader(), worker_script(), base85(engine), page_script());
  }
  return text + "</body>\n</html>\n";
}

}  // namespace

Report make_report(const input::Source& source, const PageOptions& options) {
  const bool live = options.live && !other_file(source);
  const std::string_view engine = live ? page_engine() : std::string_view();
  ReportOptions asked{options.command, options.results};
  const auto report = [](std::string page, ReportParts parts) {
    return Report{std::move(page), std::move(parts.data), std::move(parts.notes), parts.converged};
  };
  std::size_t size = 0;
  if (!engine.empty())
    for (const ReportRoom& room : kRoomsWithEngine) {
      asked.room = room;
      ReportParts parts = report_parts(source, asked);
      std::string page = page_html(source, parts, engine);
      size = page.size();
      if (size <= kLargestLivePage) return report(std::move(page), std::move(parts));
    }
  asked.room = {};
  ReportParts parts = report_parts(source, asked);
  if (size > 0)
    parts.notes.push_back(
        fmt::format("the page is static: with the engine, the file and its force history it would "
                    "have {:.1f} MB; expected at most {:.1f} MB; shorten the file or the history",
                    static_cast<double>(size) / 1e6, kLargestLivePage / 1e6));
  std::string page = page_html(source, parts, {});
  return report(std::move(page), std::move(parts));
}

}  // namespace prs
