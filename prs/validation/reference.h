#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace prs {

/// A number as a source prints it.
struct PrintedValue {
  std::string quantity;  ///< Path in the JSON document: `contact.screw.hertz_constant_N_per_mm1_5`.
  std::string where;     ///< Table or equation of the source.
  std::string printed;   ///< Its digits: their number is the precision of the comparison.
  std::string differs;   ///< Why the theory does not give it, where it does not; else empty.

  double value() const;
  /// Half a unit of the last printed digit.
  double half_unit() const;
};

/// `reference.yaml` of one source: a case and the numbers printed for it.
struct Reference {
  std::string source;
  std::filesystem::path case_file;
  std::vector<PrintedValue> values;
};

/// Reads `reference.yaml`. Throws input::InputError.
Reference read_reference(const std::filesystem::path& file);

}  // namespace prs
