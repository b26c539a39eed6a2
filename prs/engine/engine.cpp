#include "prs/engine/engine.h"

#include <fmt/ranges.h>

#include <exception>
#include <new>
#include <sstream>

#include "prs/configurations/new_case.h"
#include "prs/report/report.h"
#include "prs/run/analyses.h"
#include "prs/size/size.h"

namespace prs {
namespace {

/// Error in the question, not in its case.
class QuestionError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
  QuestionError(std::string_view got, std::string_view expected)
      : std::runtime_error(fmt::format("question: got {}; expected {}", got, expected)) {}
  QuestionError(std::string_view key, std::string_view got, std::string_view expected)
      : std::runtime_error(fmt::format("question: {}: got {}; expected {}", key, got, expected)) {}
};

/// Names that are no command of a case: sections of the report, the case with its overrides written
/// in, a new case.
constexpr std::string_view kReport = "report", kWrite = "write", kNew = "new";

struct Question {
  std::string name;
  LiveQuestion report;
  input::Source source;
  std::vector<std::string> load_cases;
  bool figures = false;
  std::size_t rank = 0;  ///< Rank of the candidate to write.
  NewOptions new_case;
};

struct Answer {
  Exit status = kDone;
  Json document = nullptr;
  Json figures = Json::array();
  std::vector<std::string> messages = {};
  std::string document_text = {};  ///< Text of a document that is long and simple, in place of `document`.
};

// The question

template <class T>
T value_of(const Json& question, const char* key, T absent, const char* expected) {
  const auto found = question.find(key);
  if (found == question.end()) return absent;
  try {
    return found->get<T>();
  } catch (const Json::exception&) {
    throw QuestionError(key, input::shown(found->dump()), expected);
  }
}

/// Command of another file; null if it is none.
const OtherFile* other_named(const std::string& name) {
  const auto found =
      std::ranges::find_if(other_files(), [&](const OtherFile& file) { return prs::name(file.command) == name; });
  return found == other_files().end() ? nullptr : &*found;
}

const AnyAnalysis& analysis_named(const std::string& name) {
  std::vector<std::string_view> known;
  for (const AnyAnalysis& row : analyses()) {
    if (!row.run) continue;
    if (prs::name(row.command) == name) return row;
    known.push_back(prs::name(row.command));
  }
  for (const OtherFile& file : other_files()) known.push_back(prs::name(file.command));
  known.insert(known.end(), {kReport, kWrite, kNew});
  throw QuestionError("command", input::shown(name), fmt::format("one of {}", fmt::join(known, ", ")));
}

LiveQuestion live_question(const Json& json) {
  LiveQuestion question;
  question.own = value_of<std::size_t>(json, "own", 0, "a number of overrides");
  question.quick = value_of<bool>(json, "quick", false, "true or false");
  question.sections = value_of<std::vector<std::string>>(json, "sections", {}, "a list of names of sections");
  if (value_of<std::string>(json, "units", "si", "si or us") == "us") question.units = UnitSystem::us;
  if (const Json thread = value_of<Json>(json, "thread", nullptr, "an object"); thread.is_object())
    question.thread = {value_of<std::size_t>(thread, "load_case", 0, "a number from 0"),
                       value_of<std::size_t>(thread, "thread", 0, "a number from 0")};
  return question;
}

NewOptions new_options(const Json& json) {
  const std::pair<const char*, std::optional<std::string> NewOptions::*> kTexts[] = {
      {"screw_diameter", &NewOptions::screw_diameter},
      {"lead", &NewOptions::lead},
      {"nut_diameter", &NewOptions::nut_diameter},
      {"nut_length", &NewOptions::nut_length},
      {"roller_profile_radius", &NewOptions::roller_profile_radius},
      {"load", &NewOptions::load},
      {"speed", &NewOptions::speed},
      {"lubricant", &NewOptions::lubricant},
      {"temperature", &NewOptions::temperature},
      {"mechanism", &NewOptions::mechanism}};
  std::vector<std::string_view> known{"type", "starts", "rollers"};
  for (const auto& [key, text] : kTexts) known.emplace_back(key);
  for (const auto& item : json.items())
    if (std::ranges::find(known, item.key()) == known.end())
      throw QuestionError("new", input::shown(item.key()), fmt::format("the keys {}", fmt::join(known, ", ")));
  NewOptions options;
  options.type = value_of<std::string>(json, "type", "standard", "standard or inverted");
  for (const auto& [key, text] : kTexts)
    if (json.contains(key)) options.*text = value_of<std::string>(json, key, "", "a text");
  for (const auto& [key, number] :
       {std::pair{"starts", &NewOptions::starts}, std::pair{"rollers", &NewOptions::rollers}})
    if (json.contains(key)) options.*number = value_of<int>(json, key, 0, "a whole number");
  return options;
}

Question parsed(std::string_view text) {
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object()) throw QuestionError(input::shown(text), "a JSON object");
  constexpr std::string_view kKeys[] = {"command",    "yaml",    "file",   "set",  "histories",
                                        "load_cases", "figures", "report", "rank", "new"};
  for (const auto& item : json.items())
    if (std::ranges::find(kKeys, item.key()) == std::end(kKeys))
      throw QuestionError(input::shown(item.key()), fmt::format("the keys {}", fmt::join(kKeys, ", ")));
  Question question;
  question.name = value_of<std::string>(json, "command", "", "a text");
  for (const char* key : {"command", "yaml"})
    if (!json.contains(key) && question.name != kNew) throw QuestionError(key, "nothing", "a text");
  question.rank = value_of<std::size_t>(json, "rank", 0, "a rank of the list, from 1");
  question.new_case = new_options(value_of<Json>(json, "new", Json::object(), "an object"));
  if (question.name == kNew) return question;

