#pragma once

#include "prs/json_type.h"
#include "prs/study/designs.h"

namespace prs {

/// A response that the base case does not have: its index in the study, and how to fix it.
class UnknownResponse : public std::runtime_error {
 public:
  UnknownResponse(std::size_t index, const std::string& message) : std::runtime_error(message), index_(index) {}
  std::size_t index() const { return index_; }

 private:
  std::size_t index_;
};

/// Whether responses may be arrays, each entry a column of its own.
enum class Arrays { recorded, refused };

/// Place in the file at which the envelope needs a response, which is then one number.
std::optional<std::string> place_in_envelope(const Study& study, const std::string& response);

/// The columns of numbers that a study records: its responses, or those of its command as far as the
/// base case has them, and of an array `PATH[0]`, `PATH[1]`, .. with as many entries as the design with
/// most threads. `document`: that of the base case; null where it has no answer. `threads`: those of a roller in the
/// base case. Throws UnknownResponse.
std::vector<std::string> recorded_columns(const Study& study, const Json& document, std::size_t threads, Arrays arrays);

/// A number that is recorded, or an array with a column for each entry.
struct Recorded {
  std::string path;       ///< Path of the array: `screw.load_rate_percent`.
  std::size_t first = 0;  ///< Index of its first column.
  std::size_t count = 1;

  bool is_array() const { return count > 1; }
};

/// Three and more columns `PATH[0]`, `PATH[1]`, .. in a row are an array; fewer are numbers that somebody listed.
std::vector<Recorded> recorded(const std::vector<std::string>& columns);

/// Whether columns are those of these responses.
bool are_columns_of(const std::vector<std::string>& responses, const std::vector<std::string>& columns);

}  // namespace prs
