#include "core/study/tile_tasks/merge/merge_tiles.h"

#include <fmt/format.h>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <system_error>
#include <vector>

#include "core/base/progress.h"
#include "core/base/safe_text.h"
#include "core/city/trees/tree.h"
#include "core/describe/command_options.h"
#include "core/describe/figure_text.h"
#include "core/describe/text.h"
#include "core/engines/api/shadow_field.h"
#include "core/io/files/plain_file.h"
#include "core/io/files/write_text.h"
#include "core/io/styles/qgis_style.h"
#include "core/io/write_raster.h"
#include "core/measures/shadow_figures.h"
#include "core/measures/statistics.h"
#include "core/receivers/place.h"
#include "core/receivers/place_names.h"
#include "core/receivers/rasterize.h"
#include "core/study/provenance/provenance_texts.h"
#include "core/study/text/error_text.h"
#include "core/study/tiles/tiled_study.h"

namespace noonmark {

namespace {

/// Shadow on a place, from tiles; over districts its sums are added.
struct TiledPlace {
    PlaceKind kind = PlaceKind::other;
    ShadowSums sums;
    double sunlitMinutes = 0;  ///< sum over the receivers of the sunlit minutes of a mean day
    double cellAreaM2 = 1;
};
using PlaceShadows = std::map<std::string, TiledPlace>;  ///< by name

/// The tiles of a map with gross and continuous shadow, or their change.
struct PlaceTiles {
    const TilePlan& plan;
    const TileFiles& files;
    const TileMap& map;  ///< its first band is gross shadow; the next is continuous shadow
    double sunlitMinutesPerDay = 0;
};

using Bands = std::vector<std::vector<float>>;

ShadowSums sumOver(const Footprint& polygon, const Grid& tile, const Bands& bands, std::size_t firstBand) {
    ShadowSums sums;
    forEachRun(polygon, tile, [&](int row, int first, int end) {
        for (int column = first; column < end; ++column) {
            const std::size_t cell = tile.index(column, row);
            const double gross = bands.at(firstBand)[cell], run = bands.at(firstBand + 1)[cell];
            if (std::isnan(gross)) continue;
            sums.add({1, gross, run, gross, run});
        }
    });
    return sums;
}

std::vector<Box2> boxesOfPlaces(const std::vector<Place>& places) {
    std::vector<Box2> boxes;
    for (const Place& place : places) boxes.push_back(bounds(place));
    return boxes;
}

/// Adds the receivers of the tiles whose centres lie in a place. Reads every tile once that a place touches.
/// Places of which no cell is a receiver are listed with none. Error: a tile that cannot be read;
/// cancelled().
Result<void> addPlaces(PlaceShadows& shadows, const std::vector<Place>& places, const PlaceTiles& tiles,
                       Progress& progress, const std::stop_token& stop) {
    const std::vector<Box2> boxes = boxesOfPlaces(places);
    for (const Place& place : places) shadows[place.name].kind = place.kind;
    for (const auto& [number, file] : tiles.files) {
        if (stop.stop_requested()) return cancelled();
        progress.report(double(number) / double(tiles.plan.count()), NM_TEXT("summing up places"));
        if (!file) continue;
        const Grid tile = tiles.plan.tile(number);
        Bands bands;
        for (std::size_t i = 0; i < places.size(); ++i) {
            if (!overlaps(boxes[i], tile)) continue;
            if (bands.empty()) {
                auto read = readGeoTiff(file->path, tile);
                if (!read) return tl::make_unexpected(read.error());
                bands = *std::move(read);
            }
            TiledPlace& shadow = shadows[places[i].name];
            shadow.cellAreaM2 = tile.cellAreaM2();
            for (const Footprint& polygon : places[i].polygons) {
                const ShadowSums sums = sumOver(polygon, tile, bands, file->firstBandOf(tiles.map));
                shadow.sums.add(sums);
                shadow.sunlitMinutes += double(sums.receivers) * tiles.sunlitMinutesPerDay;
            }
        }
    }
    return {};
}

/// A table (CSV): name, kind and the figures of a shadow field, empty where nothing was measured.
std::string formatPlaces(const PlaceShadows& shadows) {
    std::vector<std::string> columns = listColumns(shadowFigures().rows());
    columns.insert(columns.begin(), {"name", "kind"});
    CsvText csv(columns);
    for (const auto& [name, shadow] : shadows) {
        const double sunlit =
            shadow.sums.receivers > 0 ? shadow.sunlitMinutes / double(shadow.sums.receivers) : 0;
        ShadowStatistics figures = computeStatistics(shadow.sums, sunlit, shadow.cellAreaM2);
        for (const Figure& figure : shadowFigures().rows())
            if (figures.receivers == 0 && figure.use == FigureUse::result)  // no shadow is known of it
                figure.set(&figures, std::numeric_limits<double>::quiet_NaN());
        figures.waterM2 = std::numeric_limits<double>::quiet_NaN();  // the cells of a place are all counted
        csv.text(name).text(std::string(nameOf(shadow.kind)));
        addFigures(csv, shadowFigures().of(figures));
        csv.endRow();
    }
    return csv.take();
}

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// One run of mergeTiles().
class Merge {
public:
    Merge(const fs::path& folder, const TaskPlan& plan, const StudySettings& settings,
          const MergeSettings& merge, Progress& progress, std::stop_token stop)
        : folder_(folder),
          plan_(plan),
          settings_(settings),
          merge_(merge),
          progress_(progress),
          stop_(std::move(stop)) {}

