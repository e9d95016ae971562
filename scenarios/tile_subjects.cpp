#include "scenarios/tile_subjects.h"

#include <fmt/format.h>
#include <limits>
#include <utility>

#include "core/city/trees/tree.h"
#include "core/engines/api/shadow_field.h"
#include "core/engines/shade_trees.h"
#include "core/study/provenance/study_hash.h"
#include "core/study/tiles/tile_maps.h"
#include "scenarios/impact/impact_figures.h"
#include "scenarios/weights/score.h"
#include "scenarios/weights/score_text.h"

namespace noonmark {

namespace {

struct FieldPair {
    ShadowField before, after;
};

// Areas add up over tiles; that of all receivers is stated with the sums of the tiles.
bool isSummedOverTiles(const Figure& figure) {
    return figure.inFiles && figure.unit == FigureUnit::squareMetres && figure.key != "receiver_area_m2";
}

// "gained_over_30_min_m2" for "gained_m2".
std::string keyOver(const Figure& figure, double thresholdMin) {
    constexpr std::string_view unit = "_m2";
    const std::string_view name = figure.key.substr(0, figure.key.size() - unit.size());
    return fmt::format("{}_over_{:g}_min{}", name, thresholdMin, unit);
}

// With trees: "touched_m2_seasonal", the change of the shadow alone. What became building is the same.
void addFigures(std::map<std::string, double>& figures, const Impact& impact, const std::string& trees) {
    const ImpactFigures all = computeFigures(impact, 0), large = computeFigures(impact);
    for (const Figure& figure : changeFigures().rows())
        if (isSummedOverTiles(figure) && figure.byThreshold)
            figures[keyOver(figure, large.thresholdMin) + trees] = figure.get(&large.gross);
        else if (isSummedOverTiles(figure))
            figures[std::string(figure.key) + trees] = figure.get(&all.gross);
    for (const Figure& figure : impactFigures().rows())
        if (isSummedOverTiles(figure) && (trees.empty() || figure.use == FigureUse::result))
            figures[std::string(figure.key) + trees] = figure.get(&all);
}

std::map<std::string, double> listFigures(const Impact& impact) {
    std::map<std::string, double> figures;
    addFigures(figures, impact, {});
    return figures;
}

class ImpactMeasure : public TileMeasure {
public:
    ImpactMeasure(const ComparedCities& cities, const TileQuestion& question)
        : before_(withTreesFor(*cities.before, question.settings.trees)),
          after_(withTreesFor(*cities.after, question.settings.trees)),
          question_(question) {}

    [[nodiscard]] std::vector<TileMap> maps() const override {
        return addMapsWithTrees(listImpactMaps(), columns());
    }

    Result<TileAnswer> measure(const Grid& tile, Progress& progress, const std::stop_token& stop) override {
        const Region& region = question_.settings.region;
        return findCommonReceiversInPart(before_, after_, region, tile, stop)
            .and_then([&](CommonReceivers common) { return compare(std::move(common), progress, stop); });
    }

private:
    [[nodiscard]] TreeColumns columns() const {
        const auto has = [](const City& city) { return city.trees && !city.trees->trees.empty(); };
        return has(before_) || has(after_) ? question_.settings.trees : TreeColumns::without;
    }

    Result<TileAnswer> compare(CommonReceivers common, Progress& progress,
                               const std::stop_token& stop) const {
        const Receivers& receivers = common.receivers;
        if (receivers.cells.empty()) return withoutReceivers(std::move(common));
        auto fields = computeFields(receivers, progress, stop);
        if (!fields) return tl::make_unexpected(fields.error());
        for (const auto& [city, field] :
             {std::pair(&before_, &fields->before), std::pair(&after_, &fields->after)})
            if (auto done = shade(*city, receivers, *field, progress, stop); !done)
                return tl::make_unexpected(done.error());
        const Impact impact = computeDifference(fields->before, fields->after, common.change);
        TileAnswer answer{.result = {.sums = computeSums(fields->after), .figures = listFigures(impact)}};
        const std::string& key = fields->after.engineKey;
        answer.result.engineKey = key.empty() ? question_.settings.engine : key;
        answer.result.engine = impact.engine;
        answer.result.cost = fields->after.cost;
        addBands(answer, fields->before, fields->after, impact);
        if (fields->before.trees || fields->after.trees) addTrees(answer, *fields, common);
        return answer;
    }

