#include "prs/report/report.h"

#include <charconv>
#include <regex>

#include "prs/bodies/body_models.h"
#include "prs/compare/compare_analysis.h"
#include "prs/compare/reference_analysis.h"
#include "prs/indices.h"
#include "prs/loads/full_result.h"
#include "prs/loads/load_record.h"
#include "prs/report/controls.h"
#include "prs/report/glossary.h"
#include "prs/report/requirement_page.h"
#include "prs/run/analyses.h"
#include "prs/run/document_schema.h"
#include "prs/text.h"
#include "prs/version.h"

namespace prs {
namespace {

/// A text as a URL has it; the page escapes quotes and markup besides.
std::string data_url(std::string_view type, std::string_view content) {
  std::string url = fmt::format("data:{};charset=utf-8,", type);
  for (const char c : content) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte <= 0x20 || byte >= 0x7f || std::string_view("%#\"'<>&\\^`{|}").find(c) != std::string_view::npos)
      url += fmt::format("%{:02X}", byte);
    else
      url += c;
  }
  return url;
}

constexpr std::size_t kMostColumns = 10;  ///< Load cases side by side in a table.

// Load cases

std::string base_name(const std::string& name) { return name.substr(0, name.rfind('[')); }

/// The load cases that tables show: of each range the first, the middle and the last; of many the
/// first few.
std::vector<RecordColumn> case_columns(const Json& document) {
  const Json& cases = under(document, "load_cases");
  std::vector<const Json*> chosen;
  for (const Json& load_case : cases) chosen.push_back(&load_case);
  if (chosen.size() > kMostColumns) {
    std::vector<const Json*> few;
    for (std::size_t first = 0; first < chosen.size();) {
      const std::string name = base_name(chosen[first]->value("name", ""));
      std::size_t last = first;
      while (last + 1 < chosen.size() && base_name(chosen[last + 1]->value("name", "")) == name) ++last;
      for (const std::size_t k : std::set{first, (first + last) / 2, last}) few.push_back(chosen[k]);
      first = last + 1;
    }
    few.resize(std::min(few.size(), kMostColumns));
    chosen = std::move(few);
  }
  return each(chosen, [](const Json* load_case) { return RecordColumn{load_case->value("name", ""), load_case}; });
}

std::string case_table_html(const Json& document, const RecordChoice& choice) {
  const std::vector<RecordColumn> columns = case_columns(document);
  const std::size_t count = under(document, "load_cases").size();
  std::string text = record_table(*record_at("load_cases[]"), columns, choice);
  if (!text.empty() && columns.size() < count)
    text += fmt::format("<p class=\"default\">{} of {} load cases; the files have all.</p>\n", columns.size(), count);
  return text;
}

// Pictures

/// Figures that a command draws from an answer, selected by name; figures of one load case are repeated for several.
template <class Choose>
std::string pictures_html(Findings& all, const CommandAnswer* answer, const Choose& choose) {
  std::string text;
  if (!answer) return text;
  for (const Picture& picture : answer->pictures)
    if (picture.drawn != Picture::Drawn::by_name && choose(picture.name))
      for (const Figure& figure : picture.make({})) text += figure_html(all, figure);
  return text;
}

/// Figures of one name for each of the first load cases that have it.
std::string each_case_html(Findings& all, const CommandAnswer& answer, std::string_view name) {
  constexpr std::size_t kMost = 4;
  const auto picture = std::ranges::find(answer.pictures, name, &Picture::name);
  if (picture == answer.pictures.end()) return {};
  const std::size_t count = under(answer.document, "load_cases").size();
  std::string text;
  for (const auto k : up_to(std::min(kMost, count)))
    for (const Figure& figure : picture->make({.load_case = k})) text += figure_html(all, figure);
  return text;
}

bool is_one_of(std::string_view name, std::initializer_list<std::string_view> names) { return contains(names, name); }
bool is_of_stiffness(std::string_view name) { return is_one_of(name, {"stiffness", "displacement"}); }
bool is_of_pressure(std::string_view name) { return is_one_of(name, {"peak_pressure", "ellipses"}); }
bool is_of_solution(std::string_view name) { return name == "convergence"; }
bool is_of_rollers(std::string_view name) { return is_one_of(name, {"roller_loads", "roller_shares"}); }

