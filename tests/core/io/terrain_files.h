#pragma once

#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogr_spatialref.h>

#include <filesystem>
#include <functional>
#include <vector>

#include "core/base/gdal_calls.h"
#include "core/geo/frame.h"

namespace noonmark::tests {

/// Writes a GeoTIFF of 400 x 400 posts about 1 m apart around a place: `elevationM(x, y)` is that at local
/// metres from the place.
inline std::filesystem::path writeTerrain(const std::filesystem::path& path, LonLat around,
                                          const std::function<double(double, double)>& elevationM) {
    constexpr int side = 400;
    constexpr double stepDeg = 1e-5;
    const GdalCalls calls;
    const GDALDatasetUniquePtr dataset(GetGDALDriverManager()->GetDriverByName("GTiff")->Create(
        path.c_str(), side, side, 1, GDT_Float32, nullptr));
    const double west = around.lonDeg - side / 2 * stepDeg, north = around.latDeg + side / 2 * stepDeg;
    double placing[] = {west, stepDeg, 0, north, 0, -stepDeg};
    dataset->SetGeoTransform(placing);
    OGRSpatialReference wgs84;
    wgs84.SetWellKnownGeogCS("WGS84");
    dataset->SetSpatialRef(&wgs84);
    std::vector<float> elevations;
    const Frame frame(around);
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column) {
            const glm::dvec2 at =
                frame.localFromLonLat({west + (column + 0.5) * stepDeg, north - (row + 0.5) * stepDeg});
            elevations.push_back(float(elevationM(at.x, at.y)));
        }
    EXPECT_EQ(dataset->GetRasterBand(1)->RasterIO(GF_Write, 0, 0, side, side, elevations.data(), side, side,
                                                  GDT_Float32, 0, 0),
              CE_None);
    return path;
}

}  // namespace noonmark::tests
