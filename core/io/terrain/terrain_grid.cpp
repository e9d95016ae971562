#include "core/io/terrain/raster_place.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <iterator>
#include <limits>
#include <memory>

#include "core/base/safe_text.h"
#include "core/city/terrain/post_grid.h"
#include "core/describe/text.h"
#include "core/geo/frame.h"
#include "core/receivers/rasterize.h"

namespace noonmark {

namespace {

constexpr double maxPosts = 64e6;

bool isFinite(LonLat place) { return std::isfinite(place.lonDeg) && std::isfinite(place.latDeg); }

glm::dvec2 findMiddle(const RasterPlace& raster) { return glm::dvec2(raster.columns, raster.rows) / 2.0; }

// The side of a square as large as the raster's middle pixel, metres.
double pixelM(const RasterPlace& raster, const CrsToLonLat& crs) {
    const glm::dvec2 middle = findMiddle(raster);
    const glm::dvec2 points[] = {raster.at(middle), raster.at(middle + glm::dvec2(1, 0)),
                                 raster.at(middle + glm::dvec2(0, 1))};
    const std::vector<LonLat> places = crs.lonLat(points);
    const Frame frame(places[0]);
    const glm::dvec2 a = frame.localFromLonLat(places[1]);
    const glm::dvec2 b = frame.localFromLonLat(places[2]);
    return std::sqrt(std::abs(a.x * b.y - a.y * b.x));
}

// Points along the window's four sides, in order; points that cannot be transformed are left out.
Ring borderOf(const PixelExtent& window, const PixelPlaces& places) {
    const glm::dvec2 first(window.column, window.row), size(window.columns, window.rows);
    constexpr int perSide = 20;
    std::vector<glm::dvec2> pixels;
    for (const auto& [from, to] :
         {std::pair(glm::dvec2(0, 0), glm::dvec2(1, 0)), std::pair(glm::dvec2(1, 0), glm::dvec2(1, 1)),
          std::pair(glm::dvec2(1, 1), glm::dvec2(0, 1)), std::pair(glm::dvec2(0, 1), glm::dvec2(0, 0))})
        for (int i = 0; i < perSide; ++i)
            pixels.push_back(first + (from + (to - from) * (double(i) / perSide)) * size);
    Ring border;
    for (const glm::dvec2 place : places.local(pixels))
        if (!std::isnan(place.x)) border.emplace_back(place);
    return border;
}

// Chooses squares over the nearby area, at most as many as can be stored.
void chooseSquares(TerrainGrid& place, double farAwayM) {
    const Box2 box = bounds(place.border);
    const glm::dvec2 low = glm::max(glm::dvec2(box.low), glm::dvec2(-farAwayM));
    const glm::dvec2 size = glm::min(glm::dvec2(box.high), glm::dvec2(farAwayM)) - low;
    const double pixel = std::clamp(place.source.sourceCellM, 0.25, 1000.0);
    const double cell = std::max(pixel, std::sqrt(size.x * size.y / maxPosts));
    place.resampledTo =
        Grid{low.x, low.y, cell, std::max(2, int(size.x / cell)), std::max(2, int(size.y / cell))};
    place.posts = *place.resampledTo;
    const bool coarser = cell > place.source.sourceCellM * 1.01;
    place.source.method = coarser ? TerrainMethod::averaged : TerrainMethod::bilinear;
}

void warnOfSquares(TerrainGrid& place, const std::string& file) {
    place.warnings.push_back(
        place.coarser()
            ? Warning{WarningKind::clipped,
                      "the terrain is too fine to be used in full; its cells were made larger",
                      fmt::format("{} ({:.2f} m instead of {:.2f} m)", file, place.posts.cellM,
                                  place.source.sourceCellM)}
            : Warning{WarningKind::clipped,
                      "the terrain was resampled, since no smooth transformation places its rows and columns",
                      file});
}

// Whether the raster's own rows and columns can be used.
bool keepsPosts(TerrainGrid& place, const PixelPlaces& places) {
    const PixelExtent& window = place.window;
    if (window.columns < 2 || window.rows < 2 || double(window.size()) > maxPosts) return false;
    const PlacedPosts placed = placePosts(places, window);
    if (!(placed.misplacedM <= std::max(0.01, placed.posts.cellM / 50))) return false;
    place.posts = placed.posts;
    place.flipped = placed.flipped;
    place.source.method = TerrainMethod::kept;
    place.source.misplacedM = placed.misplacedM;
    return true;
}

std::size_t removeImpossible(std::vector<float>& elevations) {
    std::size_t impossible = 0;
    for (float& elevation : elevations) {
        if (std::isnan(elevation) || (elevation > -500 && elevation < 9000)) continue;
        elevation = std::numeric_limits<float>::quiet_NaN();
        ++impossible;
    }
    return impossible;
}

// For squares, counts only those whose centres lie in the raster.
std::size_t gapsInside(const TerrainGrid& place, const std::vector<float>& elevations) {
    const auto isGap = [](float elevation) { return std::isnan(elevation); };
    if (!place.resampledTo) return std::size_t(std::ranges::count_if(elevations, isGap));
    std::size_t gaps = 0;
    forEachRun({place.border, {}}, *place.resampledTo, [&](int row, int first, int end) {
        for (int column = first; column < end; ++column)
            gaps += isGap(elevations[place.posts.index(column, row)]) ? 1 : 0;
    });
    return gaps;
}

float findLowest(const std::vector<float>& elevations) {
    float lowest = std::numeric_limits<float>::infinity();
    for (const float elevation : elevations)
        if (elevation < lowest) lowest = elevation;
    return lowest;
}

}  // namespace

Result<TerrainGrid> makeTerrainGrid(const RasterPlace& raster, const CrsToLonLat& crs,
                                    const ReadSettings& settings, const std::string& file) {
    const glm::dvec2 middle[] = {raster.at(findMiddle(raster))};
    const LonLat centre = crs.lonLat(middle)[0];
    const double pixel = isFinite(centre) ? pixelM(raster, crs) : 0;
    if (!isFinite(centre) || !crs.isPlausible(centre) || !(pixel > 0))
        return failure(fmt::format("The raster's coordinates cannot belong to {}", crs.name()), file,
                       "Check which coordinate reference system it is in");
    TerrainGrid place{.frame = settings.frame.value_or(Frame(centre))};
    place.source = {.file = std::filesystem::path(file).filename().string(),
                    .sourceColumns = std::size_t(raster.columns),
                    .sourceRows = std::size_t(raster.rows),
                    .sourceCellM = pixel};
    const PixelPlaces places(raster, crs, place.frame);
    const auto window = extentNear(raster, places, settings.farAwayM);
    if (!window)
        return failure("The terrain does not cover the city", file, "Choose a terrain of the same area");
    place.window = *window;
    place.source.cut = *window != PixelExtent{0, 0, raster.columns, raster.rows};
    if (place.source.cut)
        place.warnings.push_back(
            {WarningKind::clipped, NM_TEXT("terrain far from the city was left out"), file});
    place.border = borderOf(*window, places);
    if (keepsPosts(place, places)) return place;
    if (place.border.size() < 3)
        return failure("The terrain does not cover the city", file, "Choose a terrain of the same area");
    chooseSquares(place, settings.farAwayM);
    warnOfSquares(place, file);
    return place;
}

Result<void> finishTerrain(const TerrainGrid& place, std::vector<float> elevations,
                           const ReadSettings& settings, const std::string& file, FilePiece& piece) {
    TerrainSource source = place.source;
    source.impossible = removeImpossible(elevations);
    if (source.impossible > 0)
        piece.warnings.push_back({WarningKind::repaired,
                                  "impossible elevations were filled from the cells around",
                                  fmt::format("{} ({})", file, countOf(source.impossible, "cell"))});
    source.filled = gapsInside(place, elevations);
    if (source.filled > 0)
        piece.warnings.push_back(
            {WarningKind::repaired, NM_TEXT("cells without elevation were filled from the cells around"),
             fmt::format("{} ({} of {})", file, source.filled, countOf(elevations.size(), "cell"))});
    if (std::ranges::any_of(elevations, [](float elevation) { return std::isnan(elevation); }))
        std::ranges::transform(elevations, std::back_inserter(piece.unknownPosts),
                               [](float elevation) { return char(std::isnan(elevation)); });
    fillGaps(elevations, place.posts.columns, place.posts.rows);
    const float lowest = findLowest(elevations);
    if (!std::isfinite(lowest))
        return failure("The terrain has no elevations here", file, "Choose a terrain that covers the city");
    const Frame frame = settings.frame.value_or(Frame(place.frame.origin(), double(lowest)));
    for (int row = 0; row < place.posts.rows; ++row)
        for (int column = 0; column < place.posts.columns; ++column) {
            float& elevation = elevations[place.posts.index(column, row)];
            elevation = float(double(elevation) - frame.originElevationM() -
                              earthDropM(place.posts.centre(column, row)));
        }
    if (!settings.frame) piece.frame = frame;
    piece.terrain =
        std::make_shared<const Terrain>(Terrain{place.posts, std::move(elevations), std::move(source)});
    piece.features = 1;
    return {};
}

}  // namespace noonmark
