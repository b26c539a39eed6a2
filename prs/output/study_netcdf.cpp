#include "prs/output/study_netcdf.h"

#include <fmt/format.h>
#include <netcdf.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <system_error>

#include "fe/newton.h"
#include "prs/quantities/response_title.h"
#include "prs/output/study_json.h"
#include "prs/loads/slip_result.h"

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

}  // namespace

StudyNetcdf::StudyNetcdf(const std::filesystem::path& path, const Study& study,
                         const std::vector<FactorColumn>& columns, const DocumentInfo& info)
    : file_(path), path_(path), columns_(columns), status_names_(known_statuses()) {
  // HDF5 does not survive a full disk. What it finds is dropped when the file is created.
  const std::uint64_t bytes = most_bytes(study, columns, info);
  file_.reserve(bytes);
  require(nc_create(file_.temporary().c_str(), NC_NETCDF4 | NC_CLOBBER, &id_));
  file_.reserve(bytes);
  define(study, info);
}

StudyNetcdf::~StudyNetcdf() {
  if (id_ >= 0) nc_abort(id_);
}

void StudyNetcdf::define(const Study& study, const DocumentInfo& info) {
  int old_fill = 0;
  require(nc_set_fill(id_, NC_NOFILL, &old_fill));
  put_text(NC_GLOBAL, "title", "Study of a planetary roller screw");
  put_text(NC_GLOBAL, "Conventions", "CF-1.10");
  put_text(NC_GLOBAL, "prs_version", info.version);
  put_text(NC_GLOBAL, "schema_version", info.schema_version);
  put_text(NC_GLOBAL, "input_sha256", info.input_sha256);
  if (!info.overrides.empty()) put_texts(NC_GLOBAL, "overrides", info.overrides);
  put_text(NC_GLOBAL, "plan", std::string(name(study.plan)));
  const unsigned long long seed = study.seed;
  if (is_sampled(study.plan))
    require(nc_put_att_ulonglong(id_, NC_GLOBAL, "seed", NC_UINT64, 1, &seed));
  require(nc_def_dim(id_, "design", design_count(study), &dimension_));
  const std::vector<DrawnInput> inputs = drawn_inputs(study);
  for (std::size_t f = 0; f < columns_.size(); ++f) define_factor(*inputs[f].input, columns_[f]);
  for (const std::string& path : study.responses) define_response(path);
  require(nc_def_var(id_, "status", NC_BYTE, 1, &dimension_, &status_id_));
  require(nc_def_var_chunking(id_, status_id_, NC_CONTIGUOUS, nullptr));
  put_text(status_id_, "long_name", "how the design ended");
  put_text(status_id_, "comment", "reasons stand in study.csv");
}

void StudyNetcdf::define_factor(const Factor& factor, const FactorColumn& column) {
  Variable& variable = variables_.emplace_back();
  const nc_type type = column.is_numeric() ? NC_DOUBLE : NC_INT;
  require(nc_def_var(id_, column.name.c_str(), type, 1, &dimension_, &variable.id));
  require(nc_def_var_chunking(id_, variable.id, NC_CONTIGUOUS, nullptr));
  put_text(variable.id, "long_name", factor.label);
  put_text(variable.id, "path", factor.path);
  if (column.is_numeric()) {
    require(nc_put_att_double(id_, variable.id, "_FillValue", NC_DOUBLE, 1, &kNoResponse));
    put_text(variable.id, "units", factor.unit.empty() ? "1" : factor.unit);
  } else {
    if (std::isnan(column.base))
      require(nc_put_att_int(id_, variable.id, "_FillValue", NC_INT, 1, &kNoWord));
    put_flags(variable.id, column.words);
    put_texts(variable.id, "words", column.words);
  }
}

