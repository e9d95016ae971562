#include <fmt/format.h>
#include <gdal_priv.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "core/geo/crs_definition.h"
#include "core/geo/crs_to_lon_lat.h"
#include "core/io/settings/place_advice.h"
#include "core/io/trees/read_canopy.h"

namespace noonmark {

namespace {

constexpr std::size_t maxCanopyCells = 2'000'000;
constexpr double leastCanopyM = 2, highestCanopyM = 120;  // lower growth shades no one who stands

using Placing = std::array<double, 6>;

glm::dvec2 placeInRaster(const Placing& placing, double column, double row) {
    return {placing[0] + column * placing[1] + row * placing[2],
            placing[3] + column * placing[4] + row * placing[5]};
}

/// The cells of a raster that hold canopy.
struct CanopyCells {
    std::vector<glm::dvec2> places;  // centres, in the raster's system
    std::vector<float> heightsM;
};

Result<CanopyCells> readCells(GDALRasterBand& band, const Placing& placing, const std::string& file,
                              Progress& progress, const std::stop_token& stop) {
    CanopyCells cells;
    std::vector<float> row(std::size_t(band.GetXSize()));
    for (int y = 0; y < band.GetYSize(); ++y) {
        if (stop.stop_requested()) return cancelled();
        if (band.RasterIO(GF_Read, 0, y, band.GetXSize(), 1, row.data(), band.GetXSize(), 1, GDT_Float32, 0,
                          0) != CE_None)
            return failure("It is incomplete or damaged", file, "Download or export it again");
        for (std::size_t x = 0; x < row.size(); ++x) {
            if (!(row[x] >= leastCanopyM && row[x] <= highestCanopyM)) continue;
            cells.places.push_back(placeInRaster(placing, double(x) + 0.5, y + 0.5));
            cells.heightsM.push_back(row[x]);
        }
        if (cells.places.size() > maxCanopyCells)
            return limitReached(fmt::format("It holds more than {} cells of canopy", maxCanopyCells), file,
                                "Cut out the part around the city, or make its cells larger");
        progress.report(double(y) / band.GetYSize(), "reading canopy");
    }
    return cells;
}

// Square metres of a cell in the middle of the raster.
double computeCellArea(const CrsToLonLat& toLonLat, const Placing& placing, double column, double row) {
    const std::array corners{placeInRaster(placing, column, row), placeInRaster(placing, column + 1, row),
                             placeInRaster(placing, column, row + 1)};
    const std::vector<LonLat> places = toLonLat.lonLat(corners);
    if (!std::isfinite(places[0].lonDeg)) return std::numeric_limits<double>::quiet_NaN();
    const Frame frame(places[0]);
    const glm::dvec2 along = frame.localFromLonLat(places[1]), up = frame.localFromLonLat(places[2]);
    return std::abs(along.x * up.y - along.y * up.x);
}

}  // namespace

Result<TreesRead> readCanopy(GDALDataset& dataset, const std::string& file,
                             const std::optional<std::string>& crs, Progress& progress,
                             const std::stop_token& stop) {
    Placing placing{};
    if (dataset.GetRasterCount() < 1 || dataset.GetGeoTransform(placing.data()) != CE_None)
        return failure("It states no place", file, "Give a georeferenced raster of canopy heights");
    const std::string system = crs.value_or(wktOf(dataset.GetSpatialRef()));
    if (system.empty()) return failure("It states no coordinate reference system", file, crsAdvice());
    const auto toLonLat = CrsToLonLat::of(system);
    if (!toLonLat) return tl::make_unexpected(toLonLat.error());
    GDALRasterBand& band = *dataset.GetRasterBand(1);
    const double cellM2 = computeCellArea(*toLonLat, placing, band.GetXSize() / 2.0, band.GetYSize() / 2.0);
    if (!(cellM2 > 0.01 && cellM2 < 400))
        return failure("Its cells are smaller than 0.1 m or larger than 20 m", file,
                       "Give canopy heights in cells of about a metre");
    const auto cells = readCells(band, placing, file, progress, stop);
    if (!cells) return tl::make_unexpected(cells.error());
    const std::vector<LonLat> places = toLonLat->lonLat(cells->places);
    TreesRead read;
    for (std::size_t i = 0; i < places.size(); ++i)
        read.trees.push_back(
            {places[i],
             {.sourceId = "canopy", .heightM = double(cells->heightsM[i]), .canopyCellM2 = cellM2}});
    if (read.trees.empty())
        return failure("It holds no canopy of 2 to 120 m", file,
                       "Give heights of the canopy above the ground, in metres");
    read.warnings.push_back({WarningKind::assumed,
                             "canopy is taken as trees that lose their leaves, open below",
                             fmt::format("{}: {} cells", file, read.trees.size())});
    return read;
}

}  // namespace noonmark
