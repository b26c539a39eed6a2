#include "prs/study/study_files.h"

#include <fmt/format.h>

#include <memory>
#include <optional>

#include "prs/output/run_files.h"
#include "prs/output/staged_file.h"
#include "prs/study/schedule.h"
#include "prs/study/study_csv.h"
#include "prs/study/study_netcdf.h"

namespace prs {
namespace {

/// `envelope.csv` and what it says.
struct EnvelopeFile {
  StagedFile csv;
  GridMapCollector maps;
  CsvStyle style;

  EnvelopeFile(const std::filesystem::path& folder, const Study& study, const CsvStyle& s)
      : csv(folder / "envelope.csv"), maps(study), style(s) {}

  void finish(const Study& study) {
    if (maps.maps())
      csv.append(envelope_csv(study, *maps.maps(), evaluate_envelope(study, *maps.maps()), style));
    csv.sync();
  }
};

/// The files of a study, published together.
struct RowFiles {
  std::filesystem::path folder;
  StagedFile csv;
  std::optional<StudyNetcdf> netcdf;
  std::optional<EnvelopeFile> envelope;
  std::string absent;  ///< What is not written, and why.

  RowFiles(const std::filesystem::path& below, const Study& study,
           const std::vector<FactorColumn>& columns, const DocumentInfo& info,
           const CsvStyle& style)
      : folder(below), csv(folder / "study.csv") {
    try {
      netcdf.emplace(folder / "study.nc", study, columns, info);
    } catch (const modules::Missing& error) {
      absent = fmt::format("study.nc is not written: {}", error.what());
    }
    if (study.envelope) envelope.emplace(folder, study, style);
  }

  void publish(const Study& study) {
    csv.sync();
    if (netcdf) netcdf->finish();
    if (envelope) envelope->finish(study);
    csv.publish();
    record_written(folder / "study.csv");
    if (netcdf) {
      netcdf->publish();
      record_written(folder / "study.nc");
    }
    if (envelope) {
      envelope->csv.publish();
      record_written(folder / "envelope.csv");
    }
  }
};

}  // namespace

std::string write_rows(const StoredRows& rows, const Study& study, const DocumentInfo& info,
                       const std::filesystem::path* folder, std::size_t threads,
                       const TakeRows& add, const CsvStyle& style) {
  const std::vector<FactorColumn> columns = factor_columns(study);
  const StudyCsv csv(study, columns, style);
  std::optional<RowFiles> files;
  if (folder) {
    files.emplace(*folder, study, columns, info, style);
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
        if (files->envelope) files->envelope->maps.add(prepared->block);
      }
      add(prepared->block, prepared->inputs);
    };
  });
  if (!files) return {};
  files->publish(study);
  return files->absent;
}

}  // namespace prs
