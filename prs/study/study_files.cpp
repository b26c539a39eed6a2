#include "prs/study/study_files.h"

#include <cctype>

#include "prs/output/run_files.h"
#include "prs/record/table_units.h"
#include "prs/study/study_json.h"

namespace prs {
namespace {

/// Designs that are written at once.
constexpr std::size_t kRows = 16'384;

/// Flag of a word that a design does not have.
constexpr int kNoWord = -1;

/// Statuses in the order of their flags; a status that is not among them comes after them.
std::vector<std::string> known_statuses() {
  std::vector<std::string> names{"converged", "refused", "failed"};
  const auto add = [&](std::string_view name) {
    if (std::ranges::find(names, name) == names.end()) names.emplace_back(name);
  };
  for (const fe::NewtonStatus status :
       {fe::NewtonStatus::iteration_limit, fe::NewtonStatus::line_search_failed,
        fe::NewtonStatus::not_positive_definite})
    add(fe::name(status));
  for (const SlipStatus status :
       {SlipStatus::not_computed, SlipStatus::no_equilibrium, SlipStatus::jammed})
    add(name(status));
  return names;
}

/// A word of the CF convention, which has no blanks.
std::string flag_meaning(std::string text) {
  std::ranges::replace_if(
      text,
      [](unsigned char c) {
        return std::isalnum(c) == 0 &&
               std::string_view("_-.+@").find(static_cast<char>(c)) == std::string_view::npos;
      },
      '_');
  return text;
}

/// More than the file can have: rows, texts twice, and what HDF5 needs for each variable.
std::uint64_t most_bytes(const Study& study, const std::vector<FactorColumn>& columns,
                         const DocumentInfo& info) {
  std::uint64_t texts = 0;
  const auto add = [&](const std::string& text) { texts += text.size() + 64; };
  for (const std::string& text : info.overrides) add(text);
  for (const std::string& text : study.responses) add(text);
  for (const DrawnInput& drawn : drawn_inputs(study))
    add(drawn.input->path + drawn.input->label + drawn.input->unit);
  for (const FactorColumn& column : columns)
    for (const std::string& text : column.words) add(text);
  const std::uint64_t variables = columns.size() + study.responses.size() + 1;
  return design_count(study) * variables * sizeof(double) + 4 * texts + 16'384 * variables +
         (1u << 20);
}

/// The files of a study, published together.
struct RowFiles {
  std::filesystem::path folder;
  StagedFile csv;
  std::optional<StudyNetcdf> netcdf;
  std::string absent;  ///< What is not written, and why.

  RowFiles(const std::filesystem::path& below, const Study& study,
           const std::vector<FactorColumn>& columns, const DocumentInfo& info)
      : folder(below), csv(folder / "study.csv") {
    try {
      netcdf.emplace(folder / "study.nc", study, columns, info);
    } catch (const modules::Missing& error) {
      absent = fmt::format("study.nc is not written: {}", error.what());
    }
  }

