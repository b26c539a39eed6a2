#pragma once

#include "prs/model/limits.h"
#include "prs/model/motor_duty.h"
#include "prs/model/study.h"

namespace prs::input {

/// Equidistant values, ends included, as written in the file; a single value has no `steps`.
struct Range {
  double from = 0.0;
  double to = 0.0;
  std::optional<int> steps;
};
/// Values of any kind as written in the file: a list, or a range, ends included, between two numbers with the same
/// unit.
struct WrittenRange {
  enum class Spacing { linear, logarithmic };

  std::string from, to;
  int steps = 2;
  Spacing spacing = Spacing::linear;
};
struct WrittenValues {
  std::vector<std::string> list;
  std::optional<WrittenRange> range;  ///< Range, if not a list.
};

/// A load case as written in the file: a range of forces is not yet expanded.
struct LoadCaseItem {
  std::optional<std::string> name;
  LoadCase::Share share = LoadCase::Share::solved;
  std::optional<Direction> direction;
  Range axial_force;
  std::optional<double> position;
  std::optional<double> speed;
  SpatialLoad spatial;
  std::optional<Travel> travel;
  std::optional<Modes> modes;
};

/// Interval or normal distribution as written in the file.
struct WrittenInterval {
  std::string from, to;
};
struct WrittenNormal {
  std::optional<std::string> mean;
  std::string deviation;
};

/// An input that changes with a factor, as written in the file.
struct CompanionItem {
  std::string path;
  std::optional<std::string> label;
  std::optional<WrittenValues> values;
};

/// A factor of a study as written in the file.
struct FactorItem : CompanionItem {
  std::optional<WrittenInterval> uniform, log_uniform;
  std::optional<WrittenNormal> normal;
  std::optional<std::string> within;
  std::vector<CompanionItem> companions;
  bool together = false, kept = false;
};

/// A point of an envelope and the envelope itself, as written in the file.
struct EnvelopePointItem {
  enum class Wanted { best };

  std::string name;
  std::optional<std::vector<std::string>> at;
  std::optional<Wanted> wanted;
  std::optional<std::vector<Envelope::Target>> reach;
};
struct EnvelopeItem {
  Envelope::Combine combine = Envelope::Combine::product;
  Envelope::Normalise normalise = Envelope::Normalise::rms;
  std::vector<Envelope::Measure> measures;
  std::vector<EnvelopePointItem> points;
};

/// A study as written in the file.
struct StudyItem {
  Command command = Command::slip;
  Plan plan = Plan::one_at_a_time;
  std::optional<int> samples;
  std::int64_t seed = 1;
  std::vector<FactorItem> factors;
  std::optional<std::vector<std::string>> responses;
  std::optional<EnvelopeItem> envelope;
};

/// An input that changes with a variable, as written in the file.
struct LinkedInputItem {
  std::string path;
  std::vector<std::string> values;
};

/// A variable as written in the file.
struct VariableItem {
  std::string path;
  std::optional<std::string> label;
  std::optional<std::string> from, to;
  std::optional<std::vector<std::string>> values;
  std::vector<LinkedInputItem> companions;
};

struct ObjectiveItem {
  std::optional<std::string> minimize, maximize;
};

struct ConstraintItem {
  std::string response;
  std::optional<std::string> name;
  std::optional<std::string> at_least, at_most;
};

struct CompromiseItem {
  Compromise::By by = Compromise::By::ideal;
  std::vector<double> weights;
  std::string of;
};

/// An optimization as written in the file.
struct OptimizeItem {
  Command command = Command::contact;
  std::vector<VariableItem> variables;
  std::vector<ObjectiveItem> objectives;
  std::vector<ConstraintItem> constraints;
  bool thread_constraints = false;
  std::optional<Algorithm> algorithm;
  std::optional<Algorithm> check;
  int population = 40;
  int generations = 50;
  std::int64_t seed = 1;
  CompromiseItem compromise;
};

/// A parameter of a fit as written in the file.
struct FitParameterItem {
  struct Prior {
    std::string mean, deviation;
  };
  enum class Scale { linear, log };

  std::string path, from, to;
  std::optional<std::string> start, label;
  Scale scale = Scale::linear;
  std::optional<Prior> prior;
};

/// Settings of the rows of a curve or a band, as written in the file.
struct FitConditionItem {
  std::string path;
  std::optional<std::string> column, unit, value;
  std::optional<WrittenValues> values;
};

/// A curve of a fit, or a band, as written in the file.
struct FitCurveItem {
  struct Column {
    std::optional<std::string> column, unit;
  };
  struct Along {
    std::string response, column, unit;
  };
  enum class Use { fit, compare };

  std::optional<std::string> name, command;
  std::string file, response;
  Column measured;
  std::vector<FitConditionItem> conditions;
  std::optional<Along> along;
  std::optional<std::string> deviation, loss;
  bool offset = false;
  Use use = Use::fit;
};
struct FitBandItem : FitCurveItem {};

/// A fit as written in the file.
struct FitItem {
  std::vector<FitParameterItem> parameters;
  std::vector<FitCurveItem> curves;
  double level = 0.9;
  int starts = 1;
  std::optional<std::string> profile;
  std::vector<FitBandItem> bands;
};

/// A curve of another program or a test with which `prs compare` compares the case, as written in the file.
struct ReferenceItem {
  struct Column {
    std::optional<std::string> column, unit;
  };
  struct Along {
    std::string column;
    std::optional<std::string> input, unit;
  };

  std::string file;
  std::optional<std::string> name, load_case, response, deviation, tolerance;
  std::optional<Column> measured;
  std::optional<Along> along;
};

/// A file as it is written: `values` does not yet have the load cases.
struct CaseFile {
  Case values;
  std::vector<LoadCaseItem> load_cases;
  std::optional<Limits> limits;
  std::optional<MotorDuty> motor;
  std::optional<StudyItem> study;
  std::optional<OptimizeItem> optimize;
  std::optional<FitItem> fit;
  std::vector<ReferenceItem> references;
  bool speeds_follow_lead = false;  ///< Whether speeds are stated along the axis.
};

}  // namespace prs::input