    Result<void> shade(const City& city, const Receivers& receivers, ShadowField& field, Progress& progress,
                       const std::stop_token& stop) const {
        return shadeTrees(city, receivers, question_.sun, field, columns(), progress, stop)
            .map([&](std::shared_ptr<const TreeShade> shade) { field.trees = std::move(shade); });
    }

    // In the order of the maps.
    static void addBands(TileAnswer& answer, const ShadowField& before, const ShadowField& after,
                         const Impact& impact) {
        for (const auto* band : {&after.grossMin, &after.continuousMin, &before.grossMin,
                                 &before.continuousMin, &impact.grossMin, &impact.continuousMin})
            answer.bands.push_back(*band);
    }

    void addTrees(TileAnswer& answer, const FieldPair& fields, const CommonReceivers& common) const {
        for (const TreeColumns column : {TreeColumns::evergreen, TreeColumns::seasonal}) {
            if (!isAmong(columns(), column)) continue;
            const ShadowField& before = fieldOfColumn(fields.before, column);
            const ShadowField& after = fieldOfColumn(fields.after, column);
            const ShadeImpact with{column, computeDifference(before, after, common.change)};
            answer.result.withTrees.push_back({column, computeSums(after)});
            addFigures(answer.result.figures, with.impact, suffixOf(column));
            addBands(answer, before, after, with.impact);
        }
        const auto& shade = fields.after.trees ? fields.after.trees : fields.before.trees;
        answer.result.treesHow = shade->how;
    }

    // Where a tower covers the whole tile, its cells still became building.
    static TileAnswer withoutReceivers(CommonReceivers common) {
        Cost cost;
        countSkippedCells(cost, common.receivers);
        Impact impact{.grid = common.receivers.grid, .change = std::move(common.change)};
        impact.grossMin.assign(impact.grid.size(), std::numeric_limits<float>::quiet_NaN());
        impact.continuousMin = impact.grossMin;
        return {.result = {.figures = listFigures(impact), .cost = std::move(cost)}};
    }

    // The engine that "auto" chooses is the same for both cities: else they would differ by it too.
    Result<FieldPair> computeFields(const Receivers& receivers, Progress& progress,
                                    const std::stop_token& stop) const {
        const City* const cities[]{&before_, &after_};
        const auto choice = question_.engine.choose(cities, receivers, question_.sun);
        if (!choice) return fieldsBy(question_.engine, receivers, progress, stop);
        auto fields = fieldsBy(*choice, receivers, progress, stop);
        if (fields) return fields;
        const auto other = question_.engine.chooseInstead(*choice, fields.error());
        return other ? fieldsBy(*other, receivers, progress, stop) : std::move(fields);
    }

    template <class Accumulator>
    Result<FieldPair> fieldsBy(const Accumulator& engine, const Receivers& receivers, Progress& progress,
                               const std::stop_token& stop) const {
        auto before = engine.accumulate(before_, receivers, question_.sun, progress, stop);
        if (!before) return tl::make_unexpected(before.error());
        auto after = engine.accumulate(after_, receivers, question_.sun, progress, stop);
        if (!after) return tl::make_unexpected(after.error());
        return FieldPair{*std::move(before), *std::move(after)};
    }

