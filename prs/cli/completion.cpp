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

/// Completion that a shell offers for a value.
struct Offer {
  enum class Kind { nothing, words, list, settings, cases, files, folders };
  Kind kind = Kind::nothing;
  std::vector<std::string> words;  ///< Offered words; for `list`: the argument of `prs list`.
};

/// Texts for a shell by kind, with a place for the words.
using Actions = std::array<const char*, 7>;
constexpr Actions kBashActions = {":", "words {}", "list {}", "settings", "cases", "files", "folders"};
constexpr Actions kZshActions = {" ",      "({})",     "_prs_list {}", "_prs_settings", "_files -g \"*.(yaml|yml)\"",
                                 "_files", "_files -/"};
constexpr Actions kFishActions = {"",
                                  " -a '{}'",
                                  " -a '(__prs_list {})'",
                                  " -a '(__prs_list inputs)='",
                                  " -a '(__fish_complete_suffix .yaml)'",
                                  " -F",
                                  " -a '(__fish_complete_directories)'"};

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

Offer offer(const CommandText& program, const OptionText& option) {
  using enum Offer::Kind;
  const std::string& value = option.value;
  if (!option.words.empty()) return {words, option.words};
  if (value == "COMMAND") return {words, command_words(program)};
  for (const auto& [name, kind] :
       {std::pair{"PATH=VALUE", settings}, {"DIR|FILE", files}, {"FILE", cases}, {"DIR", folders}})
    if (value == name) return {kind, {}};
  const std::string listed = boost::to_lower_copy(value + "s");
  if (std::ranges::count(list_words(), listed) > 0) return {list, {listed}};
  return {};
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

std::string joined(const std::vector<std::string>& words, std::string_view separator = " ") {
  return fmt::format("{}", fmt::join(words, separator));
}

std::string action(const Actions& actions, const CommandText& program, const OptionText& option) {
  const Offer o = offer(program, option);
  return fmt::format(fmt::runtime(actions[static_cast<std::size_t>(o.kind)]), joined(o.words));
}

using boost::replace_all_copy;

// bash

/// Filter that leaves the names in a list of `prs list`, without headings and explanations.
constexpr const char* kNames = R"(sed -n -e '/^name  /d' -e '/^path  /d' -e 's/^\([^ ][^ ]*\)\(  .*\)\{0,1\}$/\1/p')";

// zsh

/// Text within an argument of `_arguments`, in single quotes.
std::string zsh_text(std::string text) {
  text = replace_all_copy(text, "'", "'\\''");
  for (const char* special : {"[", "]", ":"}) text = replace_all_copy(text, special, std::string("\\") + special);
  return text;
}

std::string zsh_function(const CommandText& command) { return "_prs_" + replace_all_copy(own_name(command), " ", "_"); }

std::string zsh_option(const CommandText& program, const OptionText& option) {
  const std::string text = fmt::format("[{}]", zsh_text(option.help));
  std::string value;
  if (!option.value.empty())
    value = fmt::format("{}{}:{}", option.optional_value ? "::" : ":", zsh_text(option.value),
                        action(kZshActions, program, option));
  if (option.repeatable) return fmt::format(" \\\n    '*{}{}{}'", option.names.back(), text, value);
  std::string specs;
  for (const std::string& name : option.names)
    specs += fmt::format(" \\\n    '({}){}{}{}'", joined(option.names), name, text, value);
  return specs;
}

std::string zsh_command(const CommandText& program, const CommandText& command) {
  std::string text = fmt::format("{}() {{\n", zsh_function(command));
  for (const CommandText& c : command.commands)
    text += fmt::format("  if [[ ${{words[2]}} == {} ]]; then shift words; (( CURRENT-- )); {}; return; fi\n",
                        last_word(c), zsh_function(c));
  text += "  _arguments -s";
  for (const OptionText& option : command.options) text += zsh_option(program, option);
  for (std::size_t k = 0; k < command.arguments.size(); ++k) {
    const OptionText& argument = command.arguments[k];
    std::string offered = action(kZshActions, program, argument);
    if (k == 0 && !command.commands.empty())
      offered =
          fmt::format(" _alternative \"commands:command:({})\" \"files:FILE:_files\"", joined(command_words(command)));
    text +=
        fmt::format(" \\\n    '{}:{}:{}'", argument.repeatable ? "*" : std::to_string(k + 1), argument.value, offered);
  }
  return text + "\n}\n";
}

// fish

std::string fish_text(const std::string& text) {
  return "'" + replace_all_copy(replace_all_copy(text, "\\", "\\\\"), "'", "\\'") + "'";
}

std::string fish_command(const CommandText& program, const CommandText& command) {
  std::string within;
  const std::string name = own_name(command);
  if (!name.empty()) {
    within = "__fish_seen_subcommand_from " + replace_all_copy(name, " ", "; and __fish_seen_subcommand_from ");
    if (!command.commands.empty()) within += "; and not __fish_seen_subcommand_from " + joined(command_words(command));
    within = fmt::format(" -n '{}'", within);
  }
  std::string lines;
  for (const CommandText& c : command.commands)
    lines += fmt::format("complete -c prs{} -a {} -d {}\n", name.empty() ? " -n __fish_use_subcommand" : within,
                         last_word(c), fish_text(c.help));
  for (const OptionText& argument : command.arguments)
    lines += fmt::format("complete -c prs{}{}\n", within, action(kFishActions, program, argument));
  for (const OptionText& option : command.options) {
    lines += "complete -c prs" + (name.empty() ? " -n __fish_use_subcommand" : within);
    for (const std::string& n : option.names)
      lines += n.starts_with("--") ? " -l " + n.substr(2) : " -s " + n.substr(1);
    if (!option.value.empty() && !option.optional_value) lines += " -x";
    lines += action(kFishActions, program, option) + " -d " + fish_text(option.help) + "\n";
  }
  return lines;
}

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
      options += fmt::format("    {}) action='{}' ;;\n", joined(patterns, "|"), action(kBashActions, program, option));
      values.insert(values.end(), patterns.begin(), patterns.end());
    }
    arguments += fmt::format("        '{}')\n", name);
    for (std::size_t k = 0; k < command->arguments.size(); ++k) {
      const OptionText& argument = command->arguments[k];
      std::string offered = action(kBashActions, program, argument);
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
    script = replace_all_copy(script, mark, text);
  return script;
}

