#include "prs/study/study_run.h"

#include <sched.h>
#include <sys/file.h>

#include <algorithm>
#include <mutex>
#include <thread>

#include "prs/indices.h"

namespace prs {
namespace {

/// Rows of a block for `designs`, which it contains.
RowBlock cropped(const RowBlock& block, DesignRange designs) {
  const std::size_t skipped = designs.first - block.first;
  const std::size_t width = block.responses.size() / block.rows;
  const auto first = block.responses.begin() + static_cast<std::ptrdiff_t>(skipped * width);
  RowBlock rows{designs.first, designs.count, {first, first + static_cast<std::ptrdiff_t>(designs.count * width)}, {}};
  for (const RowBlock::Failure& failure : block.failures)
    if (failure.row >= skipped && failure.row < skipped + designs.count)
      rows.failures.push_back({failure.row - skipped, failure.status});
  return rows;
}

namespace fs = std::filesystem;

/// Designs to distribute, in their order.
class RangeQueue {
 public:
  explicit RangeQueue(std::vector<DesignRange> ranges) : ranges_(std::move(ranges)) {}

  std::optional<DesignRange> next(std::size_t most) {
    if (at_ == ranges_.size()) return std::nullopt;
    DesignRange& rest = ranges_[at_];
    const DesignRange taken{rest.first, std::min(rest.count, most)};
    rest = {taken.end(), rest.count - taken.count};
    if (rest.count == 0) ++at_;
    return taken;
  }

