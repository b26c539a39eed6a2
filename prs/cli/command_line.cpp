#include "prs/cli/command_line.h"

#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/replace.hpp>
#include <cctype>
#include <charconv>

#include "prs/cli/help.h"
#include "prs/cli/printing.h"
#include "prs/configurations/new_case.h"
#include "prs/input/did_you_mean.h"

namespace prs::cli {
namespace {

using CLI::App;
using CLI::Option;

using input::did_you_mean;
using input::shown;

bool is_argument(const Option& option) { return option.get_positional(); }

std::string path_of(const App& app) {
  const App* parent = app.get_parent();
  return parent == nullptr ? app.get_name() : path_of(*parent) + " " + app.get_name();
}

/// Chain of parsed commands: root, command, its command.
std::vector<const App*> parsed(const App& app) {
  std::vector<const App*> chain{&app};
  while (!chain.back()->get_subcommands().empty()) chain.push_back(chain.back()->get_subcommands().front());
  return chain;
}

std::vector<std::string> words_of(const std::string& type_name) {
  std::vector<std::string> words;
  const bool is_set = type_name.find('|') != std::string::npos &&
                      std::ranges::none_of(type_name, [](unsigned char c) { return std::isupper(c); });
  if (is_set) words = CLI::detail::split(type_name, '|');
  return words;
}

OptionText text_of(const Option& option) {
  OptionText text;
  for (const std::string& name : option.get_snames()) text.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) text.names.push_back("--" + name);
  const bool takes_value = option.get_items_expected_max() > 0;
  if (takes_value) text.value = option.get_type_name();
  text.words = words_of(text.value);
  if (is_argument(option)) text.value = boost::to_upper_copy(option.get_name(true));
  text.help = option.get_description();
  text.required = option.get_required();
  text.repeatable =
      option.get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll || option.get_items_expected_max() > 2;
  text.optional_value = takes_value && option.get_items_expected_min() == 0;
  return text;
}

/// `--output` of `--output: At Most 1 required` or `--json was given ..`.
std::string named(const CLI::ParseError& error) {
  const std::string what = error.what();
  const std::string name = what.substr(0, what.find_first_of(": "));
  const bool is_flag = what.find("disallowed flag override") != std::string::npos;
  return is_flag && !name.starts_with('-') ? "--" + name : name;
}

/// An unexpected word or option.
struct Extra {
  std::size_t depth = 0;  ///< Depth of the command that found it.
  std::string text;
};

bool is_option(std::string_view text) { return text.starts_with('-') && text != "-"; }

/// The word in place of a command, if it is none, else the first option, else the first word.
std::optional<Extra> extra(const std::vector<const App*>& chain) {
  std::optional<Extra> first;
  for (std::size_t depth = 0; depth < chain.size(); ++depth)
    for (const std::string& text : chain[depth]->remaining()) {
      if (text == "--") continue;
      if (is_option(text)) return first && chain.size() == 1 ? first : Extra{depth, text};
      if (!first) first = Extra{depth, text};
    }
  return first;
}

/// `; did you mean ..?` or empty.
std::string suggestion(std::string_view word, const std::vector<std::string>& known) {
  const std::string text = did_you_mean(word, {known.begin(), known.end()});
  return text.empty() ? text : "; " + text;
}

/// Suggestion for an option; the dashes, common to all, are left out, as they would make short ones look alike.
std::string option_suggestion(std::string_view name, const App& command) {
  std::vector<std::string> known;
  for (const Option* option : command.get_options())
    for (const std::string& n : option->get_lnames()) known.push_back(n);
  const std::size_t begin = std::min(name.find_first_not_of('-'), name.size());
  std::string text = suggestion(name.substr(begin), known);
  if (const std::size_t quote = text.find('`'); quote != std::string::npos) text.insert(quote + 1, "--");
  return text;
}

/// Commands that take an option, if only one or two do: `prs check`.
std::string commands_with(const std::string& option, const App& program) {
  std::vector<std::string> names;
  for (const App* command : program.get_subcommands({}))
    if (command->get_option_no_throw(option) != nullptr) names.push_back(fmt::format("`{}`", path_of(*command)));
  return names.size() > 3 ? "" : fmt::format("{}", fmt::join(names, " or "));
}

std::string unknown_command(std::string_view word, const std::string& program, const std::vector<std::string>& known) {
  if (word.ends_with(".yaml") || word.ends_with(".yml"))
    return fmt::format("got {}; expected a command before it, for example `{} check {}`", shown(word), program,
                       quoted(shown(word)));
  return fmt::format("got {}; expected a command{}", shown(word), suggestion(word, known));
}

std::string unexpected(const std::vector<const App*>& chain, const Extra& extra) {
  const App& command = *chain[extra.depth];
  if (!is_option(extra.text)) {
    if (extra.depth > 0 || command.get_subcommands({}).empty())
      return fmt::format("got {}; expected no further word", shown(extra.text));
    std::vector<std::string> known;
    for (const App* c : command.get_subcommands({})) known.push_back(c->get_name());
    return unknown_command(extra.text, path_of(command), known);
  }
  const std::string name = extra.text.substr(0, extra.text.find('='));
  for (std::size_t deeper = extra.depth + 1; deeper < chain.size(); ++deeper)
    if (chain[deeper]->get_option_no_throw(name) != nullptr)
      return fmt::format("got {0} before `{1}`; expected it after the command: `{2} .. {0}`", name,
                         chain[deeper]->get_name(), path_of(*chain[deeper]));
  const std::string owners = commands_with(name, *chain.front());
  return fmt::format("got {}; expected an option of `{}`{}", shown(name), path_of(command),
                     owners.empty() ? option_suggestion(name, command) : fmt::format("; {} has it", owners));
}

/// Form of the option in help: `--output DIR`.
std::string form(const Option& option) {
  const OptionText text = text_of(option);
  return is_argument(option) ? text.value : fmt::format("{} {}", text.names.back(), text.value);
}

std::string message(const CLI::ParseError& error, const std::vector<const App*>& chain) {
  if (const std::optional<Extra> first = extra(chain)) return unexpected(chain, *first);
  const App& command = *chain.back();
  const Option* option = command.get_option_no_throw(named(error));
  if (option == nullptr) return error.what();
  const std::string name = is_argument(*option) ? form(*option) : option->get_name();
  if (dynamic_cast<const CLI::RequiredError*>(&error) != nullptr)
    return fmt::format("{} is missing; expected `{}`", name, usage(describe(command)));
  if (dynamic_cast<const CLI::RequiresError*>(&error) != nullptr) {
    const std::string what = error.what();
    return fmt::format("{} is given alone; expected {} with it", name, what.substr(what.rfind(' ') + 1));
  }
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr) {
    const auto most = static_cast<std::size_t>(option->get_items_expected_max());
    const CLI::results_t& got = option->results();
    if (most == 0) return fmt::format("{}: got a value; expected none", name);
    if (got.size() > most) return fmt::format("{}: got it {} times; expected it once", name, got.size() / most);
    return fmt::format("{}: got {}; expected `{}`", name,
                       got.empty() ? "no value" : shown(fmt::format("{}", fmt::join(got, " "))), form(*option));
  }
  const std::string what = error.what();
  return name + what.substr(what.find(": "));
}

}  // namespace