    Result<MergeReport> run() {
        auto status = findMergeable(folder_, plan_, merge_.partial);
        if (!status) return tl::make_unexpected(status.error());
        status_ = *std::move(status);
        report_.missingTiles = status_.allTiles - status_.doneTiles;
        treeColumns_ = status_.treeColumns();
        findNamesWithTrees();
        const auto merged = makeMergedFolder(folder_);
        if (!merged) return tl::make_unexpected(merged.error());
        merged_ = *merged;
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
        MonthSums months;
        std::map<std::string, double> ownFigures;
        double waterM2 = 0;
        std::vector<const TileResult*> results;
        for (const auto& [tile, done] : finished) {
            results.push_back(&done.result);
            sums.add(done.result.sums);
            waterM2 += findWaterM2(done.result.cost, district.tiles.whole);
            addUp(ownFigures, done.result);
            months.add(done.result);
            files[tile] =
                done.result.empty()
                    ? std::nullopt
                    : std::optional(TileFile{TileJournal::fileIn(taskFolder(folder_, done.task), done.result),
                                             !done.result.withTrees.empty()});
        }
        StudySettings own = settings_;
        own.region = district.region;
        City ground{.frame = district.frame};
        if (!district.terrainHash.empty()) ground.terrain = std::make_shared<const Terrain>();
        const auto sun = computeDaylightSteps(own.period, makeObserver(ground, own), stop_);
        if (!sun) return tl::make_unexpected(sun.error());
        const double sunlit = sun->sunlitMinutes() / double(std::max<std::size_t>(1, sun->dayCount()));
        ShadowStatistics figures = computeStatistics(sums, sunlit, district.tiles.whole.cellAreaM2());
        figures.waterM2 = waterM2;
        const double cellAreaM2 = district.tiles.whole.cellAreaM2();
        const std::vector<ShadedTiles> withTrees = sumWithTrees(results, treeColumns_, own, *sun, cellAreaM2);
        addStatistics(district, figures, finished.size());
        if (!std::isnan(figures.meanGrossMin)) addTrees(withTrees);  // a score has no minutes of shadow
        addFigures(ownFigures);
        std::vector<TileMap> maps =
            listWrittenMaps(merge_.maps.empty() ? listTileMaps(own, *sun, treeColumns_)
                                                : addMapsWithTrees(merge_.maps, treeColumns_),
                            hasRuns(figures), haveRuns(withTrees));
        for (TileMap& map : maps)
            if (map.name.starts_with(monthMap)) map.colours = makeMonthScale(*sun, merge_.legend);
        return writeMaps(district, files, maps, makeShadowScale(figures, sunlit, merge_.legend))
            .and_then([&]() -> Result<void> {
                if (!own.byMonth) return {};
                return writeFile(district.name + "by_month.csv",
                                 monthsCsv(months.months(own, *sun, cellAreaM2), merge_.provenance,
                                           listMonthsWithTrees(withTrees)));
            })
            .and_then([&] {
                return writeFile(district.name + "item.json",
                                 makeStacItem(plan_, district, maps, *sun, own.period, figures));
            })
            .and_then([&] { return addPlacesOf(district, files, maps, sunlit); });
    }

    Result<void> writeMaps(const District& district, const TileFiles& files, const std::vector<TileMap>& maps,
                           const ColourScale& ofShadow) {
        for (const TileMap& map : maps) {
            const std::string style = rasterStyle(map.colours.value_or(ofShadow));
            auto made = writeMap(district, files, map).and_then([&] {
                return writeFile(district.name + map.name + ".qml", style);
            });
            if (!made) return made;
        }
        return {};
    }

    Result<void> writeMap(const District& district, const TileFiles& files, const TileMap& map) {
        const fs::path cloud = merged_ / (district.name + map.name + ".tif");
        const PendingFile plain(merged_ / (district.name + "plain.tif"));
        ProgressShare share(progress_, std::size_t(&district - plan_.districts.data()),
                            plan_.districts.size());
        return assembleMap(district.tiles, files, district.frame,
                           {plain.path(), makeProvenanceTags(merge_.provenance), false}, map, share, stop_)
            .and_then([&] { return writeCloudMap(plain.path(), cloud, stop_); })
            .and_then([&] {
                report_.files.push_back(cloud);
                return writeFile(district.name + map.name + ".vrt",
                                 makeMosaic(district.tiles, files, district.frame, map, merged_));
            });
    }