 private:
  std::vector<DesignRange> ranges_;
  std::size_t at_ = 0;
};

/// Journals of the study that others wrote into the folder. Those of other studies are errors if no shard can have left
/// them.
std::vector<Journal> others(const StudyFolder& folder, const JournalHeader& header, const StudyRunOptions& options) {
  std::vector<Journal> journals;
  const fs::path own = journal_path(folder.path(), header.shard);
  const bool alone = folder.use() == StudyFolder::Use::alone;
  for (const fs::path& path : journal_paths(folder.path())) {
    if (path == own) continue;
    if (options.restart) {
      if (alone) fs::remove(path);
      continue;
    }
    Journal journal = Journal::read(path);
    if (journal.header().key.empty()) continue;
    if (alone) journal.require(header);
    if (journal.is_of(header)) journals.push_back(std::move(journal));
  }
  return journals;
}

std::vector<Journal> open_journals(const StudyFolder* folder, const JournalHeader& header,
                                   const StudyRunOptions& options) {
  std::vector<Journal> journals;
  if (folder) journals = others(*folder, header, options);
  journals.push_back(folder ? Journal::append_to(journal_path(folder->path(), header.shard), header, options.restart)
                            : Journal::temporary(header));
  for (const Journal& journal : journals)
    if (journal.is_damaged() && options.warn)
      options.warn(
          fmt::format("{}: warning: damaged; what follows the damage is computed again", journal.path().string()));
  return journals;
}

/// Missing designs of each shard, with as many shards as in the finest division.
std::string missing_shards(const StoredRows& rows, std::size_t designs) {
  std::size_t shards = 1;
  for (const Journal& journal : rows.journals()) shards = std::max(shards, journal.header().shard.count);
  const std::vector<DesignRange> gaps = rows.missing({0, designs});
  constexpr std::size_t kMostNamed = 20;
  std::size_t incomplete = 0;
  std::string text;
  auto gap = gaps.begin();
  for (std::size_t k = 0; k < shards && gap != gaps.end(); ++k) {
    const Shard shard{k, shards};
    const DesignRange all = part(designs, shard);
    std::size_t absent = 0;
    for (; gap != gaps.end() && gap->first < all.end(); ++gap) {
      absent += std::min(gap->end(), all.end()) - std::max(gap->first, all.first);
      if (gap->end() > all.end()) break;  // The gap continues in the next shard.
    }
    if (absent == 0 || ++incomplete > kMostNamed) continue;
    text += fmt::format("\n  shard {}: {} of {} designs are missing", name(shard), absent, all.count);
  }
  if (incomplete > kMostNamed) text += fmt::format("\n  … and {} more", incomplete - kMostNamed);
  return text;
}

/// Blocks in progress per thread: enough that no thread waits for another.
constexpr std::size_t kBlocksPerThread = 4;

/// PipelineModule::run on items that are kept here. A single thread does not need the module.
template <class Item, class Give, class Prepare, class Take>
void run_pipeline(std::size_t threads, bool in_order, const Give& give, const Prepare& prepare, const Take& take) {
  std::vector<Item> items(threads == 1 ? 1 : kBlocksPerThread * threads);
  if (threads == 1) {
    for (Item& item = items.front(); give(item); take(item)) prepare(item);
    return;
  }
  modules::loaded<PipelineModule>().run(
      threads, items.size(), in_order, [&](std::size_t k) { return give(items[k]); },
      [&](std::size_t k) { prepare(items[k]); }, [&](std::size_t k) { take(items[k]); });
}

}  // namespace

StoredRows::StoredRows(std::vector<Journal> journals) : journals_(std::move(journals)) {
  std::vector<Piece> records;
  for (const auto j : indices(journals_))
    for (const auto r : indices(journals_[j].records())) records.push_back({j, r, journals_[j].records()[r].designs});
  std::ranges::sort(records, {}, [](const Piece& piece) { return piece.designs.first; });
  std::size_t next = 0;
  for (Piece& piece : records) {
    const std::size_t first = std::max(next, piece.designs.first);
    if (piece.designs.end() <= first) continue;
    piece.designs = {first, piece.designs.end() - first};
    next = piece.designs.end();
    pieces_.push_back(piece);
  }
}

std::vector<DesignRange> StoredRows::missing(DesignRange all) const {
  std::vector<DesignRange> held;
  held.reserve(pieces_.size());
  for (const Piece& piece : pieces_) held.push_back(piece.designs);
  return prs::missing(all, std::move(held));
}

RowBlock StoredRows::block(std::size_t k) const {
  const Piece& piece = pieces_[k];
  const Journal& journal = journals_[piece.journal];
  const Journal::Record& record = journal.records()[piece.record];
  RowBlock block = journal.block(record);
  return piece.designs == record.designs ? block : cropped(block, piece.designs);
}

fs::path journal_path(const fs::path& folder, Shard shard) {
  return folder / fmt::format("study.{}-of-{}.journal", shard.index + 1, shard.count);
}

std::vector<fs::path> journal_paths(const fs::path& folder) {
  std::vector<fs::path> paths;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::string file = entry.path().filename().string();
    if (file.starts_with("study.") && file.ends_with(".journal")) paths.push_back(entry.path());
  }
  std::ranges::sort(paths);
  return paths;
}

StudyFolder::StudyFolder(fs::path path, Use use, const std::string& command)
    : path_(std::move(path)), use_(use), lock_(path_, use == Use::alone ? LOCK_EX : LOCK_SH, {command}) {}

