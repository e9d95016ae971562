#include "core/study/tiles/shadow_measure.h"

#include "core/base/progress.h"
#include "core/city/trees/tree.h"
#include "core/engines/api/shadow_field.h"
#include "core/engines/shade_trees.h"
#include "core/measures/error_sample.h"
#include "core/receivers/roof_receivers.h"
#include "core/study/text/breakdown_text.h"

namespace noonmark {

namespace {

// Some 40 to 80 % of a city's box are receivers: twice as many sample points as receivers wanted.
constexpr std::size_t placesAReceiver = 2;

// Adds a band for each month; returns the sums of their minutes.
std::vector<double> addMonths(const ShadowBreakdown& months, std::vector<std::vector<float>>& bands) {
    std::vector<double> minutes;
    for (std::size_t month = 0; month < months.minutes.size(); ++month) {
        minutes.push_back(sumOf(months.minutes[month]));
        bands.push_back(spreadOverGrid(months, month));
    }
    return minutes;
}

}  // namespace

ShadowMeasure::ShadowMeasure(const City& city, const TileQuestion& question)
    : city_(withTreesFor(city, question.settings.trees)), question_(question) {}

TreeColumns ShadowMeasure::columns() const {
    return city_.trees && !city_.trees->trees.empty() ? question_.settings.trees : TreeColumns::without;
}

std::vector<TileMap> ShadowMeasure::maps() const {
    return listTileMaps(question_.settings, question_.sun, columns());
}

Result<TileAnswer> ShadowMeasure::measure(const Grid& tile, Progress& progress, const std::stop_token& stop) {
    return placeReceiversInPart(city_, question_.settings.region, tile, stop)
        .and_then([&](Receivers receivers) {
            const ReceiverPlaces places = question_.settings.receivers.places;
            return computed(placeAtHeights(std::move(receivers), city_, places), progress, stop);
        });
}

Result<TileAnswer> ShadowMeasure::computed(const Receivers& receivers, Progress& progress,
                                           const std::stop_token& stop) {
    TileAnswer answer;
    if (receivers.cells.empty()) {
        answer.result.cost = makeBlankField(receivers, question_.sun).cost;
        return answer;
    }
    const City* const cities[]{&city_};
    EngineInUse engine(question_.engine, cities, receivers, question_.sun);
    auto field = accumulate(answer.result, engine, receivers, progress, stop);
    if (!field) return tl::make_unexpected(field.error());
    const auto months = breakDown(engine, progress, stop);
    if (!months) return tl::make_unexpected(months.error());
    answer.bands = {field->grossMin, field->continuousMin};
    if (*months) answer.result.monthMinutes = addMonths(**months, answer.bands);
    return addTrees(answer, *field, *months, receivers, progress, stop).map([&] {
        return std::move(answer);
    });
}

Result<ShadowField> ShadowMeasure::accumulate(TileResult& result, EngineInUse& engine,
                                              const Receivers& receivers, Progress& progress,
                                              const std::stop_token& stop) {
    while (true) {
        auto field = engine.accumulate(city_, progress, stop);
        if (!field) return field;
        result.engineKey = field->engineKey.empty() ? question_.settings.engine : field->engineKey;
        result.sums = computeSums(*field);
        result.cost = field->cost;
        result.engine = field->engine;
        result.compared.clear();
        if (auto done = compare(result, receivers, *field, progress, stop); !done)
            return tl::make_unexpected(done.error());
        const auto off = findOff(result, engine, receivers, *field, progress, stop);
        if (!off) return tl::make_unexpected(off.error());
        if (!engine.switchToMoreExact(*off)) return field;
    }
}

// A tile has few cells of the sample of the whole grid. Where these would change the engine, a sample of the
// tile's own decides.
Result<SampledDeviation> ShadowMeasure::findOff(const TileResult& result, const EngineInUse& engine,
                                                const Receivers& receivers, const ShadowField& field,
                                                Progress& progress, const std::stop_token& stop) const {
    const SampledDeviation few = errorOf(result.compared, field.sunlitMinutesPerDay, 0).grossOff();
    if (!engine.wouldSwitch(few)) return few;
    const ErrorSampleSettings& sample = question_.settings.errorSample;
    const auto cells =
        spreadReceivers(receivers, sampleSize(sample, question_.sun.steps.size()), sample.seed);
    return compareByRays(*scene_, receivers, question_.sun, field, cells, progress, stop)
        .map([&](const std::vector<ComparedCell>& compared) {
            return errorOf(compared, field.sunlitMinutesPerDay, 0).grossOff();
        });
}

Result<std::optional<ShadowBreakdown>> ShadowMeasure::breakDown(const EngineInUse& engine, Progress& progress,
                                                                const std::stop_token& stop) const {
    if (!question_.settings.byMonth) return std::nullopt;
    return engine.breakDown(city_, monthsOf(question_.sun), false, progress, stop)
        .map([](ShadowBreakdown months) { return std::optional(std::move(months)); });
}

Result<void> ShadowMeasure::addTrees(TileAnswer& answer, ShadowField& field,
                                     const std::optional<ShadowBreakdown>& months, const Receivers& receivers,
                                     Progress& progress, const std::stop_token& stop) const {
    if (columns() == TreeColumns::without) return {};
    auto shade = shadeTrees(city_, receivers, question_.sun, field, columns(), progress, stop);
    if (!shade) return tl::make_unexpected(shade.error());
    field.trees = *std::move(shade);
    if (!field.trees) return {};
    std::optional<ShadedSets> shadedMonths;
    if (months) {
        auto shaded = shadeTreeSets(city_, receivers, question_.sun, *months, columns(), progress, stop);
        if (!shaded) return tl::make_unexpected(shaded.error());
        shadedMonths = *std::move(shaded);
    }
    answer.result.treesHow = field.trees->how;
    for (const ShadeColumn& column : listShadeColumns(field)) {
        ShadedTile tile{column.column, computeSums(*column.field)};
        answer.bands.push_back(column.field->grossMin);
        answer.bands.push_back(column.field->continuousMin);
        if (months) {
            const auto& with = shadedMonths ? shadedMonths->of(column.column) : months;
            tile.monthMinutes = addMonths(with ? *with : *months, answer.bands);
        }
        answer.result.withTrees.push_back(std::move(tile));
    }
    return {};
}

Result<void> ShadowMeasure::compare(TileResult& result, const Receivers& receivers, const ShadowField& field,
                                    Progress& progress, const std::stop_token& stop) {
    const ErrorSampleSettings& sample = question_.settings.errorSample;
    if (sample.receivers == 0 || result.engineKey == referenceEngine) return {};
    const Stopwatch watch;
    const std::size_t places = placesAReceiver * sampleSize(sample, question_.sun.steps.size());
    const auto cells = spreadReceivers(receivers, question_.whole, places, sample.seed);
    if (cells.empty()) return {};
    if (!scene_) {
        auto scene = RayScene::over(city_, stop);
        if (!scene) return tl::make_unexpected(scene.error());
        scene_ = *std::move(scene);
    }
    auto compared = compareByRays(*scene_, receivers, question_.sun, field, cells, progress, stop);
    if (!compared) return tl::make_unexpected(compared.error());
    result.compared = *std::move(compared);
    result.errorSeconds += watch.seconds();
    return {};
}

}  // namespace noonmark
