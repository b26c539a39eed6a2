#pragma once

#include "prs/input/csv_reader.h"
#include "prs/loads/load_analysis.h"
#include "prs/output/files.h"

namespace prs {

/// A number as printed in a source, known up to its last digit.
struct PrintedNumber {
  std::string text;             ///< `3.6062e5`
  std::optional<int> decimals;  ///< Decimals in place of the last digit's, if the source drops zeros.

  double value() const;
  /// Half a unit of the last known digit.
  double half_unit() const;
  /// Whether a computed number rounds to this one.
  bool is_reproduced_by(double computed) const;
  /// Number of known digits, without a leading zero of a number below 1; for 0 its decimals.
  int digits() const;
  /// Number of digits shared with a computed number, counted by the distance in units of the last.
  int agreeing_digits(double computed) const;
  /// Computed minus printed, in units of the last known digit.
  double off(double computed) const;
  /// Power of ten of the last known digit.
  int last_place() const;
};

/// A printed value of a quantity, and its known errors.
struct PrintedValue {
  std::string quantity;  ///< Path in the JSON document: `contact.screw.hertz_constant_N_per_mm1_5`.
  std::string where;     ///< Table or equation of the source.
  PrintedNumber printed;
  std::string differs;                     ///< Reason why the theory does not give it, if so; else empty.
  double off = 0.0;                        ///< Difference in units of its last digit, within one unit.
  std::optional<PrintedNumber> corrected;  ///< Value that it gives instead, from an independent source.
};

/// A case, or formulas that the source's code computes without one, and the numbers printed for it.
struct ReferenceCase {
  std::filesystem::path file;        ///< Empty for formulas.
  std::string formulas;              ///< Source of the formulas: `table 7.1`; empty for a case.
  Command command = Command::solve;  ///< `solve`, `contact` or `slip`
  std::vector<PrintedValue> values;
};

/// Result of a run on a statement that a source makes in words.
struct Verdict {
  enum class Kind { holds, holds_only_with, does_not_hold };
  Kind kind = Kind::does_not_hold;
  std::vector<std::string> only_with = {};  ///< Variants of the model under which it holds.
  std::string evidence = {};                ///< Results of the plain model and of the first variant that holds.
  std::string why = {};                     ///< Reason why it does not hold with the plain model.
};

/// A statement of a source in words, and the name of its check in the source's code.
struct PrintedStatement {
  std::string section;  ///< Section in which the source makes it.
  std::string text;     ///< The source's words.
  std::string check;
  std::string why = {};                           ///< Mechanical reason if it does not hold; shown only then.
  Verdict::Kind expected = Verdict::Kind::holds;  ///< Verdict on record.
};

/// `reference.yaml` of one source.
struct Reference {
  std::filesystem::path folder;
  std::string source = {};  ///< Citation.
  std::vector<ReferenceCase> cases = {};
  std::vector<PrintedStatement> statements = {};
  std::map<std::string, std::string> data = {};  ///< Files below the folder with their SHA-256.
};

/// Reads a `reference.yaml`; unknown, duplicate and missing keys are errors. Throws
/// input::InputError.
Reference read_reference(const std::filesystem::path& file);

/// Comma-separated values below one line of column names, see `input::CsvReader`. Empty fields are refused, as are rows
/// of a different length than the first. All members throw input::InputError, which names file, line and column.
class CsvTable {
 public:
  explicit CsvTable(const std::filesystem::path& file);
  CsvTable(const CsvTable&) = delete;
  CsvTable& operator=(const CsvTable&) = delete;

  std::size_t rows() const { return rows_.size(); }
  /// Index of the column; an error if there is none.
  std::size_t column(std::string_view name) const;
  bool has_column(std::string_view name) const;

  std::string text(std::size_t row, std::size_t column) const;
  /// A finite number and nothing else.
  double number(std::size_t row, std::size_t column) const;
  /// Half a unit of the number's last digit.
  double half_unit(std::size_t row, std::size_t column) const;

  /// Throws an error on a field.
  [[noreturn]] void fail(std::size_t row, std::size_t column, std::string_view message) const;

 private:
  struct Row {
    std::size_t offset = 0;  ///< Offset at which it begins in the file.
    std::vector<std::string> fields;
  };

  /// The next row; none at the end of the file.
  std::optional<Row> next_row();
  [[noreturn]] void fail_at(std::size_t offset, std::string_view key, std::string_view message) const;

  input::Source source_;
  input::CsvReader reader_;  ///< Reads the source's text.
  std::vector<std::string> header_;
  std::vector<Row> rows_;
};

/// Result of a predicate: whether the statement is true of some results, and the numbers that show it.
struct Finding {
  bool holds = false;
  std::string evidence;
};

struct ComparedStatement {
  std::string section;
  std::string text;
  Verdict verdict;
  Verdict::Kind expected = Verdict::Kind::holds;