void StudyFolder::remove_journals() const {
  // The names of the files must reach the disk before the journals are removed.
  const FileDescriptor folder(::open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (folder.is_open()) ::fsync(folder.get());
  for (const fs::path& path : journal_paths(path_)) fs::remove(path);
}

StoredRows run_study(const JournalHeader& header, const StudyFolder* folder, const RunDesigns& run,
                     const StudyRunOptions& options) {
  StoredRows found(open_journals(folder, header, options));
  const DesignRange all = part(header.designs, header.shard);
  std::vector<DesignRange> gaps = found.missing(all);
  StudyProgress progress{all.count - count(gaps), all.count - count(gaps), all.count};
  std::vector<Journal> journals = std::move(found).take_journals();
  Journal& own = journals.back();
  RangeQueue queue(std::move(gaps));
  std::mutex mutex;
  const auto next = [&](std::size_t most) -> std::optional<DesignRange> {
    const std::lock_guard lock(mutex);
    if (options.interrupted && options.interrupted()) return std::nullopt;
    return queue.next(most);
  };
  const auto take = [&](const std::string& record) {
    const std::lock_guard lock(mutex);
    own.append(record);
    progress.done += own.records().back().designs.count;
    if (options.progress) options.progress(progress);
  };
  if (options.progress) options.progress(progress);
  if (progress.done < progress.total) run(next, take);
  if (folder) own.sync();
  return StoredRows(std::move(journals));
}

StoredRows gather_rows(const std::vector<fs::path>& folders) {
  std::vector<Journal> journals;
  std::string damaged;
  for (const fs::path& folder : folders) {
    if (!fs::is_directory(folder))
      throw StudyFolderError(fmt::format("{}: error: no such folder; give the folders of the shards", folder.string()));
    for (const fs::path& path : journal_paths(folder)) {
      Journal journal = Journal::read(path);
      if (journal.is_damaged()) damaged += fmt::format("\n  {} is damaged", path.string());
      if (journal.header().key.empty()) continue;
      if (!journals.empty() && !journal.is_of(journals.front().header()))
        throw StudyFolderError(
            fmt::format("{}: error: of another study than {}; remove the one that is out of date, "
                        "and merge again",
                        path.string(), journals.front().path().string()));
      journals.push_back(std::move(journal));
    }
  }
  if (journals.empty())
    throw StudyFolderError(
        fmt::format("{}: error: no journal of a study; give the folders that `prs study FILE --shard i/n "
                    "--output DIR` wrote into",
                    folders.front().string()));
  const JournalHeader header = journals.front().header();
  StoredRows rows(std::move(journals));
  const std::size_t absent = count(rows.missing({0, header.designs}));
  if (absent > 0)
    throw StudyFolderError(
        fmt::format("{}: error: {} of {} designs are missing; run what is missing, and merge again{}{}",
                    folders.front().string(), absent, header.designs, missing_shards(rows, header.designs), damaged));
  return rows;
}

std::size_t available_processors() {
  cpu_set_t own;
  CPU_ZERO(&own);
  if (sched_getaffinity(0, sizeof own, &own) == 0) return static_cast<std::size_t>(CPU_COUNT(&own));
  return std::max(1u, std::thread::hardware_concurrency());  // There are more than the set can hold.
}

std::size_t default_threads() {
  const std::size_t processors = available_processors();
  if (processors == 1) return 1;
  try {
    modules::loaded<PipelineModule>();
  } catch (const modules::Missing&) {
    return 1;
  }
  return processors;
}

void run_schedule(std::size_t threads, std::size_t chunk, const NextRange& next, const Evaluate& evaluate,
                  const TakeRecord& take) {
  struct Block {
    DesignRange designs;
    std::string record;
  };
  const auto give = [&](Block& block) {
    const std::optional<DesignRange> designs = next(chunk);
    block.designs = designs.value_or(DesignRange{});
    return designs.has_value();
  };
  const auto compute = [&](Block& block) {
    DesignRange& rest = block.designs;
    do {
      const RowBlock rows = evaluate(rest.first, rest.count);
      block.record.clear();
      if (rows.rows == 0) return;
      rest = {rest.first + rows.rows, rest.count - rows.rows};
      block.record = encode(rows);
      if (rest.count > 0) take(block.record);
    } while (rest.count > 0);
  };
  run_pipeline<Block>(threads, false, give, compute, [&](const Block& block) {
    if (!block.record.empty()) take(block.record);
  });
}

void run_in_order(std::size_t count, std::size_t threads,
                  const std::function<std::function<void()>(std::size_t)>& prepare) {
  struct Step {
    std::size_t k = 0;
    std::function<void()> run;
  };
  std::size_t next = 0;
  const auto give = [&](Step& step) {
    step.k = next;
    return next++ < count;
  };
  run_pipeline<Step>(
      threads, true, give, [&](Step& step) { step.run = prepare(step.k); },
      [](Step& step) {
        step.run();
        step.run = nullptr;
      });
}

}  // namespace prs
