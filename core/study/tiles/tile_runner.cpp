#include "core/study/tiles/tile_runner.h"

#include "core/base/stopwatch.h"
#include "core/engines/api/blank_field.h"
#include "core/io/write_raster.h"
#include "core/measures/compared_cells.h"
#include "core/receivers/roof_receivers.h"
#include "core/study/provenance/provenance.h"
#include "core/study/tiles/map_bands.h"

namespace noonmark {

namespace {

// Some 40 to 80 % of a city's box are receivers: twice as many sample points as receivers wanted.
constexpr std::size_t placesAReceiver = 2;

// Writes both bands in every tile: whether runs were counted is decided for all tiles together.
Result<void> writeTile(const std::filesystem::path& file, const Frame& frame, const ShadowField& field) {
    auto writer = GeoTiffWriter::create(file, frame, field.grid, makeMapBands(field, true));
    if (!writer) return tl::make_unexpected(writer.error());
    return writer->write(field.grid, {&field.grossMin, &field.continuousMin}).and_then([&] {
        return writer->finish(false);
    });
}

Result<TileResult> withFile(TileResult result, const std::filesystem::path& file,
                            const std::string& contentHash) {
    result.contentHash = contentHash;
    if (contentHash.empty() || result.empty()) return result;
    return describeInputFile(file).map([&](const InputFile& written) {
        result.fileBytes = written.bytes;
        result.fileSha256 = written.sha256;
        return std::move(result);
    });
}

}  // namespace

TileRunner::TileRunner(const City& city, const StudySettings& settings, const SunSteps& sun,
                       const Engine& engine, const TilePlan& plan, TileJournal& journal)
    : city_(city), settings_(settings), sun_(sun), engine_(engine), plan_(plan), journal_(journal) {}

Result<void> TileRunner::run(std::size_t tile, Progress& progress, const std::stop_token& stop,
                             const std::string& contentHash) {
    const Stopwatch watch;
    return placeReceiversInPart(city_, settings_.region, plan_.tile(tile), stop)
        .and_then([&](Receivers receivers) {
            const Receivers placed = placeAtHeights(std::move(receivers), city_, settings_.receivers.places);
            return computed(tile, placed, progress, stop);
        })
        .and_then([&](TileResult result) {
            result.seconds = watch.seconds();
            return withFile(std::move(result), journal_.fileOf(tile), contentHash);
        })
        .and_then([&](TileResult result) { return journal_.add(std::move(result)); });
}

Result<TileResult> TileRunner::computed(std::size_t tile, const Receivers& receivers, Progress& progress,
                                        const std::stop_token& stop) {
    TileResult result{.number = tile};
    if (receivers.cells.empty()) {
        result.cost = makeBlankField(receivers, sun_).cost;
        return result;
    }
    auto field = engine_.accumulate(city_, receivers, sun_, progress, stop);
    if (!field) return tl::make_unexpected(field.error());
    result.engineKey = field->engineKey.empty() ? settings_.engine : field->engineKey;
    result.sums = computeSums(*field);
    result.cost = field->cost;
    result.engine = field->engine;
    return compare(result, receivers, *field, progress, stop)
        .and_then([&] { return writeTile(journal_.fileOf(tile), city_.frame, *field); })
        .map([&] { return std::move(result); });
}

Result<void> TileRunner::compare(TileResult& result, const Receivers& receivers, const ShadowField& field,
                                 Progress& progress, const std::stop_token& stop) {
    if (settings_.errorSample.receivers == 0 || result.engineKey == referenceEngine) return {};
    const Stopwatch watch;
    const std::size_t places = placesAReceiver * sampleSize(settings_.errorSample, sun_.steps.size());
    const auto cells = spreadReceivers(receivers, plan_.whole, places, settings_.errorSample.seed);
    if (cells.empty()) return {};
    if (!scene_) {
        auto scene = RayScene::over(city_, stop);
        if (!scene) return tl::make_unexpected(scene.error());
        scene_ = *std::move(scene);
    }
    auto compared = compareByRays(*scene_, receivers, sun_, field, cells, progress, stop);
    if (!compared) return tl::make_unexpected(compared.error());
    result.compared = *std::move(compared);
    result.errorSeconds = watch.seconds();
    return {};
}

}  // namespace noonmark
