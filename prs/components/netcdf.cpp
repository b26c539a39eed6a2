#include <netcdf.h>
#include <sys/mman.h>

#include <cerrno>
#include <map>
#include <new>
#include <system_error>
#include <utility>

#include "prs/components/components.h"

namespace prs {
namespace {

static_assert(ColumnFile::kFile == NC_GLOBAL);

/// Whether there is memory to spare: HDF5 does not survive running out of it.
bool has_memory() {
  constexpr std::size_t kSpare = std::size_t{16} << 20;
  void* const memory = ::mmap(nullptr, kSpare, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  return memory != MAP_FAILED && ::munmap(memory, kSpare) == 0;
}

void require_memory() {
  if (!has_memory()) throw std::bad_alloc();
  errno = 0;
}

class NetcdfFile : public ColumnFile {
 public:
  NetcdfFile(const std::filesystem::path& path, const std::filesystem::path& name) : name_(name.string()) {
    require_memory();
    require(nc_create(path.c_str(), NC_NETCDF4 | NC_CLOBBER, &id_));
    int old_fill = 0;
    require(nc_set_fill(id_, NC_NOFILL, &old_fill));
  }
  ~NetcdfFile() override {
    if (id_ >= 0 && has_memory()) nc_abort(id_);
  }

  void set_length(const std::string& dimension, std::size_t length) override {
    require(nc_def_dim(id_, dimension.c_str(), length, &dimension_));
  }

  int add_column(const std::string& name, Type type, const std::string& dimension, std::size_t entries) override {
    require_memory();
    const nc_type types[] = {NC_DOUBLE, NC_INT, NC_BYTE};
    int column = 0, dimensions[] = {dimension_, 0};
    if (!dimension.empty() && nc_inq_dimid(id_, dimension.c_str(), &dimensions[1]) != NC_NOERR)
      require(nc_def_dim(id_, dimension.c_str(), entries, &dimensions[1]));
    require(
        nc_def_var(id_, name.c_str(), types[static_cast<int>(type)], dimension.empty() ? 1 : 2, dimensions, &column));
    require(nc_def_var_chunking(id_, column, NC_CONTIGUOUS, nullptr));
    entries_[column] = entries;
    return column;
  }

  void describe(int column, const char* attribute, const Attribute& value) override {
    require_memory();
    std::visit([&](const auto& v) { put(column, attribute, v); }, value);
  }

  void write(int column, std::size_t first, std::span<const double> values) override {
    require_memory();
    const std::size_t entries = entries_.at(column), from[] = {first, 0}, count[] = {values.size() / entries, entries};
    require(nc_put_vara_double(id_, column, from, count, values.data()));
  }

  void close() override {
    require_memory();
    require(nc_close(std::exchange(id_, -1)));
  }

 private:
  void put(int column, const char* attribute, const std::string& text) {
    require(nc_put_att_text(id_, column, attribute, text.size(), text.c_str()));
  }
  void put(int column, const char* attribute, const std::vector<std::string>& texts) {
    std::vector<const char*> pointers;
    for (const std::string& text : texts) pointers.push_back(text.c_str());
    require(nc_put_att_string(id_, column, attribute, pointers.size(), pointers.data()));
  }
  void put(int column, const char* attribute, double value) {
    require(nc_put_att_double(id_, column, attribute, NC_DOUBLE, 1, &value));
  }
  void put(int column, const char* attribute, unsigned long long value) {
    require(nc_put_att_ulonglong(id_, column, attribute, NC_UINT64, 1, &value));
  }
  void put(int column, const char* attribute, const std::vector<int>& values) {
    nc_type type = NC_INT;
    require(nc_inq_vartype(id_, column, &type));
    require(nc_put_att_int(id_, column, attribute, type, values.size(), values.data()));
  }

  void require(int error) const {
    if (error == NC_NOERR) return;
    const std::string what = "cannot write '" + name_ + "'";
    for (const int reason : {ENOSPC, EDQUOT, EFBIG, EIO, EMFILE, ENFILE})
      if (errno == reason) throw std::system_error(reason, std::generic_category(), what);
    throw std::runtime_error(what + ": " + nc_strerror(error));
  }

  std::string name_;
  int id_ = -1;  ///< Identifier of the open file.
  int dimension_ = 0;
  std::map<int, std::size_t> entries_;  ///< Numbers per row, by column.
};

}  // namespace
}  // namespace prs

extern "C" __attribute__((visibility("default")))
const prs::NetcdfModule prs_module{{}, [](const auto& path, const auto& name) -> std::unique_ptr<prs::ColumnFile> {
                                     return std::make_unique<prs::NetcdfFile>(path, name);
                                   }};
