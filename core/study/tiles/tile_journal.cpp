#include "core/study/tiles/tile_journal.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <iterator>
#include <sstream>
#include <system_error>
#include <utility>

namespace noonmark {

using Json = nlohmann::json;

namespace {

tl::unexpected<Error> notSaved(const std::filesystem::path& folder) {
    return failure("Finished tiles cannot be stored: " + std::system_category().message(errno),
                   folder.string(),
                   "Choose a folder that you may write to, and check that the disk has space");
}

std::string firstLine(const std::string& studyHash, const TilePlan& plan) {
    return Json{{"noonmark_tiles", 1}, {"study", studyHash}, {"side", plan.side}, {"tiles", plan.count()}}
        .dump();
}

/// All complete lines; a line that a kill truncated is dropped.
std::string wholeLines(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::string text(std::istreambuf_iterator<char>(stream), {});
    text.resize(text.rfind('\n') + 1);  // npos + 1 = 0
    return text;
}

}  // namespace

TileJournal::TileJournal(std::filesystem::path folder, int file) : folder_(std::move(folder)), file_(file) {}

TileJournal::TileJournal(TileJournal&& other) noexcept
    : folder_(std::move(other.folder_)),
      file_(std::exchange(other.file_, -1)),
      finished_(std::move(other.finished_)) {}

TileJournal::~TileJournal() {
    if (file_ >= 0) ::close(file_);
}

Result<TileJournal> TileJournal::open(const std::filesystem::path& folder, const std::string& studyHash,
                                      const TilePlan& plan) {
    std::error_code ignored;
    std::filesystem::create_directories(folder, ignored);
    const std::filesystem::path file = folder / "journal.jsonl";
    TileJournal journal(folder, ::open(file.c_str(), O_CREAT | O_RDWR | O_APPEND | O_CLOEXEC, 0644));
    if (journal.file_ < 0) return notSaved(folder);
    if (::flock(journal.file_, LOCK_EX | LOCK_NB) != 0)
        return failure("Another Noonmark process is working on these tiles", folder.string(),
                       "Wait until it has finished, or choose another folder");
    const std::string kept = wholeLines(file), first = firstLine(studyHash, plan);
    if (auto read = journal.read(kept, first, plan); !read) return tl::make_unexpected(read.error());
    if (::ftruncate(journal.file_, off_t(kept.size())) != 0) return notSaved(folder);
    if (kept.empty())
        if (auto begun = journal.append(first); !begun) return tl::make_unexpected(begun.error());
    return journal;
}

Result<void> TileJournal::read(const std::string& text, const std::string& first, const TilePlan& plan) {
    std::istringstream lines(text);
    std::string line;
    if (std::getline(lines, line) && line != first)
        return failure(
            "The finished tiles here belong to another study: its city, region, period or settings differ",
            folder_.string(), "Choose another folder, or remove this one");
    while (std::getline(lines, line)) take(line, plan);
    return {};
}

void TileJournal::take(const std::string& line, const TilePlan& plan) {
    auto result = tileResultFrom(Json::parse(line, nullptr, false));
    if (!result || result->number >= plan.count()) return;
    if (result->empty() || std::filesystem::exists(fileOf(result->number)))
        finished_[result->number] = *std::move(result);
}

std::filesystem::path TileJournal::fileOf(std::size_t tile) const {
    return folder_ / fmt::format("tile-{:05}.tif", tile);
}

Result<void> TileJournal::add(TileResult result) {
    if (auto kept = append(toJson(result).dump()); !kept) return kept;
    finished_[result.number] = std::move(result);
    return {};
}

// Written in one call as a rule: a line is complete, or a kill truncated it and it is not read again.
Result<void> TileJournal::append(const std::string& line) {
    const std::string text = line + '\n';
    for (std::size_t done = 0; done < text.size();) {
        const ssize_t wrote = ::write(file_, text.data() + done, text.size() - done);
        if (wrote < 0 && errno != EINTR) return notSaved(folder_);
        done += wrote > 0 ? std::size_t(wrote) : 0;
    }
    return {};
}

void TileJournal::remove() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
}

}  // namespace noonmark