  if (question.name != kReport && question.name != kWrite && !other_named(question.name)) analysis_named(question.name);
  question.report = live_question(value_of<Json>(json, "report", Json::object(), "an object"));
  std::vector<std::string> overrides;
  for (const Json& pair : value_of<std::vector<Json>>(json, "set", {}, "a list of pairs")) {
    if (!pair.is_array() || pair.size() != 2 || !pair[0].is_string() || !pair[1].is_string())
      throw QuestionError("set", input::shown(pair.dump()), "a pair of path and value, two texts");
    overrides.push_back(fmt::format("{}={}", pair[0].get<std::string>(), pair[1].get<std::string>()));
  }
  std::istringstream yaml(value_of<std::string>(json, "yaml", "", "a text"));
  question.source =
      input::read_source(yaml, value_of<std::string>(json, "file", "case.yaml", "a text"), std::move(overrides));
  question.source.files =
      value_of<std::map<std::string, std::string>>(json, "histories", {}, "texts by the names of their files");
  question.load_cases = value_of<std::vector<std::string>>(json, "load_cases", {}, "a list of names");
  question.figures = value_of<bool>(json, "figures", false, "true or false");
  return question;
}

/// Keeps only the load cases of these names; the name of a range is before the `[`.
void choose(const std::vector<std::string>& names, Command command, Case& c) {
  if (!analysis_of(command).takes_load_cases_apart)
    throw QuestionError("load_cases", fmt::format("a choice for `{}`", name(command)),
                        "none: it takes all load cases together; leave `load_cases` out");
  const auto is_called = [](const LoadCase& load, const std::string& name) {
    return load.name == name || load.name.substr(0, load.name.rfind('[')) == name;
  };
  for (const std::string& name : names)
    if (std::ranges::none_of(c.load_cases, [&](const LoadCase& load) { return is_called(load, name); }))
      throw QuestionError("load_cases", input::shown(name), "the name of a load case of the file");
  std::erase_if(c.load_cases, [&](const LoadCase& load) {
    return std::ranges::none_of(names, [&](const std::string& name) { return is_called(load, name); });
  });
  if (c.heat) c.heat->duty.clear();
}

// Answer

/// Appends HTML as a string of JSON: well-formed, as the report escapes all its input.
void append_quoted(std::string& text, std::string_view html) {
  text += '"';
  for (;;) {
    const auto special = std::ranges::find_if(
        html, [](char c) { return c == '"' || c == '\\' || static_cast<unsigned char>(c) < 0x20; });
    text.append(html.begin(), special);
    if (special == html.end()) break;
    if (*special == '"' || *special == '\\')
      text.append("\\").append(1, *special);
    else
      text += fmt::format("\\u{:04x}", static_cast<int>(*special));
    html.remove_prefix(static_cast<std::size_t>(special - html.begin()) + 1);
  }
  text += '"';
}

