#include "core/study/tile_tasks/merge/tile_places.h"

#include <cmath>
#include <limits>

#include "core/describe/figure_text.h"
#include "core/io/write_raster.h"
#include "core/measures/shadow_figures.h"
#include "core/receivers/grid_box.h"
#include "core/receivers/rasterize.h"
#include "core/study/provenance/source_columns.h"

namespace noonmark {

namespace {

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
    for (const Place& place : places) {
        Box2& box = boxes.emplace_back();
        for (const Footprint& polygon : place.polygons) box.add(bounds(polygon));
    }
    return boxes;
}

}  // namespace

Result<void> addPlaces(PlaceShadows& shadows, const std::vector<Place>& places, const PlaceTiles& tiles,
                       Progress& progress, const std::stop_token& stop) {
    const std::vector<Box2> boxes = boxesOfPlaces(places);
    for (const Place& place : places) shadows[place.name].kind = place.kind;
    for (const auto& [number, file] : tiles.files) {
        if (stop.stop_requested()) return cancelled();
        progress.report(double(number) / double(tiles.plan.count()), "summing up places");
        if (!file) continue;
        const Grid tile = tiles.plan.tile(number);
        Bands bands;
        for (std::size_t i = 0; i < places.size(); ++i) {
            if (!overlaps(boxes[i], tile)) continue;
            if (bands.empty()) {
                auto read = readGeoTiff(*file, tile);
                if (!read) return tl::make_unexpected(read.error());
                bands = *std::move(read);
            }
            TiledPlace& shadow = shadows[places[i].name];
            shadow.cellAreaM2 = tile.cellAreaM2();
            for (const Footprint& polygon : places[i].polygons) {
                const ShadowSums sums = sumOver(polygon, tile, bands, tiles.firstBand);
                shadow.sums.add(sums);
                shadow.sunlitMinutes += double(sums.receivers) * tiles.sunlitMinutesPerDay;
            }
        }
    }
    return {};
}

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

}  // namespace noonmark