  void publish() {
    csv.sync();
    if (netcdf) netcdf->finish();
    csv.publish();
    record_written(folder / "study.csv");
    if (!netcdf) return;
    netcdf->publish();
    record_written(folder / "study.nc");
  }
};

}  // namespace

StudyNetcdf::StudyNetcdf(const std::filesystem::path& path, const Study& study,
                         const std::vector<FactorColumn>& columns, const DocumentInfo& info)
    : staged_(path), columns_(columns), status_names_(known_statuses()) {
  // HDF5 does not survive a full disk. What it finds is dropped when the file is created.
  const std::uint64_t bytes = most_bytes(study, columns, info);
  staged_.reserve(bytes);
  file_ = netcdf_.create(staged_.temporary(), path);
  staged_.reserve(bytes);
  define(study, info);
}

void StudyNetcdf::define(const Study& study, const DocumentInfo& info) {
  const auto describe = [&](const char* attribute, const ColumnFile::Attribute& value) {
    file_->describe(ColumnFile::kFile, attribute, value);
  };
  describe("title", "Study of a planetary roller screw");
  describe("Conventions", "CF-1.10");
  describe("prs_version", info.version);
  describe("schema_version", info.schema_version);
  describe("input_sha256", info.input_sha256);
  if (!info.overrides.empty()) describe("overrides", info.overrides);
  describe("plan", std::string(name(study.plan)));
  if (is_sampled(study.plan)) describe("seed", static_cast<unsigned long long>(study.seed));
  file_->set_length("design", design_count(study));
  const std::vector<DrawnInput> inputs = drawn_inputs(study);
  for (std::size_t f = 0; f < columns_.size(); ++f) define_factor(*inputs[f].input, columns_[f]);
  for (const std::string& path : study.responses) define_response(path);
  const int status = file_->add_column("status", ColumnFile::Type::byte);
  variables_.push_back({status});
  file_->describe(status, "long_name", "how the design ended");
  file_->describe(status, "comment", "reasons stand in study.csv");
}

void StudyNetcdf::define_factor(const Factor& factor, const FactorColumn& column) {
  const int id = file_->add_column(
      column.name, column.is_numeric() ? ColumnFile::Type::real : ColumnFile::Type::integer);
  variables_.push_back({id});
  file_->describe(id, "long_name", factor.label);
  file_->describe(id, "path", factor.path);
  if (column.is_numeric()) {
    file_->describe(id, "_FillValue", kNoResponse);
    file_->describe(id, "units", factor.unit.empty() ? "1" : factor.unit);
  } else {
    if (std::isnan(column.base)) file_->describe(id, "_FillValue", std::vector{kNoWord});
    put_flags(id, column.words);
    file_->describe(id, "words", column.words);
  }
}

void StudyNetcdf::define_response(const std::string& path) {
  // A slash would be a group.
  std::string name = path;
  std::ranges::replace(name, '/', '_');
  const int id = file_->add_column(name, ColumnFile::Type::real);
  variables_.push_back({id});
  const ResponseTitle title = response_title(path);
  file_->describe(id, "_FillValue", kNoResponse);
  file_->describe(id, "long_name", title.name);
  file_->describe(id, "units", title.unit.empty() ? "1" : title.unit);
}

void StudyNetcdf::put_flags(int column, const std::vector<std::string>& meanings) {
  std::vector<int> values;
  std::string words;
  for (const std::string& meaning : meanings) {
    words += (values.empty() ? "" : " ") + flag_meaning(meaning);
    values.push_back(static_cast<int>(values.size()));
  }
  file_->describe(column, "flag_values", values);
  file_->describe(column, "flag_meanings", words);
}

double StudyNetcdf::flag_of(const std::string& status) {
  const auto found = std::ranges::find(status_names_, status);
  const auto flag = static_cast<double>(found - status_names_.begin());
  if (found == status_names_.end()) status_names_.push_back(status);
  return flag;
}

void StudyNetcdf::add(const RowBlock& block, const std::vector<double>& factors) {
  const std::size_t inputs = columns_.size(), outputs = variables_.size() - inputs - 1;
  for (std::size_t row = 0; row < block.rows; ++row) {
    for (std::size_t f = 0; f < inputs; ++f) {
      const double value = factors[row * inputs + f];
      const bool is_there = columns_[f].is_numeric() || value >= 0.0;
      variables_[f].values.push_back(is_there ? value : kNoWord);
    }
    for (std::size_t k = 0; k < outputs; ++k)
      variables_[inputs + k].values.push_back(block.responses[row * outputs + k]);
    variables_.back().values.push_back(flag_of(block.status(row).name));
  }
  if (variables_.back().values.size() >= kRows) flush();
}

void StudyNetcdf::flush() {
  const std::size_t rows = variables_.back().values.size();
  for (Variable& variable : variables_) {
    file_->write(variable.id, written_, variable.values);
    variable.values.clear();
  }
  written_ += rows;
}

void StudyNetcdf::finish() {
  flush();
  put_flags(variables_.back().id, status_names_);
  file_->close();
  staged_.sync();
}

void StudyNetcdf::publish() { staged_.publish(); }

std::string write_rows(const StoredRows& rows, const Study& study, const DocumentInfo& info,
                       const std::filesystem::path* folder, std::size_t threads,
                       const TakeRows& add, const CsvStyle& style) {
  const std::vector<FactorColumn> columns = factor_columns(study);
  const StudyCsv csv(study, columns, style);
  std::optional<RowFiles> files;
  if (folder) {
    files.emplace(*folder, study, columns, info);
    files->csv.append(csv.header());
  }
  run_in_order(rows.block_count(), threads, [&](std::size_t k) -> std::function<void()> {
    struct Prepared {
      RowBlock block;
      std::vector<double> inputs;
      std::string text = {};
    };
    auto prepared = std::make_shared<Prepared>(Prepared{rows.block(k), {}});
    const RowBlock& block = prepared->block;
    prepared->inputs = factor_values(study, columns, block.first, block.rows);
    if (files) prepared->text = csv.rows(block, prepared->inputs);
    return [&add, &files, prepared] {
      if (files) {
        files->csv.append(prepared->text);
        if (files->netcdf) files->netcdf->add(prepared->block, prepared->inputs);
      }
      add(prepared->block, prepared->inputs);
    };
  });
  if (!files) return {};
  files->publish();
  return files->absent;
}

}  // namespace prs
