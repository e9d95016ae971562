#include "core/study/tiles/tiled_study.h"

#include <fmt/format.h>
#include <algorithm>
#include <limits>
#include <utility>

#include "core/base/memory_guard.h"
#include "core/base/progress.h"
#include "core/base/safe_text.h"
#include "core/city/trees/tree.h"
#include "core/describe/command_options.h"
#include "core/describe/figure_text.h"
#include "core/engines/api/shadow_field.h"
#include "core/engines/common/shadow_reach.h"
#include "core/engines/shade_trees.h"
#include "core/measures/shadow_figures.h"
#include "core/study/provenance/provenance_texts.h"
#include "core/study/provenance/repeat_command.h"
#include "core/study/provenance/study_hash.h"
#include "core/study/study_cost.h"
#include "core/study/text/error_text.h"
#include "core/study/tiles/shadow_measure.h"
#include "core/study/tiles/tile_maps.h"
#include "core/study/tiles/tile_runner.h"

namespace noonmark {

void MonthSums::add(const TileResult& tile, const std::vector<double>& minutes) {
    receivers_ += tile.sums.receivers;
    minutes_.resize(std::max(minutes_.size(), minutes.size()));
    for (std::size_t i = 0; i < minutes.size(); ++i) minutes_[i] += minutes[i];
}

TreeColumns findColumns(std::span<const TileResult* const> tiles) {
    const auto reached =
        std::ranges::find_if(tiles, [](const TileResult* tile) { return !tile->withTrees.empty(); });
    if (reached == tiles.end()) return TreeColumns::without;
    const std::vector<ShadedTile>& columns = (*reached)->withTrees;
    return columns.size() > 1 ? TreeColumns::all : columns.front().column;
}

std::vector<ShadedTiles> sumWithTrees(std::span<const TileResult* const> tiles, TreeColumns columns,
                                      const StudySettings& settings, const SunSteps& sun, double cellAreaM2) {
    const double sunlit = sun.sunlitMinutes() / double(std::max<std::size_t>(1, sun.dayCount()));
    std::vector<ShadedTiles> all;
    for (const TreeColumns column : {TreeColumns::evergreen, TreeColumns::seasonal}) {
        if (!isAmong(columns, column)) continue;
        ShadowSums sums;
        MonthSums months;
        for (const TileResult* tile : tiles) {
            sums.add(tile->sumsOf(column));
            months.add(*tile, tile->monthMinutesOf(column));
        }
        all.push_back(
            {column, computeStatistics(sums, sunlit, cellAreaM2), months.months(settings, sun, cellAreaM2)});
    }
    return all;
}

bool haveRuns(std::span<const ShadedTiles> withTrees) {
    return std::ranges::all_of(withTrees, [](const ShadedTiles& with) { return hasRuns(with.statistics); });
}

std::vector<MonthsWithTrees> listMonthsWithTrees(std::span<const ShadedTiles> withTrees) {
    std::vector<MonthsWithTrees> months;
    for (const ShadedTiles& with : withTrees) months.push_back({with.column, with.months});
    return months;
}

std::vector<MonthShadow> MonthSums::months(const StudySettings& settings, const SunSteps& sun,
                                           double cellAreaM2) const {
    if (!settings.byMonth) return {};
    const StepSets sets = monthsOf(sun);
    std::vector<double> minutes = minutes_;
    minutes.resize(sets.names.size());
    return monthsFromSums(sets, sets.sunlitMinutes(sun), minutes, receivers_, cellAreaM2);
}

namespace {

Result<void> checkQuestion(const StudySettings& settings) {
    if (settings.contributions)
        return failure("Contributions are not available for tiled studies", "study",
                       "Leave them out, or choose a region that fits into memory");
    return validate(settings.period).map([](const Period&) {});
}

Result<void> checkTileSide(int cells) {
    if (cells >= TiledStudySettings::minTileCells && cells <= TiledStudySettings::maxTileCells) return {};
    return failure(fmt::format("A tile of {} cells is out of range", cells), "tile size",
                   "Choose 64 to 4096 cells");
}

Result<SunSteps> computeSunOver(const Study& study, const std::stop_token& stop) {
    return computeDaylightSteps(study.settings.period, makeObserver(study), stop);
}

TilesLeft findLeft(const TilePlan& plan, const TileJournal& journal) {
    TilesLeft left;
    for (std::size_t tile = 0; tile < plan.count(); ++tile) {
        const auto found = journal.finished().find(tile);
        // A version that measured no trees left this mark.
        if (found != journal.finished().end() && !found->second.hasTrees)
            left.done.add(plan.tile(tile));
        else
            left.missing.push_back({tile});
    }
    return left;
}

void addCost(Cost& sum, const Cost& piece) {
    sum.rays += piece.rays;
    for (const auto& [stage, seconds] : piece.seconds) sum.seconds[stage] += seconds;
    for (const auto& [reason, count] : piece.skipped) sum.skipped[reason] += count;
}

std::uint32_t buildingsUsed(const City& city, const Region& region, const SunSteps& sun) {
    const ShadowReach reach(sun);
    const float lowest = city.terrain ? *std::ranges::min_element(city.terrain->elevationM) : 0;
    return std::uint32_t(std::ranges::count_if(city.buildings, [&](const auto& building) {
        return reach.touches(bounds(*building), double(topM(*building) - lowest), bounds(region));
    }));
}

// Trees whose shadow can fall on the region.
std::size_t countTrees(const Study& study) {
    const City& city = study.city;
    const float lowest = city.terrain ? *std::ranges::min_element(city.terrain->elevationM) : 0;
    return findTreesInReach(city, bounds(study.settings.region), lowest, study.sun).size();
}

// Every tile skipped other buildings: only those that no tile needed count as skipped.
void countBuildings(Study& study) {
    const auto skipped = study.field.cost.skipped.find(buildingsOutOfReach);
    if (skipped != study.field.cost.skipped.end())
        skipped->second = study.city.buildings.size() - study.field.cost.buildingsUsed;
}

std::string describeEngine(const TiledStudy& tiled, const std::string& first) {
    std::string keys;
    for (const auto& [key, count] : tiled.tilesByEngine)
        keys += fmt::format("{}{} in {}", keys.empty() ? "" : ", ", key, count);
    return fmt::format("{}; {} of {} per side: {}", first, countOf(tiled.plan.count(), "tile"),
                       countOf(std::uint64_t(tiled.plan.side), "cell"), keys);
}

std::vector<MonthShadow> sumMonths(const Study& study, const std::map<std::size_t, TileResult>& tiles) {
    MonthSums sums;
    for (const auto& [number, result] : tiles) sums.add(result);
    return sums.months(study.settings, study.sun, study.field.grid.cellAreaM2());
}

void addTrees(TiledStudy& tiled, const std::map<std::size_t, TileResult>& finished) {
    std::vector<const TileResult*> tiles;
    for (const auto& [number, result] : finished) {
        tiles.push_back(&result);
        if (tiled.treesHow.empty()) tiled.treesHow = result.treesHow;
    }
    tiled.treeColumns = findColumns(tiles);
    if (tiled.treeColumns == TreeColumns::without) return;
    const Study& study = tiled.study;
    tiled.treesUsed = countTrees(study);
    tiled.withTrees =
        sumWithTrees(tiles, tiled.treeColumns, study.settings, study.sun, study.field.grid.cellAreaM2());
}

void addTiles(TiledStudy& tiled, const TileJournal& journal) {
    Study& study = tiled.study;
    ShadowSums sums;
    std::vector<ComparedCell> compared;
    std::string first;
    for (const auto& [number, result] : journal.finished()) {
        sums.add(result.sums);
        addCost(study.field.cost, result.cost);
        compared.insert(compared.end(), result.compared.begin(), result.compared.end());
        study.seconds["accumulate"] += result.seconds - result.errorSeconds;
        if (!result.compared.empty()) study.seconds["error_sample"] += result.errorSeconds;
        if (result.empty()) ++tiled.emptyTiles;
        if (result.empty()) continue;
        ++tiled.tilesByEngine[result.engineKey];
        if (first.empty()) first = result.engine;
    }
    countBuildings(study);
    tiled.months = sumMonths(study, journal.finished());
    addTrees(tiled, journal.finished());
    const ShadowField& field = study.field;
    study.statistics = computeStatistics(sums, field.sunlitMinutesPerDay, field.grid.cellAreaM2());
    study.statistics.waterM2 = findWaterM2(field);
    study.field.engine = describeEngine(tiled, first);
    study.field.engineKey =
        tiled.tilesByEngine.size() == 1 ? tiled.tilesByEngine.begin()->first : study.settings.engine;
    if (compared.empty()) return;
    study.error = errorOf(compared, field.sunlitMinutesPerDay, longestDayMinutes(study.sun));
    study.error->ofReceivers = sums.receivers;
    study.error->rays = std::uint64_t(compared.size()) * study.sun.steps.size();
}

void setGrid(Study& study, const Grid& grid) {
    study.receivers.grid = grid;
    study.field.grid = grid;
    study.field.stepMinutes = study.sun.stepMinutes;
    study.field.days = std::max(1, int(study.sun.dayCount()));
    study.field.sunlitMinutesPerDay = study.sun.sunlitMinutes() / study.field.days;
    study.field.cost.buildingsUsed = buildingsUsed(study.city, study.settings.region, study.sun);
}

Result<void> checkOpenGround(const Study& study) {
    if (study.statistics.receivers > 0) return {};
    return failure("No cell of the region lies on open ground", study.settings.region.name,
                   "Choose a region outside buildings and water, or smaller cells");
}

// The first map has the name that the caller chose; the others lie beside it.
Result<void> writeMaps(const TiledStudy& tiled, const TileJournal& journal, const MapFile& file,
                       Progress& progress, const std::stop_token& stop) {
    const Study& study = tiled.study;
    const TileFiles tiles = listFiles(journal);
    MapFile own = file;
    for (const TileMap& map : listWrittenMaps(listTileMaps(study.settings, study.sun, tiled.treeColumns),
                                              hasRuns(study.statistics), haveRuns(tiled.withTrees))) {
        if (map.firstBand > 0) own.path = file.path.parent_path() / (map.name + ".tif");
        auto made = assembleMap(tiled.plan, tiles, study.city.frame, own, map, progress, stop);
        if (!made) return made;
    }
    return {};
}

Result<TiledStudy> computeTiles(TiledStudy tiled, const Engine& engine, const MapFile& file,
                                Progress& progress, const std::stop_token& stop) {
    const Stopwatch watch;
    Study& study = tiled.study;
    auto sun = computeSunOver(study, stop);
    if (!sun) return tl::make_unexpected(sun.error());
    study.sun = *std::move(sun);
    setGrid(study, tiled.plan.whole);
    study.terrainCoverage =
        computeTerrainCoverage(study.city, study.settings.region, tiled.plan.whole, study.sun);
    if (auto covered = checkCoverage(study.terrainCoverage, study.settings.region.name); !covered)
        return tl::make_unexpected(covered.error());
    study.warnings = makeWarnings(study.terrainCoverage);
    auto journal =
        TileJournal::open(file.path.string() + ".tiles", hashStudy(study.city, study.settings), tiled.plan);
    if (!journal) return tl::make_unexpected(journal.error());
    tiled.resumedTiles = journal->finished().size();
    ShadowMeasure measure(study.city, {study.settings, study.sun, engine, tiled.plan.whole});
    TileRunner runner(measure, tiled.plan, study.city.frame, *journal);
    if (auto done = runTiles(runner, tiled.plan, findLeft(tiled.plan, *journal), progress, stop); !done)
        return tl::make_unexpected(done.error());
    addTiles(tiled, *journal);
    if (auto some = checkOpenGround(study); !some) return tl::make_unexpected(some.error());
    const Stopwatch writing;
    if (auto made = writeMaps(tiled, *journal, file, progress, stop); !made)
        return tl::make_unexpected(made.error());
    journal->remove();
    study.seconds["write"] = writing.seconds();
    study.seconds["total"] = watch.seconds();
    return tiled;
}

Result<TiledStudy> checkAndCompute(const City& city, const TiledStudySettings& settings,
                                   const std::filesystem::path& file, Progress& progress,
                                   const std::stop_token& stop, const EngineList& engines) {
    const StudySettings& question = settings.study;
    if (const auto side = checkTileSide(settings.tileCells); !side) return tl::make_unexpected(side.error());
    if (const auto sound = checkQuestion(question); !sound) return tl::make_unexpected(sound.error());
    const auto engine = makeEngine(question.engine, question.engineSettings, engines);
    if (!engine) return tl::make_unexpected(engine.error());
    if (auto able = checkBreakdown(question, (*engine)->capabilities(), engines); !able)
        return tl::make_unexpected(able.error());
    const auto grid = gridOver(question.region, question.receivers);
    if (!grid) return tl::make_unexpected(grid.error());
    const TilePlan plan{*grid, settings.tileCells};
    if (auto fits = checkTileMemory(city, plan, question, engines); !fits)
        return tl::make_unexpected(fits.error());
    return computeTiles(
        {.study = {.city = withTreesFor(city, question.trees), .settings = question}, .plan = plan}, **engine,
        {file, settings.tags}, progress, stop);
}

}  // namespace

Result<TiledStudy> runTiledStudy(const City& city, const TiledStudySettings& settings,
                                 const std::filesystem::path& file, Progress& progress, std::stop_token stop,
                                 const EngineList& engines) {
    return guardMemory({.advice = "Choose smaller tiles or fewer steps"},
                       [&] { return checkAndCompute(city, settings, file, progress, stop, engines); });
}

using Json = nlohmann::ordered_json;

namespace {

void addTrees(Json& json, const TiledStudy& tiled) {
    json["trees"]["used"] = tiled.treesUsed;
    json["trees"]["shaded_from"] = TreeShade::defaultShadedFrom;
    json["trees"]["how"] = tiled.treesHow;
    const double bareMin = tiled.study.statistics.meanGrossMin;
    for (const ShadedTiles& with : tiled.withTrees) {
        json.update(figuresJson({treeFigures(with.column), &with.statistics}));
        json["definitions"].update(definitionsJson(treeFigures(with.column)));
        const double allMin = with.statistics.meanGrossMin;
        json["trees"]["share_of_shade" + suffixOf(with.column)] =
            allMin > 0 ? Json(1 - bareMin / allMin) : Json();
    }
}

}  // namespace

std::string tiledStudyJson(const TiledStudy& tiled) {
    Json json = Json::parse(studyJson(tiled.study));
    if (tiled.study.settings.byMonth)
        json["by_month"] = monthsJson(tiled.months, listMonthsWithTrees(tiled.withTrees));
    if (!tiled.withTrees.empty()) addTrees(json, tiled);
    json["tiles"] = {{"side_cells", tiled.plan.side},
                     {"count", tiled.plan.count()},
                     {"empty", tiled.emptyTiles},
                     {"resumed", tiled.resumedTiles},
                     {"by_engine", tiled.tilesByEngine}};
    std::vector<CommandOption> tiles;
    if (tiled.plan.side != TiledStudySettings::defaultTileCells)
        tiles.push_back({flags::tile, {std::to_string(tiled.plan.side)}});
    addRepeat(json,
              makeRepeatCommand(tiled.study, std::numeric_limits<std::size_t>::max(), "city-study", tiles));
    return toJsonText(json);
}

}  // namespace noonmark
