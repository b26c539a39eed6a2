#include "prs/page/live_parts.h"

#include <fcntl.h>

#include <optional>
#include <utility>

#include "prs/embed.h"
#include "prs/file_descriptor.h"

PRS_EMBED(own_source_id, "source_id")

namespace prs {
namespace {

constexpr std::size_t kLargestPart = 16'000'000;  ///< Size in bytes.

}  // namespace

std::string source_id() { return std::string(own_source_id()); }

LiveParts read_live_parts(const std::filesystem::path& folder) {
  bool complete = !folder.empty();
  const auto read = [&](const char* name) {
    const std::string path = (folder / name).string();
    const RegularFile opened = open_regular(path.c_str(), O_RDONLY);
    throw_if_scarce(opened.error, path);
    std::optional<std::string> content;
    if (opened.file.is_open()) content = content_of(opened.file, kLargestPart);
    complete = complete && content && !content->empty();
    return std::move(content).value_or("");
  };
  const std::string id = read("source_id");
  if (complete && id != source_id())
    return {.absent =
                "the engine of live pages is of other sources than this program; `scripts/web.sh` builds it anew"};
  LiveParts parts{.engine = read("engine.wasm.lzma"),
                  .worker = read("worker.js"),
                  .start = read("start.js"),
                  .report = {read("report.js.gz"), read("report.hash")},
                  .mechanism = {read("mechanism.js.gz"), read("mechanism.hash")},
                  .workbench = {read("workbench.js.gz"), read("workbench.hash")}};
  if (!complete) return {.absent = "the engine of live pages is not built; `scripts/web.sh` builds it"};
  return parts;
}

}  // namespace prs
