#include "prs/cli/program.h"

#include <cstdlib>
#include <exception>
#include <new>
#include <stdexcept>
#include <system_error>

#include "prs/cli/command_line.h"
#include "prs/cli/interruption.h"
#include "prs/cli/resources.h"
#include "simd/instruction_set.h"

namespace prs::cli {
namespace {

/// Prints one line of an error; in pieces if there is no memory for it.
int failed(std::string_view before, std::string_view what, int status) noexcept {
  try {
    say(std::string(before).append(what).append("\n"));
  } catch (const std::bad_alloc&) {
    for (const std::string_view part : {before, what, std::string_view("\n")}) say(part);
  }
  return status;
}

int out_of_memory() noexcept {
  return failed("prs: error: ",
                "out of memory; give the program more, or it less to do at once: a smaller case, "
                "fewer --threads",
                kFailed);
}

/// Ends the program if memory runs out where no exception may leave: while a document is destroyed, and in threads of
/// oneTBB that request more threads.
[[noreturn]] void end_without_memory() {
  int status = kFailed;
  try {
    if (std::current_exception()) throw;
    std::abort();
  } catch (const std::bad_alloc&) {
    status = out_of_memory();
  } catch (const std::exception& error) {
    status = failed("prs: error: ", error.what(), kFailed);
  }
  remove_unfinished();
  ::_exit(status);
}

/// Reports a wrong PRS_INSTRUCTION_SET here, before a kernel reads it in another thread.
void require_instruction_set() {
  try {
    simd::widest();
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
}

/// Fault of a value of this type; empty for none.
std::string fault_of(std::string_view type, const std::string& text) {
  const std::string_view place = type == "DIR"                 ? "a folder"
                                 : type == "PATH"              ? "a file or a folder"
                                 : type.ends_with("FILE")      ? "a file"
                                 : type.find('|') != type.npos ? type
                                                               : "";
  if (text.empty() && !place.empty()) return fmt::format("got nothing; expected {}", place);
  if (!place.empty()) print_on_one_line(text);
  if (std::error_code error;
      type == "DIR" && std::filesystem::exists(text, error) && !std::filesystem::is_directory(text, error))
    return fmt::format("got {}, which is a file; expected a folder; give another name", input::shown(text));
  return {};
}

}  // namespace

CLI::Option* name_value(CLI::Option* option, std::string_view type) {
  return option->type_name(std::string(type))->check([=](const std::string& text) { return fault_of(type, text); });
}

CLI::Option* add_flag(CLI::App& command, const char* name, bool& flag, const char* help) {
  return command.add_flag(name, flag, help)->disable_flag_override();
}

CLI::Option* take_each(CLI::Option* option) { return option->expected(1)->take_all()->allow_extra_args(false); }

void add_json(CLI::App& command, OutputOptions& options) {
  add_flag(command, "--json", options.json, "Print one JSON document and nothing else");
}

void add_quiet(CLI::App& command, OutputOptions& options) {
  add_flag(command, "--quiet", options.quiet, "Print errors only");
}

void add_output_options(CLI::App& command, OutputOptions& options) {
  add_json(command, options);
  add_value(command, "-o,--output", options.output, "DIR", "Write files into this folder");
  add_quiet(command, options);
}

void add_png(CLI::App& command, OutputOptions& options) {
  add_flag(command, "--png", options.png, "Write the pictures as PNG files, too")
      ->needs(command.get_option("--output"));
}

void add_units_option(CLI::App& command, OutputOptions& options) {
  take_one_of(
      command.add_option_function<std::string>(
          "--units",
          [&options](const std::string& system) { options.units = system == "us" ? UnitSystem::us : UnitSystem::si; },
          "Units of tables and of pages: us shows in, lbf, ksi; JSON and CSV are always si"),
      {"si", "us"});
}

void add_csv_options(CLI::App& command, CsvStyle& style) {
  take_one_of(command.add_option_function<std::string>(
                  "--csv", [&style](const std::string& form) { style.european = form == "european"; },
                  "Of CSV files: european has `;` between fields and decimal commas"),
              {"plain", "european"});
  take_whole_number(command.add_option("--csv-digits", style.digits,
                                       "Significant digits in CSV, 17 for the number exactly; default: 10"),
                    1, CsvStyle::kAllDigits);
}

int run_recorded(const std::function<int()>& run, const OutputOptions& options, const std::string& command,
                 const std::string& case_file, const std::vector<std::string>& overrides) {
  open_matrix_cache(options.quiet);
  if (options.png) require_png();
  std::optional<RunFiles> files;
  if (options.output) files.emplace(*options.output, command, case_file, overrides);
  const int status = run();
  if (files)
    for (const std::string& text : files->finish()) note(options, "prs: " + text);
  if (const std::string text = matrix_cache_refusal(); !text.empty()) note(options, "prs: " + text);
  return status;
}

int run_program(int (*run)(int argc, char** argv), int argc, char** argv) {
  if (!reserve_standard_streams()) return kFailed;
  let_writes_fail();
  end_on_interrupt();
  std::set_terminate(end_without_memory);
  try {
    require_instruction_set();
    const int status = run(argc, argv);
    close_output();
    return status;
  } catch (const input::InputError& error) {
    return failed("", error.what(), kWrongInput);
  } catch (const StudyFolderError& error) {
    return failed("", error.what(), kWrongInput);
  } catch (const UsageError& error) {
    return failed("prs: error: ", error.what(), kWrongInput);
  } catch (const Interrupted&) {
    say(interruption_text.load());
    return Interruption::status();
  } catch (const ReaderGone&) {
    return kFailed;
  } catch (const std::bad_alloc&) {
    return out_of_memory();
  } catch (const std::filesystem::filesystem_error& error) {
    const std::filesystem::path path = error.path1().empty() ? "." : error.path1();
    return failed("prs: error: ", fmt::format("'{}': {}", path.string(), error.code().message()), kFailed);
  } catch (const std::exception& error) {
    std::string text = error.what();
    if (text.starts_with("cannot write") && text.find("expected a regular file") == text.npos)
      text += "; check that the place exists, may be written and has room";
    return failed("prs: error: ", text, kFailed);
  } catch (...) {
    return failed("prs: error: ", "of an unknown kind", kFailed);
  }
}

void add_validate_options(CLI::App& command, ValidateOptions& options) {
  add_value(command, "dir", options.folder, "DIR", "Folder of the sources, default: those that come with the program");
  add_output_options(command, options);
  add_png(command, options);
}

}  // namespace prs::cli