CommandText describe(const App& app) {
  CommandText text{path_of(app), app.get_group(), app.get_description(), app.get_footer(), {}, {}, {}};
  for (const Option* option : app.get_options())
    (is_argument(*option) ? text.arguments : text.options).push_back(text_of(*option));
  for (const App* command : app.get_subcommands({})) text.commands.push_back(describe(*command));
  return text;
}

const CommandText& find_command(const CommandText& program, std::span<const std::string> words) {
  const CommandText* found = &program;
  for (const std::string& word : words) {
    const auto next = std::ranges::find(found->commands, found->name + " " + word, &CommandText::name);
    if (next == found->commands.end()) {
      std::vector<std::string> known;
      for (const CommandText& c : found->commands) known.push_back(c.name.substr(found->name.size() + 1));
      throw UsageError(unknown_command(word, found->name, known));
    }
    found = &*next;
  }
  return *found;
}

void take_one_of(Option* option, std::vector<std::string> words) {
  option->type_name(fmt::format("{}", fmt::join(words, "|")));
  option->check([words = std::move(words)](const std::string& text) {
    if (std::ranges::find(words, text) != words.end()) return std::string();
    return fmt::format("got {}; expected {}{}{}", shown(text), words.size() > 1 ? "one of " : "",
                       fmt::join(words, ", "), suggestion(text, words));
  });
}

void take_whole_number(Option* option, long least, long most) {
  option->type_name("N");
  option->check([=](const std::string& text) {
    long value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc() && end == text.data() + text.size() && value >= least && value <= most)
      return std::string();
    return fmt::format("got {}; expected a whole number from {} to {}", shown(text), least, most);
  });
}

std::optional<int> parse(App& app, int argc, char** argv) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    print(help_text(describe(*parsed(app).back())));
    return kDone;
  } catch (const CLI::CallForVersion& version) {
    print(fmt::format("{}\n", version.what()));
    return kDone;
  } catch (const CLI::ParseError& error) {
    return report_usage(app, message(error, parsed(app)));
  }
  return std::nullopt;
}

int report_usage(const App& app, std::string_view message) {
  std::string help = "prs help";
  if (const std::string path = path_of(*parsed(app).back()); path != "prs") help += path.substr(path.find(' '));
  say(fmt::format("prs: error: {}{} `{}`\n", message, message.ends_with('?') ? " See" : "; see", help));
  return kWrongInput;
}

void fail_option(std::string_view option, std::string_view message) { throw UsageError("{}: {}", option, message); }

std::string quoted(std::string word) {
  constexpr std::string_view kPlain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-./=:,+@%[]";
  if (word.size() > 1 && word.starts_with('-')) word.insert(0, "./");
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
  boost::replace_all(word, "'", "'\\''");
  return "'" + word + "'";
}

double quantity_option(std::string_view option, const std::string& text, const input::Dimension& dimension,
                       const input::Bounds& bounds, std::string_view expected) {
  try {
    return quantity_of_option(option, text, dimension, bounds, expected);
  } catch (const CaseError& error) {
    fail_option(error.path(), error.what());
  }
}

}  // namespace prs::cli
