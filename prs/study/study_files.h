#pragma once

#include "prs/components/column_file.h"
#include "prs/loads/load_json.h"
#include "prs/output/staged_file.h"
#include "prs/study/study_csv.h"
#include "prs/study/study_run.h"

namespace prs {

/// `study.nc`, netCDF-4: the columns of `study.csv` as variables over the dimension `design`, with
/// units and titles. Words are flags, `status` too; reasons stand in `study.csv`. What a design
/// does not have is NaN. Nothing in it depends on when or where it was written.
class StudyNetcdf {
 public:
  /// Study and columns must outlive the object. Errors of all members: std::system_error or
  /// std::runtime_error that names the file; before it is created, modules::Missing.
  StudyNetcdf(const std::filesystem::path& path, const Study& study,
              const std::vector<FactorColumn>& columns, const DocumentInfo& info);

  /// The next block; `factors` are those of `factor_values`.
  void add(const RowBlock& block, const std::vector<double>& factors);

  /// Ends the file and brings it to the disk, under its temporary name.
  void finish();

  /// Gives the file its name.
  void publish();

 private:
  struct Variable {
    int id = 0;
    std::vector<double> values = {};  ///< That are not in the file yet.
  };

  void define(const Study& study, const DocumentInfo& info);
  void define_factor(const Factor& factor, const FactorColumn& column);
  void define_response(const std::string& path);
  void put_flags(int column, const std::vector<std::string>& meanings);
  double flag_of(const std::string& status);
  void flush();

  const NetcdfModule& netcdf_ = modules::loaded<NetcdfModule>();
  StagedFile staged_;
  const std::vector<FactorColumn>& columns_;
  std::unique_ptr<ColumnFile> file_;
  std::vector<Variable> variables_;  ///< Factors, responses, status.
  std::vector<std::string> status_names_;
  std::size_t written_ = 0;
};

/// Takes a block of rows and what its designs set, see `factor_values`.
using TakeRows = std::function<void(const RowBlock& block, std::span<const double> inputs)>;

/// Reads the rows of all designs once, in their order, and gives every block to `add`. With a
/// folder, `study.csv` and `study.nc` are written on the way; they are on the disk when this
/// returns. Returns what was not written, and why: `study.nc` by a build without netCDF. The memory
/// needed does not depend on the number of designs. Throws std::system_error that names a file that
/// cannot be written; earlier files of that name are then as they were.
std::string write_rows(const StoredRows& rows, const Study& study, const DocumentInfo& info,
                       const std::filesystem::path* folder, std::size_t threads,
                       const TakeRows& add, const CsvStyle& style = {});

}  // namespace prs