    Result<void> addPlacesOf(const District& district, const TileFiles& files,
                             const std::vector<TileMap>& maps, double sunlit) {
        if (!merge_.places) return {};
        const auto read = readPlaces(*merge_.places, merge_.placeSettings, district.frame, progress_, stop_);
        if (!read) return tl::make_unexpected(read.error());
        for (const TileMap& map : maps) {
            if (map.runBands == 0) continue;
            PlaceShadows& places = places_[map.firstBand == 0 ? "" : map.name + "_"];
            const PlaceTiles tiles{district.tiles, files, map, sunlit};
            if (auto added = addPlaces(places, read->places, tiles, progress_, stop_); !added) return added;
        }
        if (!places_.empty()) return {};
        return failure("Places get statistics of shadow, and these tiles have none", merge_.places->string(),
                       fmt::format("Leave {} out", flags::places));
    }

    // Figures with trees are those without in a tile that no tree reaches.
    void addUp(std::map<std::string, double>& sums, const TileResult& tile) const {
        for (const auto& [name, value] : tile.figures) sums[name] += value;
        if (!tile.withTrees.empty()) return;
        for (const std::string& name : namesWithTrees_) {
            const auto without = tile.figures.find(name.substr(0, name.rfind('_')));
            if (without != tile.figures.end()) sums[name] += without->second;
        }
    }

    // The figures that some tile has with trees: "score_m2_seasonal".
    void findNamesWithTrees() {
        for (const auto& finished : status_.finished)
            for (const auto& [tile, done] : finished)
                for (const ShadedTile& with : done.result.withTrees)
                    for (const auto& [name, value] : done.result.figures)
                        if (name.ends_with(suffixOf(with.column))) namesWithTrees_.insert(name);
    }

    void addFigures(const std::map<std::string, double>& figures) {
        if (!figures.empty()) districts_.back()["figures"] = figures;
        for (const auto& [name, value] : figures) report_.figures[name] += value;
    }

    void addStatistics(const District& district, const ShadowStatistics& figures, std::size_t tiles) {
        districts_.push_back({{"name", district.name}, {"tiles", tiles}});
        districts_.back().update(figuresJson(shadowFigures().of(figures)));
        ShadowStatistics& all = report_.statistics;
        const auto before = double(all.receivers), more = double(figures.receivers);
        addPiece(shadowFigures().rows(), &all, before, &figures, more);
    }

    void addTrees(const std::vector<ShadedTiles>& withTrees) {
        for (const ShadedTiles& with : withTrees) {
            districts_.back().update(figuresJson({treeFigures(with.column), &with.statistics}));
            const auto [all, isNew] = withTrees_.try_emplace(with.column);
            addPiece(shadowFigures().rows(), &all->second, double(isNew ? 0 : all->second.receivers),
                     &with.statistics, double(with.statistics.receivers));
        }
    }

    Result<void> writeSummaries() {
        Json json{{"tiles", status_.doneTiles}, {"tiles_missing", report_.missingTiles}};
        json.update(figuresJson(shadowFigures().of(report_.statistics)));
        for (const auto& [column, statistics] : withTrees_)
            json.update(figuresJson({treeFigures(column), &statistics}));
        json["compute_seconds"] = status_.doneSeconds;
        json["districts"] = districts_;
        if (!report_.figures.empty()) json["figures"] = report_.figures;
        json["warnings"] = warningsJson(report_.warnings);
        auto written = writeFile("statistics.json", json.dump(2) + "\n");
        for (const auto& [name, places] : places_)
            if (written) written = writeFile(name + "places.csv", formatPlaces(places));
        return written;
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
    std::map<std::string, PlaceShadows> places_;  ///< by the beginning of their file's name
    Json districts_ = Json::array();
    std::set<std::string> namesWithTrees_;               ///< of the measure's own figures
    TreeColumns treeColumns_ = TreeColumns::without;     ///< that trees reach tiles in
    std::map<TreeColumns, ShadowStatistics> withTrees_;  ///< of these columns
};

}  // namespace

Result<fs::path> makeMergedFolder(const fs::path& plan) {
    fs::path merged = plan / "merged";
    if (auto own = checkNoLink(merged); !own) return tl::make_unexpected(own.error());
    std::error_code error;
    fs::create_directories(merged, error);
    if (error) return limitReached("The folder cannot be made: " + error.message(), merged.string(), {});
    return merged;
}

Result<MergeReport> mergeTiles(const fs::path& folder, const TaskPlan& plan, const StudySettings& settings,
                               const MergeSettings& merge, Progress& progress, const std::stop_token& stop) {
    return Merge(folder, plan, settings, merge, progress, stop).run();
}

}  // namespace noonmark
