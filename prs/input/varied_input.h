#pragma once

#include "prs/indices.h"
#include "prs/input/echo.h"

namespace prs::input {

Node scalar(std::string text, Place place);

/// Replaces names of entries in a path by their indices, see `with_indices`; the path as written becomes the label if
/// there is none.
void take_indices(const Node& root, std::string& path, std::optional<std::string>& label);

/// A path that a study or an optimization sets, and its place.
struct SetPath {
  std::string path;
  std::string at;
  std::size_t factor = 0;
  bool companion = false;
};

/// The paths of the factors of a study or the variables of an optimization, a list at `list`.
template <class Items>
std::vector<SetPath> set_paths(const Items& items, std::string_view list) {
  std::vector<SetPath> paths;
  for (const auto i : indices(items)) {
    const std::string at = fmt::format("{}[{}]", list, i);
    paths.push_back({items[i].path, at + ".path", i});
    for (const auto k : indices(items[i].companions))
      paths.push_back({items[i].companions[k].path, fmt::format("{}.with[{}].path", at, k), i, true});
  }
  return paths;
}

/// Whether a path leads to the same value as another one or into it.
bool is_part_of(std::string_view path, std::string_view whole);

/// Adds an error if two paths set the same value in one design. `noun`: a factor or a variable. `one_at_a_time`: each
/// factor and its companions vary alone.
void check_paths(const std::vector<SetPath>& paths, std::string_view noun, bool one_at_a_time, const Node& root,
                 ErrorList& errors);

/// Reads inputs that a study or an optimization sets, one after the other.
class VariedInput {
 protected:
  struct Ends {
    NumberAndUnit from, to;
  };

  /// `base`: the document without the study or the optimization.
  VariedInput(const Source& source, const Node& root, Node& base, ErrorList& errors)
      : source_(source), root_(root), base_(base), errors_(errors) {}

  void refuse_at(std::string_view key, std::string_view message) const;

  /// Whether a path, written under the key, leads to a value of the case itself; adds an error if not.
  bool check_outside(std::string_view key, std::string_view path) const;

  /// Value of a path in the file, or the default.
  std::optional<Node> base_value(std::string_view path, const std::vector<EchoEntry>& fields) const;

  /// Adds errors in a value of a path at the value's place, and returns whether there are none.
  bool check_in_place(const std::string& path, const Node& value) const;

  /// Two numbers in one unit, written under the keys `from` and `to` after the prefix; adds an error if they are not.
  /// The views refer to the texts.
  std::optional<Ends> read_ends(std::string_view prefix, std::string_view from, std::string_view to,
                                bool ascending) const;

  const Source& source_;
  const Node& root_;
  Node& base_;
  ErrorList& errors_;
  std::string path_;  ///< Path of the current item in the document.
};

struct CaseFile;

/// Place in a case file of the value at a path of the input: the kind of number, and its member.
struct Slot {
  enum class Kind {
    none,     ///< Not a value of the input.
    other,    ///< A word, a text or a map.
    number,   ///< A quantity or a bare number.
    whole,    ///< A whole number.
    numbers,  ///< A list of quantities.
  };

  Kind kind = Kind::none;
  const Dimension* dimension = nullptr;  ///< Dimension; null for bare and whole numbers.
  Bounds bounds;                         ///< SI
  std::vector<double*> numbers;          ///< Members; several if one value applies to several parts.
  int* whole = nullptr;
  std::vector<double>* list = nullptr;
};

/// The slot of a path such as `mechanism.pitch_diameter.screw`, in a file that has been read with a value there.
/// Optional values and blocks on the way that the file lacks are created. The number of steps of a range counts as
/// `other`, since it changes the number of load cases.
Slot find_slot(CaseFile& file, std::string_view path);

/// The value [SI] as the reader of the input takes it from the text `NUMBER UNIT`, without unit for a bare number; none
/// if it refuses the text.
std::optional<double> slot_value(const Slot& slot, double number, const Unit* unit);

/// The value [SI] of a text for this slot; none if the reader refuses it.
std::optional<double> slot_value(const Slot& slot, std::string_view text);

/// Sets a slot to a value as `slot_value` gives it.
void set(const Slot& slot, double value);

}  // namespace prs::input