// Sections

/// Number of rollers: `11`, or `10 of 11` if some are missing.
std::string rollers_of(const Findings& all) {
  const std::string places = input_value(all, "mechanism.rollers");
  const auto missing = std::ranges::count_if(all.checked().fields, [](const input::EchoEntry& field) {
    return field.path.starts_with("deviations.missing_rollers[");
  });
  return missing == 0 ? places : fmt::format("{} of {}", std::stoi(places) - missing, places);
}

/// A text of the case's block `report`.
std::string told(const Findings& all, const char* key) { return input_value(all, fmt::format("report.{}", key)); }

std::string title_of(const Findings& all) {
  const std::string title = told(all, "title");
  return title.empty() ? std::filesystem::path(all.source.name).stem().string() : title;
}

/// Mark of every printed sheet.
std::string mark_of_sheets(const Findings& all) {
  std::string mark = title_of(all);
  for (const auto& [key, before] : {std::pair{"number", "No. "}, std::pair{"revision", "rev. "}})
    if (const std::string text = told(all, key); !text.empty()) mark += fmt::format(" · {}{}", before, text);
  return mark + " · " + all.date;
}

/// A link by which the browser saves a text as a file.
std::string download_link(std::string_view name, std::string_view type, std::string_view content) {
  return fmt::format("<a download=\"{0}\" href=\"{1}\">{0}</a>", html(name), data_url(type, content));
}

}  // namespace

/// Title block: texts of the file about the report, and its origin.
std::string head_html(const Findings& all) {
  const Contacts& contacts = all.checked().geometry.contacts;
  const auto length = [](double si) {
    const ReportUnit unit = report_unit("", "mm");
    return fmt::format("{} {}", report_number(unit.factor * si * "mm"_per_si, unit.text), unit.text);
  };
  const auto diameter = [&](Part part) { return length(2.0 * thread_of(contacts.threads, part).pitch_radius); };
  const int starts = contacts.mechanism.starts.screw;
  std::string block;
  const auto add = [&](const char* title, const std::string& text) {
    if (!text.empty()) block += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>\n", title, text);
  };
  for (const auto& [title, key] :
       {std::pair("Customer", "customer"), {"Number", "number"}, {"Revision", "revision"}, {"Author", "author"}})
    add(title, html(told(all, key)));
  add("Date", html(all.date));
  add("Case", breakable_html(all.source.name));
  add("Program", fmt::format("prs {}", kVersion));
  return fmt::format(
      "<p class=\"eyebrow\">Planetary roller screw · report</p>\n<h1>{}</h1>\n<dl "
      "class=\"block\">\n{}</dl>\n<p class=\"lead\">{} mechanism, {} rollers with {} threads each. "
      "Lead {}, {} start{} on the screw. Pitch diameters: screw {}, roller {}, nut {}.</p>\n",
      html(title_of(all)), block, html(capitalised(input_value(all, "mechanism.type"))), html(rollers_of(all)),
      contacts.mechanism.contacts_per_roller, length(contacts.mechanism.lead), starts, starts == 1 ? "" : "s",
      diameter(Part::screw), diameter(Part::roller), diameter(Part::nut));
}

