#include "core/study/tiles/tile_journal.h"

#include <fmt/format.h>
#include <algorithm>
#include <fstream>
#include <iterator>
#include <limits>
#include <sstream>
#include <utility>

#include "core/base/json_number.h"
#include "core/io/files/plain_file.h"

namespace noonmark {

namespace {

nlohmann::json toJson(const ComparedCell& cell) {
    return {cell.centreM.x,         cell.centreM.y,     cell.grossMin,
            cell.referenceGrossMin, cell.continuousMin, cell.referenceContinuousMin};
}

// NaN (not counted) is null in JSON.
double minutesFrom(const nlohmann::json& json) {
    return json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>();
}

ComparedCell comparedCellFrom(const nlohmann::json& json) {
    return {{json.at(0), json.at(1)}, json.at(2), json.at(3), minutesFrom(json.at(4)), json.at(5)};
}

nlohmann::json toJson(const ShadowSums& sums) {
    return {sums.receivers, sums.grossMin, sums.continuousMin, sums.maxGrossMin, sums.maxContinuousMin};
}

ShadowSums sumsFrom(const nlohmann::json& json) {
    return {wholeNumberFrom<std::size_t>(json.at(0)), minutesFrom(json.at(1)), minutesFrom(json.at(2)),
            json.at(3), json.at(4)};
}

nlohmann::json toJson(const ShadedTile& tile) {
    return {{"column", keyOf<TreeColumns>(treeColumnChoices, tile.column)},
            {"sums", toJson(tile.sums)},
            {"months", tile.monthMinutes}};
}

ShadedTile shadedTileFrom(const nlohmann::json& json) {
    const bool isEvergreen =
        json.at("column") == keyOf<TreeColumns>(treeColumnChoices, TreeColumns::evergreen);
    return {isEvergreen ? TreeColumns::evergreen : TreeColumns::seasonal, sumsFrom(json.at("sums")),
            json.at("months").get<std::vector<double>>()};
}

TileResult resultFrom(const nlohmann::json& json) {
    TileResult result{.number = wholeNumberFrom<std::size_t>(json.at("tile")),
                      .sums = sumsFrom(json.at("sums"))};
    if (json.contains("months")) result.monthMinutes = json.at("months").get<std::vector<double>>();
    if (json.contains("figures")) result.figures = json.at("figures").get<std::map<std::string, double>>();
    if (json.contains("lines")) result.lines = wholeNumberFrom<std::size_t>(json.at("lines"));
    if (json.contains("has_trees")) result.hasTrees = json.at("has_trees");
    if (json.contains("with_trees")) {
        for (const nlohmann::json& tile : json.at("with_trees"))
            result.withTrees.push_back(shadedTileFrom(tile));
        result.treesHow = json.at("trees_how");
    }
    result.cost.rays = wholeNumberFrom<std::uint64_t>(json.at("rays"));
    for (const auto& [reason, count] : json.at("skipped").items())
        result.cost.skipped[reason] = wholeNumberFrom<std::uint64_t>(count);
    result.cost.seconds = json.at("stages");
    result.engineKey = json.at("engine");
    result.engine = json.at("engine_settings");
    for (const nlohmann::json& cell : json.at("compared")) result.compared.push_back(comparedCellFrom(cell));
    result.seconds = json.at("seconds");
    result.errorSeconds = json.at("error_seconds");
    if (!json.contains("content")) return result;
    result.contentHash = json.at("content");
    result.fileBytes = wholeNumberFrom<std::uintmax_t>(json.at("file_bytes"));
    result.fileSha256 = json.at("file_sha256");
    return result;
}

}  // namespace

const ShadowSums& TileResult::sumsOf(TreeColumns column) const {
    const auto found = std::ranges::find(withTrees, column, &ShadedTile::column);
    return found == withTrees.end() ? sums : found->sums;
}

const std::vector<double>& TileResult::monthMinutesOf(TreeColumns column) const {
    const auto found = std::ranges::find(withTrees, column, &ShadedTile::column);
    return found == withTrees.end() ? monthMinutes : found->monthMinutes;
}

nlohmann::json toJson(const TileResult& result) {
    nlohmann::json compared = nlohmann::json::array();
    for (const ComparedCell& cell : result.compared) compared.push_back(toJson(cell));
    nlohmann::json json{{"tile", result.number},
                        {"sums", toJson(result.sums)},
                        {"rays", result.cost.rays},
                        {"skipped", result.cost.skipped},
                        {"stages", result.cost.seconds},
                        {"engine", result.engineKey},
                        {"engine_settings", result.engine},
                        {"compared", compared},
                        {"seconds", result.seconds},
                        {"error_seconds", result.errorSeconds}};
    if (!result.monthMinutes.empty()) json["months"] = result.monthMinutes;
    if (!result.figures.empty()) json["figures"] = result.figures;
    if (result.lines > 0) json["lines"] = result.lines;
    if (result.hasTrees) json["has_trees"] = true;
    for (const ShadedTile& tile : result.withTrees) json["with_trees"].push_back(toJson(tile));
    if (!result.withTrees.empty()) json["trees_how"] = result.treesHow;
    if (result.contentHash.empty()) return json;
    json["content"] = result.contentHash;
    json["file_bytes"] = result.fileBytes;
    json["file_sha256"] = result.fileSha256;
    return json;
}

std::optional<TileResult> tileResultFrom(const nlohmann::json& json) try {
    return resultFrom(json);
} catch (const std::exception&) {  // of another structure, or numbers out of range
    return std::nullopt;
}

namespace {

constexpr const char* journalName = "journal.jsonl";

tl::unexpected<Error> notSaved(const std::filesystem::path& folder) {
    return limitReached("Finished tiles cannot be stored: " + lastSystemProblem(), folder.string(),
                        "Choose a folder that you may write to, and check that the disk has space");
}

std::string firstLine(const std::string& studyHash, const TilePlan& plan) {
    return nlohmann::json{
        {"noonmark_tiles", 1}, {"study", studyHash}, {"side", plan.side}, {"tiles", plan.count()}}
        .dump();
}

// Of a folder that a stranger packed: neither it nor its journal leads elsewhere.
Result<void> checkNoLinks(const std::filesystem::path& folder) {
    return checkNoLink(folder).and_then([&] { return checkNoLink(folder / journalName); });
}

// A file whose size the journal does not state counts if it is there.
bool isWhole(const std::filesystem::path& file, const TileResult& result) {
    std::error_code error;
    if (!checkNoLink(file)) return false;
    const auto bytes = std::filesystem::file_size(file, error);
    return !error && (result.fileBytes == 0 || result.fileBytes == bytes);
}

/// All complete lines; a line that a kill truncated is dropped.
std::string wholeLines(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::string text(std::istreambuf_iterator<char>(stream), {});
    text.resize(text.rfind('\n') + 1);  // npos + 1 = 0
    return text;
}

}  // namespace

TileJournal::TileJournal(std::filesystem::path folder, std::optional<LockedFile> file)
    : folder_(std::move(folder)), file_(std::move(file)) {}

Result<TileJournal> TileJournal::open(const std::filesystem::path& folder, const std::string& studyHash,
                                      const TilePlan& plan) {
    const std::filesystem::path file = folder / journalName;
    if (auto plain = checkNoLinks(folder); !plain) return tl::make_unexpected(plain.error());
    std::error_code ignored;
    std::filesystem::create_directories(folder, ignored);
    TileJournal journal(folder, LockedFile(file));
    if (journal.file_->state() == LockedFile::State::failed) return notSaved(folder);
    if (journal.file_->state() == LockedFile::State::usedByOther)
        return limitReached("Another Noonmark process is working on these tiles", folder.string(),
                            "Wait until it has finished, or choose another folder");
    const std::string kept = wholeLines(file), first = firstLine(studyHash, plan);
    if (auto read = journal.read(kept, first, plan); !read) return tl::make_unexpected(read.error());
    if (!journal.file_->shorten(kept.size())) return notSaved(folder);
    if (kept.empty())
        if (auto begun = journal.append(first); !begun) return tl::make_unexpected(begun.error());
    return journal;
}

Result<std::map<std::size_t, TileResult>> TileJournal::peek(const std::filesystem::path& folder,
                                                            const std::string& studyHash,
                                                            const TilePlan& plan) {
    if (auto plain = checkNoLinks(folder); !plain) return tl::make_unexpected(plain.error());
    TileJournal journal(folder, std::nullopt);
    const std::string text = wholeLines(folder / journalName);
    return journal.read(text, firstLine(studyHash, plan), plan).map([&] {
        return std::move(journal.finished_);
    });
}

std::filesystem::path TileJournal::fileIn(const std::filesystem::path& folder, const TileResult& tile) {
    return folder / fmt::format("tile-{:05}.{}", tile.number, tile.lines > 0 ? "jsonl" : "tif");
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
    auto result = tileResultFrom(nlohmann::json::parse(line, nullptr, false));
    if (!result || result->number >= plan.count()) return;
    const std::size_t tile = result->number;
    if (result->empty() || isWhole(fileOf(*result), *result)) finished_[tile] = *std::move(result);
}

std::filesystem::path TileJournal::fileOf(const TileResult& tile) const { return fileIn(folder_, tile); }

Result<void> TileJournal::add(TileResult result) {
    if (auto kept = append(toJson(result).dump()); !kept) return kept;
    const std::size_t tile = result.number;
    finished_[tile] = std::move(result);
    return {};
}

// A line is complete, or a kill truncated it and it is not read again.
Result<void> TileJournal::append(const std::string& line) {
    if (!file_->append(line + '\n')) return notSaved(folder_);
    return {};
}

void TileJournal::remove() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
}

}  // namespace noonmark
