#include "core/study/contributions/place_contributions.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>

#include "core/base/csv_text.h"
#include "core/base/memory_guard.h"
#include "core/base/progress.h"
#include "core/describe/figure_text.h"
#include "core/engines/shade_trees.h"
#include "core/measures/places/place_receivers.h"
#include "core/receivers/rasterize.h"
#include "core/study/by_place/sun_by_place.h"
#include "core/study/provenance/provenance_texts.h"
#include "core/study/study_cost.h"

namespace noonmark {

namespace {

std::vector<std::uint32_t> findCellsIn(const Place& place, const Receivers& receivers) {
    std::vector<std::uint32_t> cells = collectCells(place.polygons, receivers.grid);
    std::erase_if(cells, [&](std::uint32_t cell) { return !isReceiver(receivers.kind[cell]); });
    return cells;
}

/// Columns and rows of a grid, the last ones included.
struct CellBox {
    int firstColumn, lastColumn, firstRow, lastRow;
};

CellBox boxAround(const std::vector<std::uint32_t>& cells, const Grid& grid) {
    const auto columns = std::uint32_t(grid.columns);
    CellBox box{grid.columns, 0, int(cells.front() / columns), int(cells.back() / columns)};
    for (const std::uint32_t cell : cells) {
        box.firstColumn = std::min(box.firstColumn, int(cell % columns));
        box.lastColumn = std::max(box.lastColumn, int(cell % columns));
    }
    return box;
}

// The same cells in the smallest grid: sums by month and cell take memory for all of it.
Receivers cropTo(const std::vector<std::uint32_t>& cells, const Receivers& all) {
    const CellBox box = boxAround(cells, all.grid);
    const glm::dvec2 corner{all.grid.westM + box.firstColumn * all.grid.cellM,
                            all.grid.southM + box.firstRow * all.grid.cellM};
    Receivers cropped;
    cropped.grid = {corner.x, corner.y, all.grid.cellM, box.lastColumn - box.firstColumn + 1,
                    box.lastRow - box.firstRow + 1};
    cropped.kind.assign(cropped.grid.size(), CellKind::outside);
    if (!all.flat()) cropped.groundM.assign(cropped.grid.size(), 0);
    for (const std::uint32_t cell : cells) {
        const int column = int(cell % std::uint32_t(all.grid.columns)) - box.firstColumn;
        const int row = int(cell / std::uint32_t(all.grid.columns)) - box.firstRow;
        const auto own = std::uint32_t(cropped.grid.index(column, row));
        cropped.kind[own] = all.kind[cell];
        if (!all.flat()) cropped.groundM[own] = all.groundM[cell];
        cropped.cells.push_back(own);
    }
    return cropped;
}

double sumOfStudy(const Study& study, const std::vector<std::uint32_t>& cells) {
    double minutesADay = 0;
    for (const std::uint32_t cell : cells) minutesADay += double(study.field.grossMin[cell]);
    return minutesADay * double(study.sun.dayCount()) * study.field.grid.cellAreaM2();
}

Result<std::unique_ptr<Engine>> makeAttributing(StudySettings settings, const EngineList& engines) {
    auto engine = makeEngine(settings.engine, settings.engineSettings, engines);
    if (!engine) return engine;
    settings.contributions = true;
    if (auto able = checkBreakdown(settings, (*engine)->capabilities(), engines); !able)
        return tl::make_unexpected(able.error());
    return engine;
}

// Those that the whole study has; none where no tree reaches it.
std::vector<TreeColumns> columnsOf(const Study& study) {
    std::vector<TreeColumns> columns;
    for (const ShadeColumn& shade : listShadeColumns(study.field)) columns.push_back(shade.column);
    return columns;
}

std::vector<TreeColumns> columnsOf(const SunByPlace& sun) {
    std::vector<TreeColumns> columns;
    for (const SunWithTrees& with : sun.withTrees) columns.push_back(with.column);
    return columns;
}

bool areTreesAttributed(const City& city, std::span<const TreeColumns> columns) {
    return city.trees && !columns.empty();
}

/// Of the progress of an attribution.
struct Parts {
    Parts(Progress& whole, const City& city, std::span<const TreeColumns> columns)
        : buildings(whole, 0, areTreesAttributed(city, columns) ? 2 : 1), trees(whole, 1, 2) {}
    ProgressShare buildings, trees;
};

Result<void> attributeToTrees(PlaceContributions& made, const City& city, const Receivers& receivers,
                              const SunSteps& sun, std::span<const TreeColumns> columns, Progress& progress,
                              const std::stop_token& stop) {
    if (!areTreesAttributed(city, columns)) return {};
    const City weighed = withTreesFor(city, TreeColumns::all);
    const auto taken = traceTakenByTree(weighed, receivers, sun, progress, stop);
    if (!taken) return tl::make_unexpected(taken.error());
    made.trees = listTreeContributions(city, *taken, columns, made.breakdown, made.days);
    return {};
}

Result<PlaceContributions> attribute(const Study& study, const Place& place, Progress& progress,
                                     const std::stop_token& stop, const EngineList& engines) {
    const auto engine = makeAttributing(study.settings, engines);
    if (!engine) return tl::make_unexpected(engine.error());
    const std::vector<std::uint32_t> cells = findCellsIn(place, study.receivers);
    if (cells.empty())
        return failure("No cell of the study lies on open ground of this place", place.name,
                       "Choose a place in the study's region, or run the study with smaller cells");
    const Receivers receivers = cropTo(cells, study.receivers);
    const std::vector<TreeColumns> columns = columnsOf(study);
    Parts parts(progress, study.city, columns);
    auto breakdown = (*engine)->breakDown(study.city, receivers, study.sun, monthsOf(study.sun), true,
                                          parts.buildings, stop);
    if (!breakdown) return tl::make_unexpected(breakdown.error());
    PlaceContributions made{place,
                            *std::move(breakdown),
                            cells.size(),
                            study.sun.dayCount(),
                            sumOfStudy(study, cells),
                            {},
                            study.settings.period,
                            study.field.sunlitMinutesPerDay};
    made.rows = listContributions(study.city, made.breakdown, made.days);
    if (auto done = attributeToTrees(made, study.city, receivers, study.sun, columns, parts.trees, stop);
        !done)
        return tl::make_unexpected(done.error());
    return made;
}

// As its sun was measured: a cell on its edge counts by its share of the place.
void weighByShares(PlaceReceivers& on) {
    if (on.unevenOf.front().empty()) return;
    std::vector<double>& shares = on.receivers.shares;
    shares.assign(on.receivers.cells.size(), 1);
    for (const WeightedCell& cell : on.unevenOf.front()) shares[on.receiverOf(0, cell.bit)] += cell.extra;
}

std::optional<CivilDate> dateOf(const SunByPlace& sun, std::optional<std::size_t> date) {
    return date ? std::optional(sun.settings.dates[*date]) : std::nullopt;
}

Result<SunSteps> daylightOf(const SunByPlace& sun, std::optional<std::size_t> date,
                            const std::stop_token& stop) {
    if (!date) return sun.daylight;
    const Period day = periodOf(sun.settings, dateOf(sun, date));
    return computeDaylightSteps(day, makeObserver(sun.city, sun.settings.study), stop);
}

// On ground that is open in all cities, in the cells that the place was measured on.
Result<PlaceContributions> attribute(const SunOfCities& all, std::size_t place,
                                     std::optional<std::size_t> date, Progress& progress,
                                     const std::stop_token& stop, const EngineList& engines) {
    const SunByPlace& sun = all.compared.empty() ? all.baseline : all.compared.back().sun;
    const Place& where = sun.places[place];
    const SunOfPlace& of = sun.sun[place];
    if (of.ofCells.empty())
        return failure("No cell lies on open ground of this place", where.name, "Choose another place");
    const auto engine = makeAttributing(sun.settings.study, engines);
    if (!engine) return tl::make_unexpected(engine.error());
    std::vector<const City*> cities{&all.baseline.city};
    for (const ComparedSun& one : all.compared) cities.push_back(&one.sun.city);
    auto on = placeReceiversOnPlaces(cities, std::span(&where, 1), {.cellM = of.cellM}, stop);
    if (!on) return tl::make_unexpected(on.error());
    weighByShares(*on);
    const auto when = daylightOf(sun, date, stop);
    if (!when) return tl::make_unexpected(when.error());
    const std::size_t days = when->dayCount();
    const std::vector<TreeColumns> columns = columnsOf(sun);
    Parts parts(progress, sun.city, columns);
    auto breakdown =
        (*engine)->breakDown(sun.city, on->receivers, *when, monthsOf(*when), true, parts.buildings, stop);
    if (!breakdown) return tl::make_unexpected(breakdown.error());
    const double hours = date ? of.dateHours[*date] : of.meanHours;
    const double sunlitMinutes = when->sunlitMinutes() / double(days);
    const double minutesADay = sunlitMinutes - 60 * hours;
    PlaceContributions made{where,
                            *std::move(breakdown),
                            of.cells,
                            days,
                            minutesADay * of.areaM2 * double(days),
                            {},
                            periodOf(sun.settings, dateOf(sun, date)),
                            sunlitMinutes};
    made.rows = listContributions(sun.city, made.breakdown, days);
    if (auto done = attributeToTrees(made, sun.city, on->receivers, *when, columns, parts.trees, stop); !done)
        return tl::make_unexpected(done.error());
    return made;
}

}  // namespace

Result<PlaceContributions> computePlaceContributions(const SunOfCities& sun, std::size_t place,
                                                     std::optional<std::size_t> date, Progress& progress,
                                                     std::stop_token stop, const EngineList& engines) {
    return guardMemory({.advice = "Choose a smaller place or larger cells"},
                       [&] { return attribute(sun, place, date, progress, stop, engines); });
}

Result<PlaceContributions> computePlaceContributions(const Study& study, const Place& place,
                                                     Progress& progress, std::stop_token stop,
                                                     const EngineList& engines) {
    return guardMemory({.advice = "Choose a smaller place or larger cells"},
                       [&] { return attribute(study, place, progress, stop, engines); });
}

std::string placeTreesCsv(const std::vector<ContributionTable>& all, const Provenance& provenance) {
    std::vector<std::string> columns{"place", "kind", "period", "trees", "source_id", "species"};
    std::ranges::move(listColumns(contributionFigures().rows()), std::back_inserter(columns));
    CsvText csv(withSourceColumns(std::move(columns)));
    const SourceValues source = sourceValues(provenance);
    for (const ContributionTable& of : all)
        for (const TreeContribution& tree : of.trees)
            for (const auto& [column, one] : tree.columns) {
                csv.text(of.place)
                    .text(of.kind)
                    .text(of.period.words)
                    .text(std::string(keyOf<TreeColumns>(treeColumnChoices, column)));
                csv.text(one.id).text(one.name);
                addFigures(csv, contributionFigures().of(one));
                addSource(csv, source);
                csv.endRow();
            }
    return csv.take();
}

}  // namespace noonmark