namespace {

std::string mechanism_html(Findings& all) {
  const CommandAnswer* answer = all.most_complete();
  if (!answer) return {};
  const auto draw = [&](const char* name) { return figure_html(all, figure(answer->pictures, name, {})); };
  return draw("section") + (all.is_full ? each_case_html(all, *answer, "end_view") : draw("end_view"));
}

/// Stiffness and pressure of each model, a row per load case.
std::string comparison_html(const ModelComparison& comparison) {
  std::vector<std::string> head{"Load case",        "Model",          "Stiffness, N/µm", "Displacement, µm",
                                "Largest share, %", "Peak pressure, "};
  const ReportUnit pressure = report_unit("", "MPa");
  std::ranges::transform(head, head.begin(), with_table_unit);
  head.back() += pressure.text;
  std::vector<std::vector<std::string>> rows;
  constexpr std::size_t kMost = 12;
  const std::size_t count = comparison.load_cases();
  const std::size_t stride = count > kMost ? (count + kMost - 1) / kMost : 1;
  for (std::size_t k = 0; k < count; k += stride)
    for (const auto model : indices(comparison.models)) {
      const ComparedModel m{&comparison, k, model};
      const LoadCaseResult& r = m.result();
      const auto number = [&](std::string_view key) {
        const Quantity<ComparedModel>& q = quantity<ComparedModel>(key);
        const ReportUnit unit = report_unit(key, q.unit.text);
        const std::optional<double> value = shown_number(q, m);
        return value ? report_number(*value * unit.factor, unit.text) : "–";
      };
      double share = std::numeric_limits<double>::quiet_NaN();
      for (const Interface i : kInterfaces)
        if (r.threads && !(*r.threads)[i].load_rate.empty())
          share = std::fmax(share, std::ranges::max((*r.threads)[i].load_rate));
      rows.push_back({html(name_with_signs(r.load_case.name)), html(m.model_name()), number("axial_stiffness_N_per_um"),
                      number("axial_displacement_um"),
                      std::isfinite(share) ? report_number(share * "%"_per_si, "%") : "–",
                      number("largest_peak_pressure_MPa")});
    }
  return plain_table(head, rows, true);
}

/// Most important rows first, one each; the numbers of all threads are folded.
std::string loads_table_html(const Json& document) {
  const std::vector<std::string> first{"axial_force_N",
                                       "direction",
                                       "loads",
                                       "position_mm",
                                       "status",
                                       "axial_displacement_um",
                                       "axial_stiffness_N_per_um",
                                       "tangent_stiffness_N_per_um"};
  std::vector<std::string> others = first;
  for (const char* key : {"name", "converged", "iterations"}) others.emplace_back(key);
  return "<h3>Load cases</h3>\n" + case_table_html(document, {.only = first}) +
         folded_html("Every number of the load cases: threads, rollers, supports",
                     case_table_html(document, {.without = others}));
}

std::string stiffness_html(Findings& all) { return pictures_html(all, all.answer(Command::solve), is_of_stiffness); }

std::string loads_html(Findings& all) {
  const CommandAnswer* solve = all.answer(Command::solve);
  if (!solve) return {};
  std::string text = pictures_html(all, solve, [](std::string_view name) {
    return !is_of_stiffness(name) && !is_of_pressure(name) && !is_of_solution(name) && !is_of_rollers(name);
  });
  if (all.is_full) {
    text += each_case_html(all, *solve, "roller_loads");
    text += each_case_html(all, *solve, "roller_shares");
  }
  return text + loads_table_html(solve->document);
}

bool is_of_references(std::string_view name) { return name.starts_with("reference"); }

std::string models_html(Findings& all) {
  const CommandAnswer* compare = all.answer(Command::compare);
  if (!compare) return {};
  return pictures_html(all, compare, [](std::string_view name) { return !is_of_references(name); }) +
         comparison_html(*all.result<ModelComparison>(Command::compare));
}

std::string table_html(const PageTable& table) {
  std::vector<std::vector<std::string>> texts = table.rows;
  for (std::vector<std::string>& row : texts) std::ranges::transform(row, row.begin(), prose_html);
  return plain_table(each(table.head, prose_html), texts, true);
}

std::string references_html(Findings& all) {
  const CommandAnswer* compare = all.answer(Command::compare);
  if (!compare || all.result<ModelComparison>(Command::compare)->references.empty()) return {};
  return pictures_html(all, compare, is_of_references) +
         table_html(reference_page_table(*all.result<ModelComparison>(Command::compare)));
}

std::string heading_html(std::string_view title) {
  return title.empty() ? std::string() : fmt::format("<h3>{}</h3>\n", html(title));
}

/// The records of a document that are its own, and what its load cases have besides those of
/// `solve`.
std::string document_html(const Findings& all, const CommandAnswer& answer, const PageSection& section) {
  std::string text;
  const auto heading_of = [&](std::string_view record) {
    const auto found = std::ranges::find(section.in_document, record, &OpenRows::record);
    return found == section.in_document.end() ? std::string() : heading_html(found->heading);
  };
  for (const auto& [key, value] : answer.document.items())
    if (const RecordInfo* info = record_at(key);
        info && value.is_object() && !is_one_of(key, {"contact", "threads", "model", "comparison"}))
      text += heading_of(key) + record_table(*info, {{"", &value}}, {.hidden = section.estimates});
  RecordChoice choice{.without = {"name"}, .hidden = section.estimates};
  const CommandAnswer* solve = all.answer(Command::solve);
  static const Json none;
  if (const Json& known = solve ? under(solve->document, "load_cases") : none; !known.empty())
    for (const auto& [key, value] : known.front().items()) choice.without.push_back(key);
  return heading_html(section.in_cases.empty() ? "" : section.in_cases.front().heading) +
         case_table_html(answer.document, choice) + text;
}

/// Rows of a record of the document or, as in `life.system`, of one within it, under its title.
std::string part_of_document(const Json& document, const std::string& path, const RecordChoice& choice) {
  const std::size_t dot = std::min(path.find('.'), path.size());
  const Json& outer = under(document, path.substr(0, dot));
  const RecordInfo* info = record_at(path.substr(0, dot));
  if (dot == path.size()) return outer.is_object() ? record_table(*info, {{"", &outer}}, choice) : std::string();
  const auto inner = std::ranges::find(info->quantities, path.substr(dot + 1), &QuantityInfo::key);
  if (inner == info->quantities.end() || !outer.contains(inner->key)) return {};
  const Json& record = outer[std::string(inner->key)];
  const std::string table = record_table(inner->record(), {{"", &record}}, choice);
  return table.empty() ? table : heading_html(capitalised(inner->title)) + table;
}

std::string answer_html(Findings& all, Command command) {
  const CommandAnswer* answer = all.answer(command);
  if (!answer) return {};
  const PageSection section = answer->delivery.section ? answer->delivery.section() : PageSection{};
  const auto is_folded = [&](std::string_view name) { return contains(section.folded, name); };
  std::string text = section.note.empty() ? "" : fmt::format("<p>{}</p>\n", prose_html(section.note));
  text += pictures_html(all, answer, [&](std::string_view name) { return !is_folded(name); });
  const std::vector<RecordColumn> cases = case_columns(answer->document);
  const auto add = [&](const std::string& heading, const std::string& table) {
    if (!table.empty()) text += heading_html(heading) + table;
  };
  for (const PageTable& table : section.tables) add(table.heading, table_html(table));
  for (const auto& [key, only, heading] : section.in_cases)
    if (const RecordInfo* info = record_in(*record_at("load_cases[]"), key))
      add(heading, record_table(*info, columns_in(cases, key), {.only = only, .hidden = section.estimates}));
  for (const auto& [key, only, heading] : section.in_document)
    add(heading, part_of_document(answer->document, key, {.only = only, .hidden = section.estimates}));
  const bool is_open = section.in_cases.empty() && section.in_document.empty() && section.tables.empty();
  const std::string every = document_html(all, *answer, section);
  return text + folded_html("More pictures", pictures_html(all, answer, is_folded)) +
         (is_open ? every : folded_html("Every number", every));
}

std::string contact_html(Findings& all) {
  const CommandAnswer* answer = all.answer(Command::contact);
  const Result* result = all.result<Result>(Command::contact);
  if (!result || !(result->contacts.threads.centre_distance > 0.0)) return {};
  const Json contact = object_of(result->contacts);
  const RecordInfo& info = describe<Contacts>();
  const auto is_first = [](std::string_view name) { return name == "contact_axial_section"; };
  std::vector<RecordColumn> sides;
  for (const char* side : {"screw", "nut"})
    if (contact.contains(side)) sides.push_back({fmt::format("roller-{}", side), &contact[side]});
  std::string folded = pictures_html(all, answer, [&](std::string_view name) { return !is_first(name); });
  if (const RecordInfo* side = record_in(info, "screw"); side && !sides.empty()) folded += record_table(*side, sides);
  return pictures_html(all, answer, is_first) + record_table(info, {{"", &contact}}, {.without = {"screw", "nut"}}) +
         folded_html("Points, curvatures and clearances of the contacts", folded);
}

/// A text whose numbers have no more digits than a reader takes in: `16.517 1/GPa`.
std::string with_short_numbers(std::string_view text) {
  constexpr std::ptrdiff_t kDigits = 5;
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  std::string shown;
  while (!text.empty()) {
    const bool begins = is_digit(text.front()) &&
                        (shown.empty() || std::string_view(" -+[{(,:").find(shown.back()) != std::string_view::npos);
    double value = 0.0;
    std::size_t size = 1;
    if (begins)
      size = static_cast<std::size_t>(std::from_chars(text.data(), text.data() + text.size(), value).ptr - text.data());
    const std::string_view number = text.substr(0, size);
    const bool is_long = number.find('.') != number.npos && std::ranges::count_if(number, is_digit) > kDigits;
    if (is_long && value < 1e5)
      shown += fmt::format("{:.{}g}", value, kDigits);
    else if (is_long && number.find('e') == number.npos)
      shown += fmt::format("{:.0f}", value);
    else
      shown += number;
    text.remove_prefix(size);
  }
  return shown;
}

/// A value as the file has it, or one that the file does not state.
std::string input_shown(const input::EchoEntry& field) {
  return field.written.empty() || field.written == "~" ? with_short_numbers(field.value) : field.written;
}

/// A value of an input: names break where their parts end, quantities have the signs of print.
std::string value_of_input_html(const input::EchoEntry& field) {
  const std::string shown = input_shown(field);
  static const std::regex kName("[a-z][._][a-z]");
  return std::regex_search(shown, kName) ? breakable_html(shown) : prose_html(shown);
}

/// A row for each input that the file states, or for each that it does not.
std::string input_table_html(const Findings& all, bool of_defaults, std::size_t& count) {
  constexpr std::size_t kMostOfBlock = 1000;
  std::vector<std::vector<std::string>> rows;
  std::string block, tables;
  std::size_t of_block = 0;
  bool has_reasons = false;
  std::string_view told;  // The reason of the row above: not repeated.
  const auto end_block = [&] {
    if (of_block > kMostOfBlock)
      rows.push_back(
          {fmt::format("… and {} more", of_block - kMostOfBlock), "<code>prs check --all</code> shows them"});
    of_block = 0;
    if (!rows.empty()) tables += plain_table({}, rows);
    rows.clear();
  };
  for (const input::EchoEntry& field : all.checked().fields) {
    const std::string own = field.path.substr(0, field.path.find_first_of(".["));
    if (field.is_default != of_defaults || own == "report") continue;
    if (block != own) end_block();
    block = own;
    ++count;
    if (++of_block > kMostOfBlock) continue;
    const auto [basis, reason] = basis_of(field, all.checked());
    std::string origin(basis);
    if (!field.origin.empty()) origin += " " + field.origin;
    if (!reason.empty()) origin += reason == told ? ", as above" : fmt::format(": {}", reason);
    told = reason;
    has_reasons = has_reasons || !reason.empty();
    rows.push_back(
        {fmt::format("<code>{}</code>", breakable_html(field.path)), value_of_input_html(field), prose_html(origin)});
  }
  end_block();
  if (tables.empty()) return {};
  return fmt::format("<div class=\"blocks{}\">\n{}</div>\n", has_reasons ? " told" : "", tables);
}

std::string inputs_html(const Findings& all) {
  std::size_t stated = 0, defaults = 0;
  const std::string of_file = input_table_html(all, false, stated), others = input_table_html(all, true, defaults);
  const std::size_t assumed = assumed_inputs(all);
  std::string text = fmt::format("<p>{} values given", stated - assumed);
  if (assumed > 0) text += fmt::format(", {} assumed as comments in the file say", assumed);
  text += ".</p>\n";
  text += of_file + folded_html(fmt::format("{} values that the file does not state: defaults", defaults), others);
  std::vector<std::vector<std::string>> derived;
  const Json lengths = derived_of(all.checked().geometry.contacts.mechanism);
  for (const auto& [key, value] : lengths.items()) {
    const ReportUnit unit = report_unit(key, unit_of(key).text);
    derived.push_back({html(capitalised(words_of(key))), report_value(value, unit), prose_html(unit.text)});
  }
  if (!derived.empty()) text += "<h3>What follows from them</h3>\n" + plain_table({"", "Value", "Unit"}, derived);
  return text;
}

/// Variables and responses of the design in the file and of the chosen one.
std::string optimization_html(const Json& document) {
  if (!document.contains("initial") || !document.contains("compromise")) return {};
  const Json& before = document["initial"];
  const Json& after = document["compromise"];
  std::vector<std::vector<std::string>> rows;
  const auto number_of = [](const Json& design, const char* block, const std::string& key) {
    return design.contains(block) && design[block].contains(key) ? design[block][key] : Json();
  };
  for (const char* block : {"variables", "responses"})
    for (const auto& entry : under(after, block).items()) {
      const std::string& path = entry.key();
      const auto shown = [&](const Json& v) {
        return v.is_object() ? html(v.value("value", "")) : report_value(v, report_unit(path, unit_at(path).text));
      };
      rows.push_back({html(path), shown(number_of(before, block, path)), shown(entry.value())});
    }
  return plain_table({"", "In the file", "Chosen"}, rows, true);
}

std::string studies_html(Findings& all) {
  std::string text;
  std::size_t room = all.options.room.pictures;
  for (const StoredRun& study : all.studies) {
    text += fmt::format("<h3>{}</h3>\n", study.command == Command::study ? "Study" : "Optimization");
    std::size_t left_out = 0;
    for (const OutputFile& file : study.files) {
      if (file.name == "optimize.json")
        if (const Json document = Json::parse(file.content, nullptr, false); document.is_object())
          text += optimization_html(document);
      if (!file.name.ends_with(kFiguresEnding)) continue;
      for (const Figure& figure : figures_of(file.content)) {
        const std::string drawn = figure_html(all, figure);
        if (drawn.size() > room) {
          ++left_out;
          continue;
        }
        room -= drawn.size();
        text += drawn;
      }
    }
    if (left_out > 0)
      text += fmt::format("<p class=\"default\">{} more picture{} {} in the folder of the results.</p>\n", left_out,
                          left_out == 1 ? "" : "s", left_out == 1 ? "is" : "are");
  }
  return text;
}

/// Records of docs/validation/ of the models that the page is made by.
std::set<std::string> validation_records(const Findings& all) {
  std::set<std::string> names;
  if (all.is_full) names.insert("full_mechanism");
  for (const CommandAnswer& answer : all.answers) {
    const std::string command(name(answer.command));
    if (command == "compare")
      for (const auto& row : kBodyModels) names.emplace(row.model.name);
    if (command != "check" && command != "compare" && command != "solve") names.insert(command);
    const Result* result = answer.delivery.result<Result>();
    if (!result) continue;
    if (has_solved(*result)) names.insert(std::string(result->model.bodies->name));
    if (result->heat_cycle) names.insert("heat");
    for (const LoadCaseResult& load_case : result->load_cases) {
      if (load_case.running) names.insert("running");
      if (load_case.heat) names.insert("heat");
      if (load_case.full && (load_case.full->travel || load_case.full->modes)) names.insert("motion");
    }
  }
  return names;
}

/// Solution of each load case, and origin of all results.
std::string provenance_html(Findings& all) {
  std::string text = "<dl class=\"facts\">\n";
  const auto fact = [&](const char* title, const std::string& value) {
    if (!value.empty()) text += fmt::format("<dt>{}</dt><dd>{}</dd>\n", title, value);
  };
  fact("Program", fmt::format("prs {}", html(kVersion)));
  fact("Date", all.date);
  fact("Command", fmt::format("<code>{}</code>", html(all.options.command)));
  fact("Case", fmt::format("<code>{}</code>", html(all.source.name)));
  fact("SHA-256 of the case", fmt::format("<code>{}</code>", all.origin.input_sha256));
  std::string overrides;
  for (const std::string& text_of : all.source.overrides)
    overrides += fmt::format("{}<code>{}</code>", overrides.empty() ? "" : ", ", html(text_of));
  fact("Changed by --set", overrides);
  fact("Schema of the input", html(all.origin.schema_version));
  const CommandAnswer* solve = all.answer(Command::solve);
  if (const Result* result = all.result<Result>(Command::solve); result && has_solved(*result)) {
    fact("Model of the bodies", html(result->model.bodies->name));
    fact("What the model means", prose_html(known_bias(result->model)));
  }
  std::string records;
  for (const std::string& record : validation_records(all))
    records += fmt::format("{}<code>docs/validation/{}.md</code>", records.empty() ? "" : ", ", record);
  fact("Validation records of the models", records);
  text += "</dl>\n";
  if (solve) {
    text += folded_html("How the load cases were solved",
                        case_table_html(solve->document, {.without = {"name"}, .reach = Reach::document}) +
                            pictures_html(all, solve, is_of_solution));
  }
  return text;
}

/// Each file once, small ones first, as far as there is room.
std::string files_html(Findings& all) {
  std::vector<OutputFile> files;
  const auto add = [&](OutputFile file) {
    if (std::ranges::find(files, file.name, &OutputFile::name) == files.end()) files.push_back(std::move(file));
  };
  for (const CommandAnswer& answer : all.answers)
    if (answer.delivery.files)
      for (OutputFile& file : answer.delivery.files({})) add(std::move(file));
  for (const StoredRun& study : all.studies)
    for (const OutputFile& file : study.files)
      if (file.name.ends_with(".csv")) add(file);
  if (files.empty()) return {};
  std::vector<std::size_t> order(files.size());
  for (const auto k : indices(order)) order[k] = k;
  std::ranges::stable_sort(order, {}, [&](std::size_t k) { return files[k].content.size(); });
  std::size_t room = all.options.room.files;
  std::set<std::size_t> carried;
  for (const std::size_t k : order)
    if (files[k].content.size() <= room) {
      room -= files[k].content.size();
      carried.insert(k);
    }
  std::string links, absent;
  for (const auto k : indices(files))
    if (carried.contains(k))
      links += fmt::format("<li>{}</li>\n", download_link(files[k].name, "text/csv", files[k].content));
    else
      absent += (absent.empty() ? "" : ", ") + files[k].name;
  std::string text =
      "<p>Every number behind the tables and pictures, as CSV.</p>\n"
      "<ul class=\"files\">\n" +
      links + "</ul>\n";
  if (!absent.empty()) {
    text += fmt::format(
        "<p>Too large for this page: {}. The commands write them with <code>--output "
        "DIR</code>.</p>\n",
        html(absent));
    all.notes.push_back(fmt::format("too large for the page: {}", absent));
  }
  return text;
}

std::string pressures_html(Findings& all) { return pictures_html(all, all.answer(Command::solve), is_of_pressure); }
std::string warnings_html(Findings& all) {
  std::string refused;
  for (const std::string& note : all.notes) refused += fmt::format("<p>{}</p>\n", prose_html(note));
  const std::string assumptions = warning_list(all, true);
  return warning_list(all, false) + refused +
         (assumptions.empty() ? "" : folded_html(kAssumptionsTitle, assumptions, true));
}

/// Words of the field and of all numbers on the page.
std::string meanings_html(Findings& all) {
  std::vector<std::pair<const RecordInfo*, const Json*>> records;
  for (const CommandAnswer& answer : all.answers)
    for (const auto& [key, value] : answer.document.items())
      if (const RecordInfo* info = record_at(key == "load_cases" ? "load_cases[]" : key)) {
        if (value.is_object()) records.emplace_back(info, &value);
        if (value.is_array())
          for (const Json& item : value) records.emplace_back(info, &item);
      }
  return glossary_html(records);
}

/// The values of the case, of a document's head, and documents by their commands under `results`, as
/// long as there is room; all of them without a bound.
Json data_of(const Findings& all, const Json& head, std::optional<std::size_t> room) {
  const auto takes = [&](const Json& json) {
    if (!room) return true;
    const std::size_t size = json.dump(-1, ' ', false, Json::error_handler_t::replace).size();
    if (size > *room) return false;
    *room -= size;
    return true;
  };
  Json data{{"prs_version", kVersion}, {"date", all.date}};
  for (const char* key : {"schema_version", "case_file", "input_sha256", "resolved_input"})
    if (head.contains(key) && takes(head[key])) data[key] = head[key];
  data["overrides"] = all.source.overrides;
  data["results"] = Json::object();
  for (const CommandAnswer& answer : all.answers)
    if (takes(answer.document)) data["results"][std::string(name(answer.command))] = answer.document;
  return data;
}

}  // namespace

