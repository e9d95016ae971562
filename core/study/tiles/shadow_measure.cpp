#include "core/study/tiles/shadow_measure.h"

#include "core/base/stopwatch.h"
#include "core/engines/api/blank_field.h"
#include "core/measures/compared_cells.h"
#include "core/receivers/roof_receivers.h"
#include "core/study/text/breakdown_text.h"

namespace noonmark {

namespace {

// Some 40 to 80 % of a city's box are receivers: twice as many sample points as receivers wanted.
constexpr std::size_t placesAReceiver = 2;

}  // namespace

ShadowMeasure::ShadowMeasure(const City& city, const TileQuestion& question)
    : city_(city), question_(question) {}

std::vector<TileMap> ShadowMeasure::maps() const { return listTileMaps(question_.settings, question_.sun); }

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
    auto field = question_.engine.accumulate(city_, receivers, question_.sun, progress, stop);
    if (!field) return tl::make_unexpected(field.error());
    TileResult& result = answer.result;
    result.engineKey = field->engineKey.empty() ? question_.settings.engine : field->engineKey;
    result.sums = computeSums(*field);
    result.cost = field->cost;
    result.engine = field->engine;
    if (auto done = compare(result, receivers, *field, progress, stop); !done)
        return tl::make_unexpected(done.error());
    answer.bands.push_back(std::move(field->grossMin));
    answer.bands.push_back(std::move(field->continuousMin));
    return addMonths(answer, receivers, progress, stop).map([&] { return std::move(answer); });
}

Result<void> ShadowMeasure::addMonths(TileAnswer& answer, const Receivers& receivers, Progress& progress,
                                      const std::stop_token& stop) const {
    if (!question_.settings.byMonth) return {};
    auto months = question_.engine.breakDown(city_, receivers, question_.sun, monthsOf(question_.sun), false,
                                             progress, stop);
    if (!months) return tl::make_unexpected(months.error());
    for (std::vector<float>& minutes : months->minutes) {
        answer.result.monthMinutes.push_back(sumOf(minutes));
        answer.bands.push_back(std::move(minutes));
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
    result.errorSeconds = watch.seconds();
    return {};
}

}  // namespace noonmark
