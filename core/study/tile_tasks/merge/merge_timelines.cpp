#include "core/study/tile_tasks/merge/merge_tiles.h"

#include <fmt/format.h>

#include <array>
#include <fstream>
#include <nlohmann/json.hpp>
#include <span>
#include <unordered_map>

#include "core/base/csv_text.h"
#include "core/describe/text.h"
#include "core/engines/shade_trees.h"
#include "core/io/files/plain_file.h"
#include "core/io/files/write_text.h"

namespace noonmark {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::array shadowNames{"baseline", "scenario", "incremental", "gained"};
constexpr std::array shadowFields{"enters",     "exits",          "duration_min",    "largest_m2",
                                  "largest_at", "area_hours_m2h", "longest_stay_min"};
constexpr std::array dayFields{"sunlit_min", "theoretical_m2h"},
    coverFields{"full_cover_min", "all_sun_taken_min"};

/// A field of a day or of a kind of shadow, and the ending of its key with trees.
struct TimelineField {
    std::string key, trees;
    [[nodiscard]] std::string name() const { return key + trees; }
};

// Without trees, and then with those that reach places.
std::vector<TimelineField> withTrees(std::span<const char* const> keys, TreeColumns trees) {
    std::vector<std::string> endings{""};
    for (const TreeColumns column : {TreeColumns::evergreen, TreeColumns::seasonal})
        if (isAmong(trees, column)) endings.push_back(suffixOf(column));
    std::vector<TimelineField> fields;
    for (const std::string& ending : endings)
        for (const char* key : keys) fields.push_back({key, ending});
    return fields;
}

/// The columns of the table.
struct TimelineTable {
    explicit TimelineTable(TreeColumns trees)
        : ofCover(withTrees(coverFields, trees)), ofShadow(withTrees(shadowFields, trees)) {}
    std::vector<TimelineField> ofCover, ofShadow;

    [[nodiscard]] std::vector<std::string> columns() const {
        std::vector<std::string> names{"place", "kind", "source", "day", "area_m2"};
        names.insert(names.end(), dayFields.begin(), dayFields.end());
        for (const TimelineField& field : ofCover) names.push_back(field.name());
        for (const char* shadow : shadowNames)
            for (const TimelineField& field : ofShadow)
                names.push_back(fmt::format("{}_{}", shadow, field.name()));
        return names;
    }
};

void addField(CsvText& csv, const Json& of, const std::string& name) {
    const auto found = of.find(name);
    if (found != of.end() && found->is_number())
        csv.number(found->get<double>());
    else
        csv.text(found != of.end() && found->is_string() ? found->get<std::string>() : std::string());
}

// That with trees is that without them where no tree reaches the place.
void addFields(CsvText& csv, const Json& of, const std::vector<TimelineField>& fields, bool hasTrees) {
    for (const TimelineField& field : fields) addField(csv, of, hasTrees ? field.name() : field.key);
}

void addDay(CsvText& csv, const Json& place, const Json& day, const TimelineTable& table) {
    const bool hasTrees = place.contains("trees_used");
    for (const char* name : {"place", "kind", "source"}) addField(csv, place, name);
    addField(csv, day, "day");
    addField(csv, place, "area_m2");
    for (const char* name : dayFields) addField(csv, day, name);
    addFields(csv, day, table.ofCover, hasTrees);
    for (const char* shadow : shadowNames) {
        const bool stated = shadow == shadowNames.front() || !place.at("to").is_null();
        addFields(csv, stated ? day.at(shadow) : Json::object(), table.ofShadow, hasTrees);
    }
    csv.endRow();
}

void addDays(CsvText& csv, const Json& place, const TimelineTable& table) {
    if (!place.contains("days")) return addDay(csv, place, place, table);
    for (const Json& day : place.at("days")) addDay(csv, place, day, table);
}

/// A file that is complete, or not there.
class GrowingFile {
public:
    explicit GrowingFile(fs::path file)
        : file_(std::move(file)), pending_(file_), stream_(pending_.path(), std::ios::binary) {}

    void add(const std::string& text) { stream_ << text; }
    Result<fs::path> finish() {
        stream_.close();
        if (!stream_)
            return limitReached("The file cannot be written", file_.string(),
                                "Check that the disk has space");
        return pending_.commit().map([&] { return file_; });
    }

private:
    fs::path file_;
    PendingFile pending_;
    std::ofstream stream_;
};

/// One run of mergeTimelines().
class TimelineMerge {
public:
    /// `trees`: the columns that trees reach places in.
    TimelineMerge(const fs::path& merged, TreeColumns trees)
        : lines_(merged / "timelines.jsonl"),
          table_(merged / "timelines.csv"),
          columns_(trees),
          csv_(columns_.columns()) {
        table_.add(csv_.take());
    }

    Result<void> addTile(const fs::path& file, std::size_t district) try {
        if (const auto plain = checkPlainFile(file); !plain) return tl::make_unexpected(plain.error());
        std::ifstream stream(file, std::ios::binary);
        if (!stream) return failure("A finished tile cannot be read", file.string(), "Run its task again");
        for (std::string line; std::getline(stream, line);) addPlace(line, district);
        return {};
    } catch (const Json::exception&) {
        return failure("A finished tile is damaged", file.string(), "Remove it and run its task again");
    }

    Result<MergeReport> finish() {
        MergeReport report{.places = places_};
        for (GrowingFile* file : {&lines_, &table_}) {
            auto done = file->finish();
            if (!done) return tl::make_unexpected(done.error());
            report.files.push_back(*std::move(done));
        }
        return report;
    }

private:
    void addPlace(const std::string& line, std::size_t district) {
        const Json place = Json::parse(line);
        std::string feature = place.at("source");
        if (feature.empty()) feature = place.at("place");
        if (firstDistrict_.emplace(std::move(feature), district).first->second != district) return;
        ++places_;
        lines_.add(line + '\n');
        addDays(csv_, place, columns_);
        table_.add(csv_.take());
    }

    GrowingFile lines_, table_;
    TimelineTable columns_;
    CsvText csv_;
    std::unordered_map<std::string, std::size_t>
        firstDistrict_;  ///< by the feature that a place was read from
    std::size_t places_ = 0;
};

}  // namespace

Result<MergeReport> mergeTimelines(const fs::path& folder, const TaskPlan& plan, bool partial,
                                   Progress& progress, const std::stop_token& stop) {
    const auto status = findMergeable(folder, plan, partial);
    if (!status) return tl::make_unexpected(status.error());
    const auto merged = makeMergedFolder(folder);
    if (!merged) return tl::make_unexpected(merged.error());
    TimelineMerge merge(*merged, status->treeColumns());
    std::size_t done = 0;
    for (std::size_t district = 0; district < status->finished.size(); ++district)
        for (const auto& [number, tile] : status->finished[district]) {
            if (stop.stop_requested()) return cancelled();
            progress.report(double(done++) / double(status->doneTiles), NM_TEXT("joining the timelines"));
            if (tile.result.empty()) continue;
            const fs::path file = TileJournal::fileIn(taskFolder(folder, tile.task), tile.result);
            if (auto added = merge.addTile(file, district); !added) return tl::make_unexpected(added.error());
        }
    return merge.finish().map([&](MergeReport report) {
        report.missingTiles = status->allTiles - status->doneTiles;
        return report;
    });
}

}  // namespace noonmark