/// Sections of the analyses, at their places.
std::vector<SectionRow> analysis_rows() {
  std::vector<const AnyAnalysis*> shown;
  for (const AnyAnalysis& analysis : analyses())
    if (!analysis.place.title.empty()) shown.push_back(&analysis);
  std::ranges::stable_sort(shown, {}, [](const AnyAnalysis* a) { return a->place.order; });
  return each(shown, [](const AnyAnalysis* analysis) {
    return SectionRow{name(analysis->command), analysis->place.title,
                      [command = analysis->command](Findings& all) { return answer_html(all, command); }};
  });
}

std::span<const SectionRow> section_rows() {
  static const std::vector<SectionRow> all = [] {
    std::vector<SectionRow> rows{
        {kSummary, "Summary", summary_html},
        {"verdict", "Verdict", verdict_html, true},
        {"warnings", "Warnings", warnings_html},
        {"mechanism", "Mechanism", mechanism_html, true},
        {"inputs", "Inputs and assumptions", inputs_html},
        {"loads", "Load distribution", loads_html, true},
        {"pressures", "Pressures", pressures_html, true},
        {"stiffness", "Stiffness", stiffness_html, true},
    };
    append(rows, analysis_rows());
    std::ranges::move(std::vector<SectionRow>{{"references", "References", references_html},
                                              {"models", "The models side by side", models_html},
                                              {"contacts", "Contacts", contact_html},
                                              {"studies", "Studies", studies_html},
                                              {"data", "Data", files_html},
                                              {"provenance", "Provenance", provenance_html},
                                              {"glossary", "Glossary", meanings_html}},
                      std::back_inserter(rows));
    return rows;
  }();
  return all;
}

