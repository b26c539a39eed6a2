#include "prs/output/files.h"

#include <fmt/format.h>

#include <system_error>

#include "prs/output/run_files.h"
#include "prs/output/staged_file.h"

namespace prs {

namespace {

void publish(const std::filesystem::path& directory, const std::vector<OutputFile>& files) {
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error) throw std::system_error(error, fmt::format("cannot write '{}'", directory.string()));

  std::vector<StagedFile> staged;
  for (const OutputFile& file : files) {
    staged.emplace_back(directory / file.name).append(file.content);
    staged.back().close();
  }
  for (StagedFile& file : staged) file.publish();
}

}  // namespace

void write_files(const std::filesystem::path& directory, const std::vector<OutputFile>& files) {
  publish(directory, files);
  for (const OutputFile& file : files) record_written(directory / file.name);
}

void write_case(const std::filesystem::path& file, const std::string& text) {
  const std::filesystem::path whole = std::filesystem::absolute(file);
  publish(whole.parent_path(), {{whole.filename().string(), text}});
}

}  // namespace prs
