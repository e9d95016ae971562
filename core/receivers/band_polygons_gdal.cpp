#include <gdal_alg.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <array>
#include <glm/vec2.hpp>

#include "core/base/gdal_calls.h"
#include "core/receivers/band_polygons.h"

namespace noonmark {

namespace {

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

Ring ringOf(const OGRLinearRing& closed, bool counterClockwise) {
    Ring ring;
    for (int i = 0; i + 1 < closed.getNumPoints(); ++i)
        ring.emplace_back(glm::dvec2(closed.getX(i), closed.getY(i)));
    if ((signedArea(ring) > 0) != counterClockwise) std::ranges::reverse(ring);
    return ring;
}

Footprint footprintOf(const OGRPolygon& polygon) {
    Footprint footprint{ringOf(*polygon.getExteriorRing(), true), {}};
    for (int i = 0; i < polygon.getNumInteriorRings(); ++i)
        footprint.holes.push_back(ringOf(*polygon.getInteriorRing(i), false));
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
        polygons.push_back(
            {feature->GetFieldAsInteger(0), footprintOf(*feature->GetGeometryRef()->toPolygon())});
    return polygons;
}

}  // namespace noonmark
