#include <gdal_alg.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <array>
#include <glm/vec2.hpp>

#include "core/base/gdal_calls.h"
#include "core/io/footprints/ogr_polygons.h"
#include "scenarios/project/tables/band_polygons.h"

namespace noonmark {

namespace {

constexpr int noBand = -1;

GDALDatasetUniquePtr memory(const char* driver, int columns, int rows, int rasters) {
    GDALDriver* made = GetGDALDriverManager()->GetDriverByName(driver);
    return GDALDatasetUniquePtr(
        made == nullptr ? nullptr : made->Create("", columns, rows, rasters, GDT_Int32, nullptr));
}

// GDAL's first row is the southernmost row of the grid. With a positive cell height north is still up.
GDALDatasetUniquePtr rasterOf(const Grid& grid, std::vector<int>& bands) {
    GDALDatasetUniquePtr raster = memory("MEM", grid.columns, grid.rows, 1);
    std::array<double, 6> place{grid.westM, grid.cellM, 0, grid.southM, 0, grid.cellM};
    if (!raster || raster->SetGeoTransform(place.data()) != CE_None) return nullptr;
    GDALRasterBand* cells = raster->GetRasterBand(1);
    cells->SetNoDataValue(noBand);
    const bool written = cells->RasterIO(GF_Write, 0, 0, grid.columns, grid.rows, bands.data(), grid.columns,
                                         grid.rows, GDT_Int32, 0, 0, nullptr) == CE_None;
    return written ? std::move(raster) : nullptr;
}

Footprint footprintOf(const CrsPolygon& polygon) {
    Footprint footprint;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        Ring ring;
        for (const glm::dvec2 point : polygon[i]) ring.emplace_back(point);
        if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
        if ((signedArea(ring) > 0) != (i == 0)) std::ranges::reverse(ring);
        (i == 0 ? footprint.outer : footprint.holes.emplace_back()) = std::move(ring);
    }
    return footprint;
}

}  // namespace

std::vector<BandPolygon> traceBands(const Grid& grid, std::vector<int> bands) {
    const GdalCalls calls;
    const GDALDatasetUniquePtr raster = rasterOf(grid, bands), shapes = memory("Memory", 0, 0, 0);
    if (!raster || !shapes) return {};
    OGRLayer* layer = shapes->CreateLayer("bands", nullptr, wkbPolygon, nullptr);
    OGRFieldDefn field("band", OFTInteger);
    GDALRasterBand* cells = raster->GetRasterBand(1);
    if (layer == nullptr || layer->CreateField(&field) != OGRERR_NONE ||
        GDALPolygonize(cells, cells->GetMaskBand(), layer, 0, nullptr, nullptr, nullptr) != CE_None)
        return {};
    std::vector<BandPolygon> polygons;
    for (const auto& feature : *layer)
        for (const CrsPolygon& polygon : readPolygons(*feature->GetGeometryRef()))
            polygons.push_back({feature->GetFieldAsInteger(0), footprintOf(polygon)});
    return polygons;
}

}  // namespace noonmark
