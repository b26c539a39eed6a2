#include "prs/cli/completion.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/replace.hpp>
#include <utility>

#include "prs/cli/commands.h"
#include "prs/cli/help.h"
#include "prs/cli/list.h"
#include "prs/embed.h"

PRS_EMBED(bash_script, "prs/cli/completion.bash")

namespace prs::cli {
namespace {

/// Name of a command without the program: `study merge`.
std::string own_name(const CommandText& command) {
  const std::size_t blank = command.name.find(' ');
  return blank == std::string::npos ? "" : command.name.substr(blank + 1);
}

std::vector<std::string> command_words(const CommandText& command) {
  std::vector<std::string> words;
  for (const CommandText& c : command.commands) words.push_back(last_word(c));
  return words;
}

std::string joined(const std::vector<std::string>& words, std::string_view separator = " ") {
  return fmt::format("{}", fmt::join(words, separator));
}

/// Action of the script that completes a value.
std::string action(const CommandText& program, const OptionText& option) {
  const std::string& value = option.value;
  if (!option.words.empty()) return "words " + joined(option.words);
  if (value == "COMMAND") return "words " + joined(command_words(program));
  for (const auto& [name, offered] :
       {std::pair{"PATH=VALUE", "settings"}, {"DIR|FILE", "files"}, {"FILE", "cases"}, {"DIR", "folders"}})
    if (value == name) return offered;
  const std::string listed = boost::to_lower_copy(value + "s");
  return std::ranges::count(list_words(), listed) > 0 ? "list " + listed : ":";
}

/// Every command except the program itself, subcommands after their command.
std::vector<const CommandText*> all_commands(const CommandText& program) {
  std::vector<const CommandText*> all;
  for (const CommandText& command : program.commands) {
    all.push_back(&command);
    for (const CommandText& c : command.commands) all.push_back(&c);
  }
  return all;
}

std::vector<std::string> option_words(const CommandText& command) {
  std::vector<std::string> words;
  for (const OptionText& option : command.options) words.insert(words.end(), option.names.begin(), option.names.end());
  return words;
}

/// Filter that leaves the names in a list of `prs list`, without headings and explanations.
constexpr const char* kNames = R"(sed -n -e '/^name  /d' -e '/^path  /d' -e 's/^\([^ ][^ ]*\)\(  .*\)\{0,1\}$/\1/p')";

}  // namespace

std::string bash_completion(const CommandText& program) {
  std::vector<std::string> values;
  std::string commands, options, arguments, names;
  const std::vector<const CommandText*> all = all_commands(program);
  for (const CommandText* command : all) {
    const std::string name = own_name(*command);
    const std::size_t blank = name.rfind(' ');
    commands +=
        fmt::format("      {}/{}) command='{}' at=0 ;;\n",
                    blank == std::string::npos ? "" : "'" + name.substr(0, blank) + "'", last_word(*command), name);
    for (const OptionText& option : command->options) {
      if (option.value.empty() || option.optional_value) continue;
      std::vector<std::string> patterns;
      for (const std::string& n : option.names) patterns.push_back(fmt::format("'{} {}'", name, n));
      options += fmt::format("    {}) action='{}' ;;\n", joined(patterns, "|"), action(program, option));
      values.insert(values.end(), patterns.begin(), patterns.end());
    }
    arguments += fmt::format("        '{}')\n", name);
    for (std::size_t k = 0; k < command->arguments.size(); ++k) {
      const OptionText& argument = command->arguments[k];
      std::string offered = action(program, argument);
      if (k == 0 && !command->commands.empty()) offered += " " + joined(command_words(*command));
      arguments +=
          fmt::format("          (( at {} {} )) && action='{}'\n", argument.repeatable ? ">=" : "==", k, offered);
    }
    arguments += "          ;;\n";
    names += fmt::format("          '{}') action='words {}' ;;\n", name, joined(option_words(*command)));
  }
  arguments += fmt::format("        '') action='words {}' ;;\n", joined(command_words(program)));
  names += fmt::format("          '') action='words {}' ;;\n", joined(option_words(program)));
  std::string script(bash_script());
  for (std::string* lines : {&commands, &options, &arguments, &names}) lines->pop_back();
  for (const auto& [mark, text] : {std::pair{"@VALUES@", joined(values, "|")},
                                   {"@COMMANDS@", commands},
                                   {"@OPTIONS@", options},
                                   {"@ARGUMENTS@", arguments},
                                   {"@NAMES@", names},
                                   {"@SED@", std::string(kNames)}})
    boost::replace_all(script, mark, text);
  return script;
}

}  // namespace prs::cli
