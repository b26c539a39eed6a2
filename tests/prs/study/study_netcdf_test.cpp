#include "prs/study/designs.h"
#include "prs/study/study_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netcdf.h>

#include <array>
#include <cmath>
#include <string>
#include <system_error>
#include <utility>

#include "../study/synthetic_study.h"
#include "support/small_files.h"
#include "support/temporary_directory.h"

namespace prs {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

const DocumentInfo kNetcdfInfo{"1.2", "3", "abc", {"a=1", "b=2"}};

void write(const fs::path& path, const Study& study, std::size_t designs, std::size_t rows) {
  const std::vector<FactorColumn> columns = factor_columns(study);
  StudyNetcdf file(path, study, columns, kNetcdfInfo);
  for (std::size_t first = 0; first < designs; first += rows) {
    const std::size_t count = std::min(rows, designs - first);
    file.add(test::synthetic_rows(first, count), factor_values(study, columns, first, count));
  }
  file.finish();
  file.publish();
}

/// A file as another program reads it.
class Reader {
 public:
  explicit Reader(const fs::path& path) { check(nc_open(path.c_str(), NC_NOWRITE, &id_)); }
  ~Reader() { nc_close(id_); }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  std::size_t designs() const {
    int dimension = 0;
    std::size_t length = 0;
    check(nc_inq_dimid(id_, "design", &dimension));
    check(nc_inq_dimlen(id_, dimension, &length));
    return length;
  }
  std::vector<double> values(const char* name) const {
    std::vector<double> values(designs());
    check(nc_get_var_double(id_, variable(name), values.data()));
    return values;
  }
  std::string text(const char* name, const char* attribute) const {
    const int of = name ? variable(name) : NC_GLOBAL;
    std::size_t length = 0;
    if (nc_inq_attlen(id_, of, attribute, &length) != NC_NOERR) return "absent";
    std::string text(length, '\0');
    check(nc_get_att_text(id_, of, attribute, text.data()));
    return text;
  }
  std::vector<std::string> texts(const char* name, const char* attribute) const {
    const int of = name ? variable(name) : NC_GLOBAL;
    std::size_t length = 0;
    check(nc_inq_attlen(id_, of, attribute, &length));
    std::vector<char*> read(length);
    check(nc_get_att_string(id_, of, attribute, read.data()));
    const std::vector<std::string> texts(read.begin(), read.end());
    nc_free_string(length, read.data());
    return texts;
  }
  unsigned long long seed() const {
    unsigned long long seed = 0;
    check(nc_get_att_ulonglong(id_, NC_GLOBAL, "seed", &seed));
    return seed;
  }
  int variable(const char* name) const {
    int variable = -1;
    check(nc_inq_varid(id_, name, &variable));
    return variable;
  }