void StudyNetcdf::define_response(const std::string& path) {
  Variable& variable = variables_.emplace_back();
  // A slash would be a group.
  std::string name = path;
  std::ranges::replace(name, '/', '_');
  require(nc_def_var(id_, name.c_str(), NC_DOUBLE, 1, &dimension_, &variable.id));
  require(nc_def_var_chunking(id_, variable.id, NC_CONTIGUOUS, nullptr));
  const ResponseTitle title = response_title(path);
  require(nc_put_att_double(id_, variable.id, "_FillValue", NC_DOUBLE, 1, &kNoResponse));
  put_text(variable.id, "long_name", title.name);
  put_text(variable.id, "units", title.unit.empty() ? "1" : title.unit);
}

void StudyNetcdf::put_text(int variable, const char* name, const std::string& text) {
  require(nc_put_att_text(id_, variable, name, text.size(), text.c_str()));
}

void StudyNetcdf::put_texts(int variable, const char* name, const std::vector<std::string>& texts) {
  std::vector<const char*> pointers;
  for (const std::string& text : texts) pointers.push_back(text.c_str());
  require(nc_put_att_string(id_, variable, name, pointers.size(), pointers.data()));
}

void StudyNetcdf::put_flags(int variable, const std::vector<std::string>& meanings) {
  std::vector<int> values;
  std::string words;
  for (const std::string& meaning : meanings) {
    words += (values.empty() ? "" : " ") + flag_meaning(meaning);
    values.push_back(static_cast<int>(values.size()));
  }
  nc_type type = NC_INT;
  require(nc_inq_vartype(id_, variable, &type));
  require(nc_put_att_int(id_, variable, "flag_values", type, values.size(), values.data()));
  put_text(variable, "flag_meanings", words);
}

signed char StudyNetcdf::flag_of(const std::string& status) {
  const auto found = std::ranges::find(status_names_, status);
  const auto flag = static_cast<signed char>(found - status_names_.begin());
  if (found == status_names_.end()) status_names_.push_back(status);
  return flag;
}

void StudyNetcdf::add(const RowBlock& block, const std::vector<double>& factors) {
  const std::size_t inputs = columns_.size();
  const std::size_t outputs = variables_.size() - inputs;
  for (std::size_t row = 0; row < block.rows; ++row) {
    for (std::size_t f = 0; f < inputs; ++f)
      variables_[f].values.push_back(factors[row * inputs + f]);
    for (std::size_t k = 0; k < outputs; ++k)
      variables_[inputs + k].values.push_back(block.responses[row * outputs + k]);
  }
  const std::size_t first = statuses_.size();
  statuses_.resize(first + block.rows, 0);
  for (const RowBlock::Failure& failure : block.failures)
    statuses_[first + failure.row] = flag_of(failure.status.name);
  if (statuses_.size() >= kRows) flush();
}

void StudyNetcdf::flush() {
  const std::size_t rows = statuses_.size();
  for (std::size_t k = 0; k < variables_.size(); ++k) {
    Variable& variable = variables_[k];
    if (k < columns_.size() && !columns_[k].is_numeric()) {
      std::vector<int> words;
      for (const double value : variable.values)
        words.push_back(value >= 0.0 ? static_cast<int>(value) : kNoWord);
      require(nc_put_vara_int(id_, variable.id, &written_, &rows, words.data()));
    } else {
      require(nc_put_vara_double(id_, variable.id, &written_, &rows, variable.values.data()));
    }
    variable.values.clear();
  }
  require(nc_put_vara_schar(id_, status_id_, &written_, &rows, statuses_.data()));
  statuses_.clear();
  written_ += rows;
}

void StudyNetcdf::finish() {
  if (!statuses_.empty()) flush();
  put_flags(status_id_, status_names_);
  errno = 0;
  require(nc_close(std::exchange(id_, -1)));
  file_.sync();
}

void StudyNetcdf::publish() { file_.publish(); }

void StudyNetcdf::require(int error) const {
  if (error == NC_NOERR) return;
  const std::string what = fmt::format("cannot write '{}'", path_.string());
  for (const int reason : {ENOSPC, EDQUOT, EFBIG, EIO})
    if (errno == reason) throw std::system_error(reason, std::generic_category(), what);
  throw std::runtime_error(fmt::format("{}: {}", what, nc_strerror(error)));
}

}  // namespace prs
