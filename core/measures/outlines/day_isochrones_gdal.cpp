#include "core/measures/outlines/day_isochrones.h"

#include <cpl_string.h>
#include <fmt/format.h>
#include <gdal_alg.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/gdal_calls.h"

namespace noonmark {

namespace {

constexpr float noValue = -1e30F;

GDALDatasetUniquePtr inMemory(const char* driver, int columns, int rows, int rasters) {
    GDALDriver* made = GetGDALDriverManager()->GetDriverByName(driver);
    return GDALDatasetUniquePtr(
        made == nullptr ? nullptr : made->Create("", columns, rows, rasters, GDT_Float32, nullptr));
}

// GDAL's first row is the southernmost row of the grid.
GDALDatasetUniquePtr rasterOfValues(const Grid& grid, std::vector<float>& values) {
    GDALDatasetUniquePtr raster = inMemory("MEM", grid.columns, grid.rows, 1);
    std::array<double, 6> place{grid.westM, grid.cellM, 0, grid.southM, 0, grid.cellM};
    if (!raster || raster->SetGeoTransform(place.data()) != CE_None) return nullptr;
    GDALRasterBand* cells = raster->GetRasterBand(1);
    cells->SetNoDataValue(double(noValue));
    const bool written = cells->RasterIO(GF_Write, 0, 0, grid.columns, grid.rows, values.data(), grid.columns,
                                         grid.rows, GDT_Float32, 0, 0, nullptr) == CE_None;
    return written ? std::move(raster) : nullptr;
}

// The index of the level is a field of each line.
bool contour(GDALRasterBand& cells, double level, OGRLayer& layer) {
    CPLStringList options;
    options.SetNameValue("FIXED_LEVELS", fmt::format("{:.17g}", level).c_str());
    options.SetNameValue("NODATA", fmt::format("{:.9g}", noValue).c_str());
    options.SetNameValue("POLYGONIZE", "NO");
    return GDALContourGenerateEx(GDALRasterBand::ToHandle(&cells), OGRLayer::ToHandle(&layer), options.List(),
                                 nullptr, nullptr) == CE_None;
}

Isochrone isochroneOf(const OGRLineString& line, double level) {
    Isochrone isochrone{level, {}, line.get_IsClosed() != 0};
    for (int i = 0; i < line.getNumPoints() - (isochrone.closed ? 1 : 0); ++i)
        isochrone.points.emplace_back(glm::dvec2(line.getX(i), line.getY(i)));
    return isochrone;
}

}  // namespace

std::vector<Isochrone> traceIsochrones(const Grid& grid, std::span<const float> values,
                                       std::span<const double> levels) {
    if (values.size() != grid.size() || values.empty()) return {};
    const GdalCalls calls;
    std::vector<float> filled(values.begin(), values.end());
    std::ranges::replace_if(
        filled, [](float value) { return !std::isfinite(value); }, noValue);
    const GDALDatasetUniquePtr raster = rasterOfValues(grid, filled), lines = inMemory("Memory", 0, 0, 0);
    if (!raster || !lines) return {};
    std::vector<Isochrone> isochrones;
    for (const double level : levels) {
        OGRLayer* layer = lines->CreateLayer("lines", nullptr, wkbLineString, nullptr);
        if (layer == nullptr || !contour(*raster->GetRasterBand(1), level, *layer)) return {};
        for (const auto& feature : *layer)
            isochrones.push_back(isochroneOf(*feature->GetGeometryRef()->toLineString(), level));
        lines->DeleteLayer(0);
    }
    return isochrones;
}

}  // namespace noonmark