std::string zsh_completion(const CommandText& program) {
  std::string text =
      "#compdef prs\n"
      "# Completion of prs in zsh. `prs completion zsh` wrote it.\n"
      "_prs_list() { local -a names=(${(f)\"$(prs list $1 2>/dev/null | @SED@)\"}); compadd -a "
      "names }\n"
      "_prs_settings() { local -a names=(${(f)\"$(prs list inputs 2>/dev/null | @SED@)\"}); "
      "compadd -S = -a names }\n";
  for (const CommandText* command : all_commands(program)) text += zsh_command(program, *command);
  text = replace_all_copy(text, "@SED@", kNames);
  text += "_prs() {\n  local -a commands=(";
  for (const CommandText& command : program.commands)
    text += fmt::format("\n    '{}:{}'", last_word(command), replace_all_copy(command.help, "'", "'\\''"));
  text += "\n  )\n  if (( CURRENT == 2 )); then\n    _describe command commands\n    _arguments -s";
  for (const OptionText& option : program.options) text += zsh_option(program, option);
  return text +
         "\n    return\n  fi\n  shift words\n  (( CURRENT-- ))\n"
         "  (( $+functions[_prs_${words[1]}] )) && _prs_${words[1]}\n}\n"
         "compdef _prs prs\n";
}

std::string fish_completion(const CommandText& program) {
  std::string text =
      "# Completion of prs in fish. `prs completion fish` wrote it.\n"
      "function __prs_list\n    prs list $argv 2>/dev/null | @SED@\nend\n"
      "complete -c prs -f\n" +
      fish_command(program, program);
  text = replace_all_copy(text, "@SED@", kNames);
  for (const CommandText* command : all_commands(program)) text += fish_command(program, *command);
  return text;
}

}  // namespace prs::cli