    City before_, after_;  // with their trees weighed, if they are wanted
    TileQuestion question_;
};

TileMap mapOfShadow(const std::string& name, const std::string& title, std::size_t firstBand) {
    const ShadowField names;
    TileMap map{name, title, makeMapBands(names, true), firstBand, 1};
    for (RasterBand& band : map.bands) band.values = nullptr;
    return map;
}

}  // namespace

TileSubject makeImpactSubject(const ComparedCities& cities) {
    return {.key = fmt::format("impact;{};{}", hashCity(*cities.before), hashCity(*cities.after)),
            .cities = {cities.before, cities.after},
            .region = cities.region,
            .fields = 2,
            .measure = [cities](const TileQuestion& question) -> std::unique_ptr<TileMeasure> {
                return std::make_unique<ImpactMeasure>(cities, question);
            }};
}

std::vector<TileMap> listImpactMaps(const LegendChoice& legend) {
    TileMap impact{"impact", "Impact", {}, 4, 1};
    impact.bands = {{"change of gross shadow", "min/day", nullptr},
                    {"change of continuous shadow", "min", nullptr}};
    impact.colours = makeSignedScale(withoutQuantiles(legend), ColourScale::Of::change, {legend.show},
                                     legendScale(lockedChangeMin), noChangeMin, {});
    return {mapOfShadow("after", "Shadow after", 0), mapOfShadow("before", "Shadow before", 2),
            std::move(impact)};
}

namespace {

void addResults(std::map<std::string, double>& figures, const DescribedFigures& of,
                const std::string& suffix) {
    for (const Figure& figure : of.figures)
        if (figure.inFiles && figure.use == FigureUse::result)
            figures[std::string(figure.key) + suffix] = of.get(figure);
}

// "score_m2_2026-07_seasonal"
void addFigures(std::map<std::string, double>& figures, const ScoreTotals& totals,
                const std::vector<MonthFigures>& months, const std::string& trees) {
    addResults(figures, scoreFigures().of(totals), trees);
    for (const MonthFigures& month : months)
        addResults(
            figures, scoreMonthFigures().of(month),
            fmt::format("_{:04}-{:02}{}", int(month.month.year()), unsigned(month.month.month()), trees));
}

std::map<std::string, double> listFigures(const Score& score) {
    std::map<std::string, double> figures{{"receiver_area_m2", score.receiverAreaM2}};
    addFigures(figures, score, score.months, {});
    for (const ShadedScore& with : score.withTrees)
        addFigures(figures, with, with.months, suffixOf(with.column));
    return figures;
}

class ScoreMeasure : public TileMeasure {
public:
    ScoreMeasure(const ScoredCity& scored, const TileQuestion& question)
        : scored_(scored), question_(question) {}

    [[nodiscard]] std::vector<TileMap> maps() const override {
        const auto& trees = scored_.city->trees;
        return addMapsWithTrees(listScoreMaps(), trees && !trees->trees.empty() ? question_.settings.trees
                                                                                : TreeColumns::without);
    }

    Result<TileAnswer> measure(const Grid& tile, Progress& progress, const std::stop_token& stop) override {
        const auto zone = Zone::named(question_.settings.period.zone);
        if (!zone) return tl::make_unexpected(zone.error());
        const auto receivers = placeReceiversInPart(*scored_.city, question_.settings.region, tile, stop);
        if (!receivers) return tl::make_unexpected(receivers.error());
        Cost cost;
        countSkippedCells(cost, *receivers);
        if (receivers->cells.empty()) return TileAnswer{.result = {.cost = std::move(cost)}};
        auto score = computeScore(*scored_.city, *receivers, question_.sun, *zone, scored_.weights,
                                  question_.engine, progress, stop, question_.settings.trees);
        if (!score) return tl::make_unexpected(score.error());
        return answerOf(*std::move(score), receivers->cells.size(), std::move(cost));
    }

private:
    // A score has no minutes of shadow.
    [[nodiscard]] TileAnswer answerOf(Score score, std::size_t receivers, Cost cost) const {
        constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
        TileAnswer answer{.result = {.sums = {receivers, unknown, unknown},
                                     .figures = listFigures(score),
                                     .cost = std::move(cost)}};
        answer.result.engineKey = score.engineKey.empty() ? question_.settings.engine : score.engineKey;
        answer.result.engine = std::move(score.engine);
        answer.result.treesHow = std::move(score.treesHow);
        answer.bands.push_back(std::move(score.score));
        for (ShadedScore& with : score.withTrees) {
            answer.result.withTrees.push_back({with.column, answer.result.sums});
            answer.bands.push_back(std::move(with.score));
        }
        return answer;
    }

    ScoredCity scored_;
    TileQuestion question_;
};

}  // namespace

TileSubject makeScoreSubject(const ScoredCity& scored) {
    return {.key = "score;" + weightsCsv(scored.weights),
            .cities = {scored.city},
            .region = scored.region,
            .measure = [scored](const TileQuestion& question) -> std::unique_ptr<TileMeasure> {
                return std::make_unique<ScoreMeasure>(scored, question);
            }};
}

std::vector<TileMap> listScoreMaps(const LegendChoice& legend) {
    TileMap map{.name = "score", .title = "Shadow score", .bands = {}};
    map.bands.push_back({"shadow score", "", nullptr});
    map.colours =
        makeSignedScale(withoutQuantiles(legend), ColourScale::Of::wanted, {}, legendScale(1), 0, {});
    return {std::move(map)};
}

}  // namespace noonmark