ReportSection section_of(Findings& all, const SectionRow& row) {
  all.section = row.id;
  all.places.clear();
  return {std::string(row.id), std::string(row.title), row.make(all)};
}

ReportParts report_parts(const input::Source& source, const ReportOptions& options) {
  if (const OtherFile* other = other_file(source)) {
    if (!options.summary) return requirement_parts(source, options);
    throw input::InputError(
        fmt::format("{}: got a requirement of `prs {}` with --summary; expected a case, which "
                    "`prs size {} --write 1` writes",
                    source.name, name(other->command), source.name));
  }
  Findings all = findings_of(source, options, reported_commands());
  ReportParts parts;
  parts.title = fmt::format("{} · planetary roller screw", title_of(all));
  parts.mark = mark_of_sheets(all);
  parts.head = head_html(all);
  for (const SectionRow& row : section_rows())
    if (!options.summary || row.id == kSummary) parts.sections.push_back(section_of(all, row));
  parts.foot = fmt::format("<p>Made by prs {} on {}. SHA-256 of the case: <span class=\"mono\">{}</span></p>",
                           html(kVersion), all.date, all.origin.input_sha256);
  parts.controls = controls_html(all);
  parts.threads = thread_choices(all);
  const Json head = document_head(all.origin, {});
  parts.data = data_of(all, head, {});
  parts.shown = data_of(all, head, options.room.data);
  parts.notes = all.notes;
  append(parts.notes, unconverged(all));
  parts.converged = all.converged;
  return parts;
}

}  // namespace prs
