#include "prs/cli/help.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/replace.hpp>
#include <nlohmann/json.hpp>
#include <sstream>
#include <utility>

#include "prs/text.h"

namespace prs::cli {
namespace {

constexpr std::size_t kWidth = 80;
constexpr std::size_t kTermWidth = 24;

constexpr std::pair<const char*, const char*> kExitStatuses[] = {
    {"0", "done"},
    {"1", "failed, or a result could not be written"},
    {"2", "the input or the command line is wrong"},
    {"3", "a load case, a study or a fit did not converge, or no design fulfils the constraints of `optimize`"},
    {"4", "a reference lies beyond its tolerance (`compare`)"},
    {"129", "ended by SIGHUP, as when a terminal closes"},
    {"130", "interrupted by Ctrl-C"},
    {"143", "ended by SIGTERM"}};

struct Entry {
  std::string term, text;
};

struct Section {
  std::string title;
  std::vector<Entry> entries;
};

std::string term(const OptionText& option) {
  std::string text = fmt::format("{}", fmt::join(option.names, ", "));
  if (option.value.empty()) return text;
  const std::string value = option.optional_value ? "[" + option.value + "]" : option.value;
  return text.empty() ? value : text + " " + value;
}

/// Text of an argument: lists its possible words, unless it already explains each.
std::string text(const OptionText& option) {
  const bool explained = !option.words.empty() && option.help.find(option.words.front() + ":") != std::string::npos;
  if (!option.names.empty() || option.words.empty() || explained) return option.help;
  return fmt::format("{}: {}", option.help, fmt::join(option.words, ", "));
}

/// Sections of a help page between its usage and its examples, in the order of first entries.
std::vector<Section> sections(const CommandText& command) {
  std::vector<Section> all;
  const auto add = [&](const std::string& title, Entry entry) {
    auto section = std::ranges::find(all, title, &Section::title);
    if (section == all.end()) section = all.insert(section, Section{title, {}});
    section->entries.push_back(std::move(entry));
  };
  for (const OptionText& argument : command.arguments) add("Arguments", {argument.value, text(argument)});
  for (const CommandText& c : command.commands)
    if (!c.group.empty()) add(c.group, {last_word(c), c.help});
  for (const OptionText& option : command.options) add("Options", {term(option), text(option)});
  return all;
}

std::string plain(const Section& section) {
  std::string lines = fmt::format("\n{}:\n", section.title);
  for (const auto& [term, text] : section.entries) {
    const std::string indent(kTermWidth, ' ');
    std::string paragraph = wrapped(text, indent, kWidth);
    const std::string start = "  " + term;
    if (start.size() + 1 < kTermWidth)
      paragraph.replace(0, start.size(), start);
    else
      lines += start + "\n";
    lines += paragraph;
  }
  return lines;
}

std::string indented(const std::string& text) { return "  " + boost::replace_all_copy(text, "\n", "\n  ") + "\n"; }

// roff

constexpr std::pair<char, std::string_view> kEscapes[] = {
    {'\\', "\\e"}, {'-', "\\-"}, {'\'', "\\(aq"}, {'^', "\\(ha"}, {'~', "\\(ti"}};

std::string escaped(std::string_view text) {
  std::string out;
  bool bold = false;
  for (const char c : text) {
    const auto escape = std::ranges::find(kEscapes, c, [](const auto& e) { return e.first; });
    if (c == '`')
      out += (bold = !bold) ? "\\fB" : "\\fR";
    else if (escape != std::end(kEscapes))
      out += escape->second;
    else
      out += c;
  }
  return out;
}

/// A line protected against being read as a request.
std::string line(std::string_view text) {
  const std::string escapes = escaped(text);
  return (escapes.starts_with('.') ? "\\&" : "") + escapes + "\n";
}

std::string lines_of(const std::string& text) {
  std::istringstream in(text);
  std::string lines;
  for (std::string one; std::getline(in, one);) lines += line(one);
  return lines;
}

std::string title(const std::string& text) { return fmt::format(".SH {}\n", boost::to_upper_copy(text)); }

std::string page_name(const CommandText& command) { return boost::replace_all_copy(command.name, " ", "-"); }

}  // namespace

std::string last_word(const CommandText& command) { return command.name.substr(command.name.rfind(' ') + 1); }

std::string usage(const CommandText& command) {
  std::string text = command.name;
  if (command.arguments.empty() && !command.commands.empty()) return text + " COMMAND ..";
  if (!command.options.empty()) text += " [OPTIONS]";
  for (const OptionText& option : command.options)
    if (option.required) text += fmt::format(" {} {}", option.names.back(), option.value);
  for (const OptionText& a : command.arguments) {
    const std::string value = a.value + (a.repeatable ? ".." : "");
    text += a.required ? " " + value : " [" + value + "]";
  }
  return text;
}

std::string help_text(const CommandText& command) {
  std::string text = fmt::format("{}\n\nUsage: {}\n", command.help, usage(command));
  for (const CommandText& c : command.commands)
    if (!command.arguments.empty()) text += fmt::format("       {}\n", usage(c));
  for (const Section& section : sections(command)) text += plain(section);
  if (!command.examples.empty()) text += "\nExamples:\n" + indented(command.examples);
  Section statuses{"Exit status", {}};
  for (const auto& [status, meaning] : kExitStatuses) statuses.entries.push_back({status, meaning});
  return text + plain(statuses);
}

nlohmann::ordered_json help_json(const CommandText& command) {
  nlohmann::ordered_json json{{"name", command.name}, {"help", command.help}, {"usage", usage(command)}};
  const bool is_program = command.name.find(' ') == std::string::npos;
  if (!is_program) json["group"] = command.group;
  for (const auto& [key, texts] : {std::pair{"arguments", &command.arguments}, std::pair{"options", &command.options}})
    for (const OptionText& option : *texts) {
      nlohmann::ordered_json entry;
      if (!option.names.empty()) entry["names"] = option.names;
      if (!option.value.empty()) entry["value"] = option.value;
      if (!option.words.empty()) entry["words"] = option.words;
      entry["help"] = option.help;
      entry["required"] = option.required;
      entry["repeatable"] = option.repeatable;
      json[key].push_back(std::move(entry));
    }
  if (!command.examples.empty()) json["examples"] = command.examples;
  for (const CommandText& c : command.commands) json["commands"].push_back(help_json(c));
  if (is_program)
    for (const auto& [status, meaning] : kExitStatuses) json["exit_status"][status] = meaning;
  return json;
}

std::string overview(const CommandText& program) {
  std::string text = fmt::format("{}\n\nUsage: {}\n", program.help, usage(program));
  for (const Section& section : sections(program))
    if (section.title != "Options") text += plain(section);
  return text + "\n`prs help COMMAND` says more.\n";
}

std::string manual_file(const CommandText& command) { return page_name(command) + ".1"; }

std::string manual_page(const CommandText& command, std::string_view version) {
  std::string text = fmt::format(".TH {} 1 \"\" \"prs {}\" \"Manual of prs\"\n", escaped(page_name(command)), version);
  text += title("Name") + fmt::format("{} \\- {}\n", escaped(page_name(command)), escaped(command.help));
  text += title("Synopsis") + line(fmt::format("`{}`{}", command.name, usage(command).substr(command.name.size())));
  for (const Section& section : sections(command)) {
    text += title(section.title);
    for (const auto& [term, meaning] : section.entries) text += ".TP\n" + line("`" + term + "`") + line(meaning);
  }
  if (!command.examples.empty()) text += title("Examples") + ".nf\n" + lines_of(command.examples) + ".fi\n";
  text += title("Exit status");
  for (const auto& [status, meaning] : kExitStatuses) text += ".TP\n" + line(status) + line(meaning);
  std::vector<std::string> others;
  for (const CommandText& c : command.commands) others.push_back(fmt::format(".BR {} (1)", escaped(page_name(c))));
  if (command.name != "prs") others.push_back(".BR prs (1)");
  return text + title("See also") + fmt::format("{}\n", fmt::join(others, ",\n"));
}

}  // namespace prs::cli
