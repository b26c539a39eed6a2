#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <map>
#include <optional>

#include "prs/model/problems.h"

namespace prs::input {

/// Error in the input. `what()` holds one line for each error, each complete in itself: `FILE:LINE:COLUMN: error: KEY:
/// got VALUE; expected WHAT; how to fix it`, and the `--set` argument if it is the cause.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Position in the input: an offset into the file's text; for a `--set` argument, where it takes effect.
struct Place {
  std::size_t offset = 0;
  int argument = -1;  ///< Index of the override; -1 for the file.

  bool operator==(const Place&) const = default;
};

/// Input from a person: one file and the `--set` arguments that change it.
struct Source {
  std::string name;  ///< Name of the file, as given.
  std::string text;
  std::vector<std::string> overrides;  ///< `path=value` each.
  /// Folder of the files that the source names; empty: the folder of `name`.
  std::filesystem::path folder = {};
  /// Texts of the files that the source names, by their names. If set, no other file is read.
  std::optional<std::map<std::string, std::string>> files = {};
};

/// Reads a file of at most 1 MiB. Throws InputError if it is missing, unreadable, too large or not a regular file.
Source load_source(const std::string& file, std::vector<std::string> overrides);

/// Reads a source of at most 1 MiB from a stream; `name`: file name for messages. Throws InputError.
Source read_source(std::istream& in, std::string name, std::vector<std::string> overrides);

/// Makes a source from a text; `name`: file name for messages.
Source source_of_text(std::string name, std::string text, std::vector<std::string> overrides,
                      std::filesystem::path folder = {});

/// Collects errors, so that one run names them all.
class ErrorList {
 public:
  explicit ErrorList(const Source& source) : source_(source) {}

  void add(Place place, std::string_view key, std::string_view message);
  template <class Arg, class... Args>
  void add(Place place, std::string_view key, fmt::format_string<Arg, Args...> message, Arg&& arg, Args&&... args) {
    add(place, key, fmt::format(message, std::forward<Arg>(arg), std::forward<Args>(args)...));
  }

  /// Adds an error that may be the consequence of another: reported only if there is no other.
  void add_consequence(Place place, std::string_view key, std::string_view message);

  [[noreturn]] void fail(Place place, std::string_view key, std::string_view message);
  template <class Arg, class... Args>
  [[noreturn]] void fail(Place place, std::string_view key, fmt::format_string<Arg, Args...> message, Arg&& arg,
                         Args&&... args) {
    fail(place, key, fmt::format(message, std::forward<Arg>(arg), std::forward<Args>(args)...));
  }

  /// Adds the errors of another list on the same source, each moved to the place that `move` gives. Errors that this
  /// list already has are left out.
  void take(const ErrorList& other, const std::function<Place(Place)>& move);

  bool empty() const { return errors_.empty() && consequences_.empty(); }

  /// Text of the first error in the order of places, without its place: `KEY: got VALUE; ..`.
  std::string first() const;

  /// `FILE:LINE:COLUMN`, counted from 1, the column in characters.
  std::string where(Place place) const;

  /// Throws an InputError with the first 20 errors in the order of their places.
  void throw_if_any() const;

 private:
  struct Error {
    Place place;
    Problem problem;

    bool operator==(const Error&) const = default;
  };
  /// Errors to report, in the order of their places; consequences only if there is nothing else.
  std::vector<const Error*> told() const;

  const Source& source_;
  std::vector<Error> errors_;
  std::vector<Error> consequences_;
};

/// `NAME:LINE:COLUMN` of an offset into a text, counted from 1, the column in characters.
std::string place_in(std::string_view name, std::string_view text, std::size_t offset);

/// A text from the input as messages show it: shortened and without control characters.
std::string shown(std::string_view text);

}  // namespace prs::input