 private:
  static void check(int error) { EXPECT_EQ(error, NC_NOERR) << nc_strerror(error); }
  int id_ = -1;
};

TEST(StudyNetcdf, HoldsWhatTheDesignsSetAndGave) {
  constexpr std::size_t kDesigns = 40'000;  // More designs than are written at once.
  const test::TemporaryDirectory temporary;
  const fs::path path = temporary.path() / "study.nc";
  const Study study = test::synthetic_study(kDesigns);
  write(path, study, kDesigns, 1000);
  const Reader file(path);
  ASSERT_EQ(file.designs(), kDesigns);
  const std::vector<double> diameter = file.values("mechanism.pitch_diameter.screw_mm");
  const std::vector<double> profile = file.values("mechanism.profile.nut");
  const std::vector<double> status = file.values("status");
  EXPECT_EQ(diameter[0], 30.0);
  EXPECT_EQ(profile[0], 2.0);  // The file's own word comes after the levels.
  const RowBlock rows = test::synthetic_rows(0, kDesigns);
  for (std::size_t k = 1; k < kDesigns; k += 37) {
    const std::vector<Draw> drawn = draws(study, k);
    ASSERT_EQ(diameter[k], drawn[0].number);
    ASSERT_EQ(profile[k], static_cast<double>(drawn[1].level));
  }
  for (std::size_t j = 0; j < test::kResponses; ++j) {
    const std::vector<double> values = file.values(study.responses[j].c_str());
    for (std::size_t k = 0; k < kDesigns; ++k) {
      const double expected = rows.responses[k * test::kResponses + j];
      ASSERT_TRUE(std::isnan(expected) ? std::isnan(values[k]) : values[k] == expected) << k;
    }
  }
  for (std::size_t k = 0; k < kDesigns; ++k) ASSERT_EQ(status[k], k % 97 != 13 ? 0.0 : k % 2 == 0 ? 1.0 : 2.0) << k;
}

TEST(StudyNetcdf, SaysWhatItsNumbersAre) {
  const test::TemporaryDirectory temporary;
  const fs::path path = temporary.path() / "study.nc";
  write(path, test::synthetic_study(200), 200, 200);
  const Reader file(path);
  EXPECT_EQ(file.text(nullptr, "Conventions"), "CF-1.10");
  EXPECT_EQ(file.text(nullptr, "prs_version"), "1.2");
  EXPECT_EQ(file.text(nullptr, "input_sha256"), "abc");
  EXPECT_EQ(file.text(nullptr, "plan"), "monte_carlo");
  EXPECT_EQ(file.seed(), 7u);
  EXPECT_THAT(file.texts(nullptr, "overrides"), testing::ElementsAre("a=1", "b=2"));
  const char* diameter = "mechanism.pitch_diameter.screw_mm";
  EXPECT_EQ(file.text(diameter, "units"), "mm");
  EXPECT_EQ(file.text(diameter, "long_name"), "screw, \"d\"");
  EXPECT_EQ(file.text("axial_stiffness_N_per_um", "units"), "N/µm");
  EXPECT_EQ(file.text("slip.efficiency", "units"), "1");
  EXPECT_EQ(file.text("slip.efficiency", "long_name"), "efficiency");
  EXPECT_THAT(file.texts("mechanism.profile.nut", "words"),
              testing::ElementsAre("straight", "{convex: 6 mm}", "{concave: 7 mm}"));
  EXPECT_EQ(file.text("mechanism.profile.nut", "flag_meanings"), "straight _convex__6_mm_ _concave__7_mm_");
  EXPECT_THAT(file.text("status", "flag_meanings"), testing::StartsWith("converged refused failed iteration_limit"));
}

/// Object headers of an HDF5 file, and the number of them with dates: bit 5 of the flags (HDF5 file format
/// specification 3.0, IV.A.1.b), which follow the signature and the version.
std::pair<int, int> headers_and_dates(const std::string& content) {
  int headers = 0, dates = 0;
  for (std::size_t at = 0; (at = content.find("OHDR", at)) != std::string::npos; at += 4) {
    ++headers;
    dates += (static_cast<unsigned char>(content.at(at + 5)) & 0x20U) != 0U ? 1 : 0;
  }
  return {headers, dates};
}

TEST(StudyNetcdf, HasTheSameBytesAtAnyTimeAndPlace) {
  const test::TemporaryDirectory one, two;
  const Study study = test::synthetic_study(20'000);
  write(one.path() / "study.nc", study, 20'000, 20'000);
  write(two.path() / "other.nc", study, 20'000, 333);
  const std::string content = test::content_of(one.path() / "study.nc");
  EXPECT_TRUE(content == test::content_of(two.path() / "other.nc"));
  const auto [headers, dates] = headers_and_dates(content);
  EXPECT_GT(headers, static_cast<int>(study.responses.size()));
  EXPECT_EQ(dates, 0);
}

TEST(StudyNetcdf, OnAFullDiskTheEarlierFileStays) {
  const test::TemporaryDirectory temporary;
  const fs::path path = temporary.path() / "study.nc";
  write(path, test::synthetic_study(100), 100, 100);
  const std::string before = test::content_of(path);
  for (const rlim_t room : {100, 5'000, 50'000, 500'000, 1'500'000}) {
    const test::SmallFilesOnly full_disk(room);
    try {
      write(path, test::synthetic_study(100'000), 100'000, 1000);
      FAIL() << "written all the same";
    } catch (const std::system_error& error) {
      EXPECT_EQ(error.code(), std::errc::file_too_large) << room;
      EXPECT_THAT(error.what(), HasSubstr(path.string()));
    }
  }
  EXPECT_TRUE(test::content_of(path) == before);
  EXPECT_EQ(std::distance(fs::directory_iterator(temporary.path()), fs::directory_iterator()), 1);
}

}  // namespace
}  // namespace prs
