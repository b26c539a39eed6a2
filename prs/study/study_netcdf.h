#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "prs/components/column_file.h"
#include "prs/loads/load_json.h"
#include "prs/output/staged_file.h"
#include "prs/study/row_block.h"
#include "prs/study/study_columns.h"

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
  ~StudyNetcdf();
  StudyNetcdf(const StudyNetcdf&) = delete;
  StudyNetcdf& operator=(const StudyNetcdf&) = delete;

  /// The next block; `factors` are those of `factor_values`.
  void add(const RowBlock& block, const std::vector<double>& factors);

  /// Ends the file and brings it to the disk, under its temporary name.
  void finish();

  /// Gives the file its name.
  void publish();

 private:
  StudyNetcdf(const NetcdfModule& netcdf, const std::filesystem::path& path, const Study& study,
              const std::vector<FactorColumn>& columns, const DocumentInfo& info);

  struct Variable {
    int id = 0;
    std::vector<double> values = {};  ///< That are not in the file yet.
  };

  void define(const Study& study, const DocumentInfo& info);
  void define_factor(const Factor& factor, const FactorColumn& column);
  void define_response(const std::string& path);
  void put_flags(int column, const std::vector<std::string>& meanings);
  signed char flag_of(const std::string& status);
  void flush();

  StagedFile staged_;
  const std::vector<FactorColumn>& columns_;
  std::unique_ptr<ColumnFile> file_;
  std::vector<Variable> variables_;  ///< Factors, then responses.
  int status_id_ = 0;
  std::vector<signed char> statuses_;  ///< That are not in the file yet.
  std::vector<std::string> status_names_;
  std::size_t written_ = 0;
};

}  // namespace prs
