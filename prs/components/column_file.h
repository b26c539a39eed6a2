#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <variant>
#include <vector>

#include "modules/module.h"

namespace prs {

/// A netCDF-4 file of columns of the same length. Columns and attributes come before numbers. All
/// of it throws std::system_error or std::runtime_error that name the file. Without `close` the
/// file is not finished.
class ColumnFile {
 public:
  enum class Type { real, integer, byte };

  /// Integers have the type of the column; a list of one is a scalar.
  using Attribute = std::variant<std::string, std::vector<std::string>, double, unsigned long long,
                                 std::vector<int>>;

  /// Stands for the file itself where a column's number is expected.
  static constexpr int kFile = -1;

  ColumnFile() = default;
  virtual ~ColumnFile() = default;
  ColumnFile(const ColumnFile&) = delete;
  ColumnFile& operator=(const ColumnFile&) = delete;

  virtual void set_length(const std::string& dimension, std::size_t length) = 0;
  virtual int add_column(const std::string& name, Type type) = 0;
  virtual void describe(int column, const char* attribute, const Attribute& value) = 0;

  /// Writes from row `first` on, in the type of the column.
  virtual void write(int column, std::size_t first, std::span<const double> values) = 0;

  virtual void close() = 0;
};

struct NetcdfModule : modules::Module {
  static constexpr modules::Name kName{"prs_netcdf.so", "netCDF", "libnetcdf-dev", ""};

  /// A new file at `path`; messages name it `name`.
  std::unique_ptr<ColumnFile> (*create)(const std::filesystem::path& path,
                                        const std::filesystem::path& name);
};

}  // namespace prs
