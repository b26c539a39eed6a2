#pragma once

#include <vector>

#include "prs/input/units.h"

namespace prs::input {

struct CaseFile;

/// Where the value at a path of the input is kept in a case file: what a number must be, and where
/// it goes.
struct Slot {
  enum class Kind {
    none,     ///< No value of the input.
    other,    ///< A word, a text or a map.
    number,   ///< A quantity or a bare number.
    whole,    ///< A whole number.
    numbers,  ///< A list of quantities.
  };

  Kind kind = Kind::none;
  const Dimension* dimension = nullptr;  ///< None of bare and whole numbers.
  Bounds bounds;                         ///< SI
  std::vector<double*> numbers;          ///< Several where one value holds for several parts.
  int* whole = nullptr;
  std::vector<double>* list = nullptr;
};

/// The slot of a path such as `mechanism.pitch_diameter.screw`, in a file that has been read with a
/// value there. Optional values and blocks on the way that the file lacks are created. The number
/// of steps of a range counts as `other`, since load cases come and go with it.
Slot find_slot(CaseFile& file, std::string_view path);

/// The value [SI] as the reader of the input takes it for the text `NUMBER UNIT`, without unit for
/// a bare number; nothing where it refuses the text.
std::optional<double> slot_value(const Slot& slot, double number, const Unit* unit);

/// The value [SI] of a text for this slot; nothing where the reader refuses it.
std::optional<double> slot_value(const Slot& slot, std::string_view text);

/// Sets a slot to a value as `slot_value` gives it.
void set(const Slot& slot, double value);

}  // namespace prs::input
