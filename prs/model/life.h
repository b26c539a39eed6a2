#pragma once

#include <vector>

#include "prs/model/load_case.h"

namespace prs {

/// A column of a file of comma-separated values, by its name in the heading.
struct CsvColumn {
  std::string column;
  std::string unit;

  bool operator==(const CsvColumn&) const = default;
};

/// Loads over time or travel, from a file: one row per sample. How far the screw turns between two
/// samples follows from `position`, from `speed` and the time, or from the operation's speed and
/// the time.
struct HistorySource {
  std::string file;                        ///< Relative to the input file.
  std::optional<std::string> sha256 = {};  ///< Of the file that is meant, hexadecimal.
  CsvColumn force;                         ///< > 0 in tension.
  std::optional<CsvColumn> time;
  std::optional<double> interval;  ///< Between two samples [s], in place of `time`.
  std::optional<CsvColumn> position;
  std::optional<CsvColumn> speed;
  /// Who drives, of running loads. By travel: the position grows as the screw moves out at its
  /// loaded end, so that force x change > 0 is driven by the load; a speed counts as in slip.
  enum class DrivenBy { travel, screw, load };
  std::optional<DrivenBy> driven_by;  ///< Absent: travel where position or speed tells it.
  double hysteresis = 0.0;            ///< Ranges up to this are no load cycles [N].
  int bins = 32;                      ///< Classes of the cycle matrix, along range and mean.

  bool operator==(const HistorySource&) const = default;
};

/// A load of a spectrum and how long it acts; one of the last four is given.
struct SpectrumLoad {
  double force = 0.0;  ///< [N], > 0
  Direction direction = Direction::tension;
  std::optional<double> revolutions;     ///< Revolutions of the screw against the nut.
  std::optional<double> distance;        ///< Travel under the load [m].
  std::optional<double> duration;        ///< Time at the operation's speed [s].
  std::optional<double> share;           ///< Share of all revolutions.
  DrivenBy driven_by = DrivenBy::screw;  ///< Of running loads.
};

/// Which temperatures the parts have in `life` with a block `heat`.
enum class LifeTemperatures {
  heat,       ///< Those of the mean heat of the whole spectrum.
  reference,  ///< The reference temperature of all parts.
};

/// Inputs of `prs life`. One of `history` and `spectrum` is given.
struct Life {
  std::optional<HistorySource> history;
  std::vector<SpectrumLoad> spectrum;
  LoadCase::Share share = LoadCase::Share::solved;
  LifeTemperatures temperatures = LifeTemperatures::heat;
  std::optional<double> position;          ///< First roller contact on the nut [m].
  std::optional<double> dynamic_capacity;  ///< C_a of a catalogue [N], in place of Lemor's.
  std::optional<double> static_capacity;   ///< C_0 of a catalogue [N].
  double reliability = 0.90;               ///< Share that shall reach the rated life.
  double modification_factor = 1.0;        ///< a_ISO of ISO 281, of the rated life.
  /// Full mechanism only: the load case whose side loads, misalignment and orbit hold for all
  /// forces.
  std::optional<std::string> load_case;
  /// Whether the temperatures of the parts follow from a block `heat`.
  bool takes_heat(bool has_heat) const {
    return has_heat && share == LoadCase::Share::solved && temperatures == LifeTemperatures::heat;
  }
  double fatigue_slope = 5.0;  ///< k of the equivalent load range: FKM, steel, normal stress.
};

}  // namespace prs