Answer report_answer(const Question& question) {
  LiveAnswer found = live_sections(question.source, question.report);
  std::string text = "{\"sections\": {";
  const char* separator = "";
  for (const auto& [id, body] : found.sections.items()) {
    text.append(std::exchange(separator, ",\n")).append("\"" + id + "\": ");
    append_quoted(text, body.get_ref<const std::string&>());
  }
  text += "},\n\"head\": ";
  append_quoted(text, found.head);
  text += fmt::format(",\n\"threads\": {},\n\"kept\": {},\n\"all_follow\": {}}}", found.threads.dump(),
                      Json(found.kept).dump(), found.all_follow);
  return {.status = found.converged ? kDone : kNotConverged,
          .messages = std::move(found.notes),
          .document_text = std::move(text)};
}

Answer new_answer(const NewOptions& options) {
  try {
    return {.document = {{"yaml", new_case_text(options)}, {"assumed", assumptions(options)}}};
  } catch (const CaseError& error) {
    throw QuestionError(fmt::format("{}: {}", error.path(), error.what()));
  }
}

/// A candidate of a requirement as a case.
Answer candidate_answer(const Question& question) {
  const SizeResult result = size_screws(read_requirement(question.source));
  if (question.rank > result.candidates.size())
    throw QuestionError("rank", std::to_string(question.rank),
                        fmt::format("a rank of the list, 1 to {}", result.candidates.size()));
  return {.document = {{"yaml", written_candidate(result.input, result.candidates[question.rank - 1])}}};
}

Answer written_answer(const Question& question) {
  if (question.rank > 0) return candidate_answer(question);
  const std::optional<std::string> text = input::written_case(question.source);
  if (!text)
    throw QuestionError("set", "a value that cannot be written into the file in its place",
                        "other values; give them as --set");
  return {.document = {{"yaml", *text}}};
}

void put_lines(std::vector<std::string>& messages, std::string_view text, std::string_view before = "") {
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    if (!line.empty()) messages.push_back(fmt::format("{}{}", before, line));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
  }
}

/// All forms of the answer to a command, with its name.
Answer delivered_answer(const Question& question, Command command, const Delivery& delivery) {
  Answer answer;
  answer.status = status_of(delivery);
  answer.document = delivery.document(document_info(question.source, command));
  if (question.figures && delivery.pictures) answer.figures = to_json(figures(delivery.pictures()));
  for (const std::string& note : delivery.notes) put_lines(answer.messages, note);
  return answer;
}

Answer answer_to(const Question& question) {
  if (question.name == kReport) return report_answer(question);
  if (question.name == kWrite) return written_answer(question);
  if (question.name == kNew) return new_answer(question.new_case);
  if (const OtherFile* file = other_named(question.name))
    return delivered_answer(question, file->command, file->run(question.source));
  const AnyAnalysis& row = analysis_named(question.name);
  if (row.command == Command::check && other_file(question.source))
    return delivered_answer(question, row.command, run(row, question.source));
  input::CaseInput in = input::read_case_input(question.source, row.command);
  if (!question.load_cases.empty()) choose(question.load_cases, row.command, in.values);
  return delivered_answer(question, row.command, row.run(question.source, in));
}

Answer refusal(Exit status, std::string_view lines, std::string_view before = "") {
  Answer answer{.status = status};
  put_lines(answer.messages, lines, before);
  return answer;
}

Answer answer_or_refusal(std::string_view question) {
  constexpr std::string_view kOwn = "prs: error: ";
  try {
    return answer_to(parsed(question));
  } catch (const input::InputError& error) {
    return refusal(kWrongInput, error.what());
  } catch (const QuestionError& error) {
    return refusal(kWrongInput, error.what(), kOwn);
  } catch (const std::bad_alloc&) {
    return refusal(kFailed, "out of memory; give it a smaller case", kOwn);
  } catch (const std::exception& error) {
    return refusal(kFailed, error.what(), kOwn);
  }
}

}  // namespace

std::string answer(std::string_view question) {
  const Answer answer = answer_or_refusal(question);
  return fmt::format("{{\"status\": {},\n\"document\": {},\n\"figures\": {},\n\"messages\": {}}}\n",
                     static_cast<int>(answer.status),
                     answer.document_text.empty() ? json_text(answer.document) : answer.document_text + '\n',
                     json_text(answer.figures), json_text(answer.messages));
}

}  // namespace prs
