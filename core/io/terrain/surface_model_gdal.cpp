#include "core/io/terrain/ground_choice.h"

#include <gdal_alg.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>
#include <cmath>

#include "core/base/gdal_calls.h"

namespace noonmark {

namespace {

// A band over a vector, which must outlive it.
template <class T>
GDALDatasetUniquePtr makeBand(std::vector<T>& values, int columns, int rows, GDALDataType type) {
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("MEM");
    if (driver == nullptr) return nullptr;
    GDALDatasetUniquePtr dataset(driver->Create("", columns, rows, 0, type, nullptr));
    char pointer[64] = {};
    pointer[CPLPrintPointer(pointer, values.data(), sizeof(pointer))] = 0;
    char** options = CSLSetNameValue(nullptr, "DATAPOINTER", pointer);
    const bool added = dataset && dataset->AddBand(type, options) == CE_None;
    CSLDestroy(options);
    return added ? std::move(dataset) : nullptr;
}

}  // namespace

void fillFromAround(std::vector<float>& values, int columns, int rows, const std::stop_token& stop) {
    const GdalCalls gdal;
    constexpr double farthestCells = 200;
    std::vector<unsigned char> known(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) known[i] = std::isnan(values[i]) ? 0 : 255;
    const auto band = makeBand(values, columns, rows, GDT_Float32);
    const auto mask = makeBand(known, columns, rows, GDT_Byte);
    if (!band || !mask) return;  // the caller fills what is left
    char** options = CSLSetNameValue(nullptr, "TEMP_FILE_DRIVER", "MEM");
    (void)GDALFillNodata(band->GetRasterBand(1), mask->GetRasterBand(1), farthestCells, 0, 0, options,
                         continueUnlessStopped, const_cast<std::stop_token*>(&stop));
    CSLDestroy(options);
}

namespace {

RawRing pointsOf(const OGRLinearRing& ring) {
    RawRing points;
    for (int i = 0; i < ring.getNumPoints(); ++i) points.emplace_back(ring.getX(i), ring.getY(i));
    return points;
}

std::vector<RawRing> ringsOf(const OGRPolygon& polygon) {
    std::vector<RawRing> rings;
    for (const OGRLinearRing* ring : polygon) rings.push_back(pointsOf(*ring));
    return rings;
}

}  // namespace

bool outlineNumbers(std::vector<std::int32_t>& numbers, int columns, int rows,
                    const std::function<void(std::int32_t, const std::vector<RawRing>&)>& take,
                    const std::stop_token& stop) {
    const GdalCalls gdal(stop);
    const auto raster = makeBand(numbers, columns, rows, GDT_Int32);
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("Memory");
    if (!raster || driver == nullptr) return false;
    const GDALDatasetUniquePtr shapes(driver->Create("", 0, 0, 0, GDT_Unknown, nullptr));
    OGRLayer* layer = shapes ? shapes->CreateLayer("outlines", nullptr, wkbPolygon) : nullptr;
    OGRFieldDefn number("number", OFTInteger);
    if (layer == nullptr || layer->CreateField(&number) != OGRERR_NONE) return false;
    GDALRasterBand* band = raster->GetRasterBand(1);  // its zeros mask themselves
    if (GDALPolygonize(band, band, OGRLayer::ToHandle(layer), 0, nullptr, continueUnlessStopped,
                       const_cast<std::stop_token*>(&stop)) != CE_None)
        return false;
    for (const auto& feature : *layer) {
        if (stop.stop_requested()) return false;
        if (const OGRGeometry* shape = feature->GetGeometryRef())
            take(feature->GetFieldAsInteger(0), ringsOf(*shape->toPolygon()));
    }
    return true;
}

}  // namespace noonmark