  bool unexpected() const { return verdict.kind != expected; }
};

/// Statements as predicates on the results of one variant of the model, by the names of the checks.
template <class Results>
using Checks = std::map<std::string_view, std::function<Finding(const Results&)>>;

/// A named set of results; the first one of a list is the plain model.
template <class Results>
struct Variant {
  std::string name;
  Results results;
};

/// Compares a statement with the plain model first, then with the variants.
template <class Results>
Verdict compare(const std::function<Finding(const Results&)>& predicate, const std::string& why,
                const std::vector<Variant<Results>>& variants) {
  Verdict verdict;
  for (const Variant<Results>& variant : variants) {
    const bool plain = &variant == &variants.front();
    const Finding finding = predicate(variant.results);
    if (plain) verdict.evidence = finding.evidence;
    if (!finding.holds) continue;
    if (plain) {
      verdict.kind = Verdict::Kind::holds;
      return verdict;
    }
    if (verdict.only_with.empty()) verdict.evidence += "; " + variant.name + ": " + finding.evidence;
    verdict.kind = Verdict::Kind::holds_only_with;
    verdict.only_with.push_back(variant.name);
  }
  verdict.why = why;
  return verdict;
}

/// The statements that are checked here.
template <class Results>
std::vector<ComparedStatement> compare(const std::vector<PrintedStatement>& statements, const Checks<Results>& checks,
                                       const std::vector<Variant<Results>>& variants) {
  std::vector<ComparedStatement> compared;
  for (const PrintedStatement& s : statements)
    if (const auto check = checks.find(s.check); check != checks.end())
      compared.push_back({s.section, s.text, compare(check->second, s.why, variants), s.expected});
  return compared;
}

/// Numbers that a source's code adds to the printed ones.
struct ValidationTable {
  struct Row {
    std::string label;
    std::vector<double> values;
  };
  std::string title;
  std::vector<std::string> columns;  ///< Headings of labels and values, with units.
  std::vector<Row> rows;
  std::optional<int> decimals = {};  ///< Decimals in the text; six significant digits if absent.
};

enum class Outcome {
  reproduces,
  differs,     ///< Differs as recorded, with a reason; equals a corrected number, if given.
  unexpected,  ///< Not reproduced and not listed, or listed and reproduced all the same.
  missing,     ///< Missing in the result.
  not_built,   ///< Computed by a part that the program omits.
};

const char* name(Outcome outcome);

/// A printed number and the computed one.
struct Comparison {
  std::string case_name;  ///< Case file without its ending; or name of the formulas.
  PrintedValue reference;
  std::optional<double> computed;  ///< Absent if the result does not have the quantity.
  bool is_built = true;            ///< false if the program omits the part that computes it (PRS_FULL).

  Outcome outcome() const;
  bool unexpected() const { return outcome() == Outcome::unexpected || outcome() == Outcome::missing; }
};

/// Results of a source's code on its case and on the data beside it.
struct Supplement {
  std::vector<ComparedStatement> statements = {};
  std::vector<ValidationTable> tables = {};
  std::vector<Figure> figures = {};
  std::vector<OutputFile> files = {};
  std::vector<std::string> not_built = {};  ///< Parts of the source that the program omits (PRS_FULL).
};

/// Results for one folder below `validation/`.
struct SourceReport : Supplement {
  std::string name;    ///< Name of the folder.
  std::string source;  ///< Citation.
  std::vector<Comparison> comparisons;
  std::vector<std::string> changed_data = {};  ///< Files that differ from the record.
  std::size_t data = 0;                        ///< Number of files on record.
};

/// Counts of numbers, statements and files of data, and of their agreement with the record.
struct ValidationSummary {
  std::size_t compared = 0, hold = 0, known_not_to = 0, changed = 0, not_built = 0;

  /// `Compared 512: 440 hold, 72 are known not to, 0 changed.`
  std::string text() const;
};
ValidationSummary summary(const std::vector<SourceReport>& reports);

/// Code that adds to the `reference.yaml` of one folder.
struct SourceExtension {
  std::string folder;
  /// Quantities printed in the source that the JSON document of a result lacks, by key; placed below `derived` there.
  std::function<nlohmann::ordered_json(const Result&)> derived = {};
  /// Results of the source's formulas without a case, by key.
  std::function<nlohmann::ordered_json(const Reference&)> formulas = {};
  std::function<std::vector<ValidationTable>(const Reference&)> tables = {};
  /// Results on the case `subject`.
  std::function<Supplement(const Case&, const Reference&)> supplement = {};
  /// File of that case; empty for the first one of the reference.
  std::string subject = {};
  bool is_built = true;  ///< false if the program omits the code of the source (PRS_FULL).
};

/// Callback with the next source, and the number of finished and of all sources.
using ValidationProgress = std::function<void(const std::string& source, std::size_t done, std::size_t all)>;

/// Runs every folder of `directory` that has a `reference.yaml`, or `directory` itself if it has one. Throws
/// input::InputError.
std::vector<SourceReport> validate(const std::filesystem::path& directory,
                                   const std::vector<SourceExtension>& extensions,
                                   const ValidationProgress& progress = {});

/// The reports as a text, digit by digit.
std::string validation_text(const std::vector<SourceReport>& reports);

nlohmann::ordered_json validation_json(const std::vector<SourceReport>& reports, const DocumentInfo& info);

}  // namespace prs
