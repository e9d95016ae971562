#include "core/study/tile_tasks/merge/merge_tiles.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <system_error>

#include "core/base/progress_share.h"
#include "core/io/files/pending_file.h"
#include "core/io/files/write_text.h"
#include "core/measures/has_runs.h"
#include "core/study/tile_tasks/merge/cloud_map.h"
#include "core/study/tile_tasks/merge/stac_item.h"
#include "core/study/tile_tasks/merge/tile_mosaic.h"
#include "core/study/tile_tasks/merge/tile_places.h"

namespace noonmark {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// One run of mergeTiles().
class Merge {
public:
    Merge(const fs::path& folder, const TaskPlan& plan, const StudySettings& settings,
          const MergeSettings& merge, Progress& progress, std::stop_token stop)
        : folder_(folder),
          merged_(folder / "merged"),
          plan_(plan),
          settings_(settings),
          merge_(merge),
          progress_(progress),
          stop_(std::move(stop)) {}

    Result<MergeReport> run() {
        auto status = findStatus(folder_, plan_);
        if (!status) return tl::make_unexpected(status.error());
        status_ = *std::move(status);
        report_.missingTiles = status_.allTiles - status_.doneTiles;
        if (!status_.complete() && !merge_.partial)
            return failure(fmt::format("{} of {} tiles are missing", report_.missingTiles, status_.allTiles),
                           folder_.string(),
                           "Run the tasks " + formatRanges(status_.unfinishedTasks) +
                               " again, or merge what there is with --partial");
        std::error_code error;
        fs::create_directories(merged_, error);
        if (error) return limitReached("The folder cannot be made: " + error.message(), merged_.string(), {});
        for (std::size_t i = 0; i < plan_.districts.size(); ++i)
            if (auto done = mergeDistrict(i); !done) return tl::make_unexpected(done.error());
        return writeSummaries().map([&] { return std::move(report_); });
    }

private:
    Result<void> mergeDistrict(std::size_t number) {
        const District& district = plan_.districts[number];
        const auto& finished = status_.finished[number];
        if (finished.empty()) return {};
        TileFiles files;
        ShadowSums sums;
        for (const auto& [tile, done] : finished) {
            sums.add(done.result.sums);
            files[tile] = done.result.empty()
                              ? std::nullopt
                              : std::optional(TileJournal::fileIn(taskFolder(folder_, done.task), tile));
        }
        StudySettings own = settings_;
        own.region = district.region;
        City ground{.frame = district.frame};
        if (!district.terrainHash.empty()) ground.terrain = std::make_shared<const Terrain>();
        const auto sun = computeDaylightSteps(own.period, makeObserver(ground, own), stop_);
        if (!sun) return tl::make_unexpected(sun.error());
        const double sunlit = sun->sunlitMinutes() / double(std::max<std::size_t>(1, sun->dayCount()));
        const ShadowStatistics figures = computeStatistics(sums, sunlit, district.tiles.whole.cellAreaM2());
        addStatistics(district, figures, finished.size());
        return writeMaps(district, files, hasRuns(figures))
            .and_then([&] {
                return writeFile(district.name + "item.json",
                                 makeStacItem(plan_, district, *sun, own.period, figures));
            })
            .and_then([&] { return addPlacesOf(district, files, sunlit); });
    }

    Result<void> writeMaps(const District& district, const TileFiles& files, bool runs) {
        const fs::path map = merged_ / (district.name + "shadow.tif");
        const PendingFile plain(merged_ / (district.name + "plain.tif"));
        ProgressShare share(progress_, std::size_t(&district - plan_.districts.data()),
                            plan_.districts.size());
        return assembleMap(district.tiles, files, district.frame, {plain.path(), merge_.tags, false}, runs,
                           share, stop_)
            .and_then([&] { return writeCloudMap(plain.path(), map, stop_); })
            .and_then([&] {
                report_.files.push_back(map);
                return writeFile(district.name + "shadow.vrt",
                                 makeMosaic(district.tiles, files, district.frame, runs, merged_));
            });
    }

    Result<void> addPlacesOf(const District& district, const TileFiles& files, double sunlit) {
        if (!merge_.places) return {};
        const auto read = readPlaces(*merge_.places, merge_.placeSettings, district.frame, progress_, stop_);
        if (!read) return tl::make_unexpected(read.error());
        return addPlaces(places_, read->places, district.tiles, files, sunlit, progress_, stop_);
    }

    void addStatistics(const District& district, const ShadowStatistics& figures, std::size_t tiles) {
        districts_.push_back({{"name", district.name},
                              {"tiles", tiles},
                              {"receivers", figures.receivers},
                              {"receiver_area_m2", figures.receiverAreaM2},
                              {"shadow_area_m2", figures.shadowAreaM2},
                              {"mean_gross_min", figures.meanGrossMin},
                              {"max_gross_min", figures.maxGrossMin},
                              {"mean_continuous_min", figures.meanContinuousMin},
                              {"max_continuous_min", figures.maxContinuousMin}});
        ShadowStatistics& all = report_.statistics;
        const double before = double(all.receivers), more = double(figures.receivers);
        const auto mean = [&](double a, double b) {
            return before + more > 0 ? (a * before + b * more) / (before + more) : 0;
        };
        all.meanGrossMin = mean(all.meanGrossMin, figures.meanGrossMin);
        all.meanContinuousMin = mean(all.meanContinuousMin, figures.meanContinuousMin);
        all.maxGrossMin = std::max(all.maxGrossMin, figures.maxGrossMin);
        all.maxContinuousMin = std::max(all.maxContinuousMin, figures.maxContinuousMin);
        all.receivers += figures.receivers;
        all.receiverAreaM2 += figures.receiverAreaM2;
        all.shadowAreaM2 += figures.shadowAreaM2;
    }

    Result<void> writeSummaries() {
        const ShadowStatistics& all = report_.statistics;
        const Json json{{"tiles", status_.doneTiles},
                        {"tiles_missing", report_.missingTiles},
                        {"receivers", all.receivers},
                        {"receiver_area_m2", all.receiverAreaM2},
                        {"shadow_area_m2", all.shadowAreaM2},
                        {"mean_gross_min", all.meanGrossMin},
                        {"max_gross_min", all.maxGrossMin},
                        {"mean_continuous_min", all.meanContinuousMin},
                        {"max_continuous_min", all.maxContinuousMin},
                        {"compute_seconds", status_.doneSeconds},
                        {"districts", districts_}};
        return writeFile("statistics.json", json.dump(2) + "\n").and_then([&]() -> Result<void> {
            return merge_.places ? writeFile("places.csv", formatPlaces(places_)) : Result<void>();
        });
    }

    Result<void> writeFile(const std::string& name, const std::string& text) {
        return writeText(merged_ / name, text).map([&] { report_.files.push_back(merged_ / name); });
    }

    fs::path folder_, merged_;
    const TaskPlan& plan_;
    const StudySettings& settings_;
    const MergeSettings& merge_;
    Progress& progress_;
    std::stop_token stop_;
    TaskStatus status_;
    MergeReport report_;
    PlaceShadows places_;
    Json districts_ = Json::array();
};

}  // namespace

Result<MergeReport> mergeTiles(const fs::path& folder, const TaskPlan& plan, const StudySettings& settings,
                               const MergeSettings& merge, Progress& progress, const std::stop_token& stop) {
    return Merge(folder, plan, settings, merge, progress, stop).run();
}

}  // namespace noonmark
