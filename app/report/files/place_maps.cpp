#include "app/report/files/place_maps.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "app/report/book/sun_by_place_book.h"
#include "app/report/maps/write_png.h"
#include "core/describe/text.h"
#include "core/io/styles/raster_style.h"
#include "core/io/write_raster.h"
#include "core/receivers/place_names.h"
#include "core/receivers/rasterize.h"

namespace noonmark {

namespace {

using Values = std::vector<float>;

const SunByPlace& lastCity(const SunOfCities& sun) {
    return sun.compared.empty() ? sun.baseline : sun.compared.back().sun;
}

Grid gridOf(const std::vector<Place>& places, double cellM) {
    constexpr double maxCells = 16e6;
    Box2 box;
    for (const Place& place : places) box.add(bounds(place));
    const glm::dvec2 size = glm::dvec2(box.high) - glm::dvec2(box.low);
    while (size.x * size.y / (cellM * cellM) > maxCells) cellM *= 2;
    return {box.low.x, box.low.y, cellM, std::max(1, int(std::ceil(size.x / cellM))),
            std::max(1, int(std::ceil(size.y / cellM)))};
}

/// A figure of each place.
struct PlaceBand {
    std::string name, unit;
    std::vector<double> ofPlaces;
};

std::vector<PlaceBand> listBands(const SunOfCities& all) {
    const SunByPlace& sun = lastCity(all);
    std::vector<PlaceBand> bands{{"hours of sun a day", "h", {}}};
    for (const SunOfPlace& of : sun.sun) bands[0].ofPlaces.push_back(of.meanHours);
    for (std::size_t date = 0; date < sun.settings.dates.size(); ++date) {
        PlaceBand& band =
            bands.emplace_back(PlaceBand{"hours of sun on " + formatText(sun.settings.dates[date]), "h", {}});
        for (const SunOfPlace& of : sun.sun)
            band.ofPlaces.push_back(date < of.dateHours.size() ? of.dateHours[date] : SunOfPlace::none);
    }
    if (all.compared.empty()) return bands;
    PlaceBand& change =
        bands.emplace_back(PlaceBand{"change of sun from " + all.baseline.name, "min/day", {}});
    for (const SunChange& of : all.compared.back().changes) change.ofPlaces.push_back(60 * of.meanHours);
    return bands;
}

// Small places lie on top.
std::vector<std::size_t> listLargestFirst(const std::vector<Place>& places) {
    std::vector<std::size_t> order(places.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::vector<double> areas;
    for (const Place& place : places) areas.push_back(area(place));
    std::ranges::stable_sort(order, std::greater(), [&](std::size_t i) { return areas[i]; });
    return order;
}

Result<void> writePlaceRaster(const SunOfCities& sun, const City& city, const PlaceMapLook& look,
                              const std::filesystem::path& file) {
    const std::vector<Place>& places = sun.baseline.places;
    const Grid grid = gridOf(places, look.cellM);
    const std::vector<PlaceBand> bands = listBands(sun);
    std::vector<Values> values(bands.size(),
                               Values(std::size_t(grid.columns) * std::size_t(grid.rows), std::nanf("")));
    for (const std::size_t place : listLargestFirst(places))
        for (const std::uint32_t cell : collectCells(places[place].polygons, grid))
            for (std::size_t band = 0; band < bands.size(); ++band)
                values[band][cell] = float(bands[band].ofPlaces[place]);
    std::vector<RasterBand> written;
    for (std::size_t band = 0; band < bands.size(); ++band)
        written.push_back({bands[band].name, bands[band].unit, &values[band]});
    return writeGeoTiff(file, city.frame, grid, written, look.tags);
}

// Of the file's hours, which are those of the legend.
std::string styleOfHours(const SunByPlace& sun, const PlaceColours& colours) {
    ColourScale scale = makeScale(sun, colours);
    scale.quantity = {};
    scale.of = ColourScale::Of::wanted;
    scale.paintsZero = true;
    return rasterStyle(scale);
}

}  // namespace

const std::vector<std::string>& placeMapNames() {
    static const std::vector<std::string> names{"sun_by_place.tif", "sun_by_place.qml", "sun_by_place.png"};
    return names;
}

void addPlaceMaps(OutputFolder& files, std::shared_ptr<const SunOfCities> sun, const City& city,
                  const PlaceMapLook& look) {
    files.add("sun_by_place.tif", [sun, city, look](const std::filesystem::path& file) {
        return writePlaceRaster(*sun, city, look, file);
    });
    files.add("sun_by_place.qml", textContent(styleOfHours(lastCity(*sun), look.colours)));
    files.add("sun_by_place.png", [sun, city, look](QIODevice& device) {
        return writePng(paintPlacesMap(lastCity(*sun), city, look.colours, look.widthPx), look.tags, device);
    });
}

}  // namespace noonmark
