#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <array>
#include <cstddef>
#include <limits>

#include "core/io/gdal_calls.h"
#include "core/io/pending_file.h"
#include "core/io/write_raster.h"

namespace noonmark {

namespace {

constexpr int tileCells = 256;

tl::unexpected<Error> notWritten(const std::filesystem::path& file, const std::string& why) {
    return failure("The map could not be written: " + why, file.string(),
                   "Check that the folder exists, can be written to and has room");
}

GDALDatasetUniquePtr created(const std::filesystem::path& file, const Grid& grid, std::size_t bands) {
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
    if (driver == nullptr) return nullptr;
    const std::string tile = fmt::format("{}", tileCells);
    CPLStringList options;
    options.SetNameValue("TILED", "YES");
    options.SetNameValue("BLOCKXSIZE", tile.c_str());
    options.SetNameValue("BLOCKYSIZE", tile.c_str());
    options.SetNameValue("COMPRESS", "DEFLATE");
    options.SetNameValue("PREDICTOR", "3");  // differences of floats: half the size
    options.SetNameValue("INTERLEAVE", "BAND");
    options.SetNameValue("BIGTIFF", "IF_SAFER");
    options.SetNameValue("NUM_THREADS", "ALL_CPUS");
    return GDALDatasetUniquePtr(
        driver->Create(file.c_str(), grid.columns, grid.rows, int(bands), GDT_Float32, options.List()));
}

bool place(GDALDataset& dataset, const Frame& frame, const Grid& grid) {
    OGRSpatialReference plane;
    if (plane.importFromProj4(frame.projString().c_str()) != OGRERR_NONE) return false;
    plane.SetProjCS("Local plane of the Noonmark project");
    std::array<double, 6> corner{grid.westM, grid.cellM, 0, grid.northM(), 0, -grid.cellM};
    return dataset.SetSpatialRef(&plane) == CE_None && dataset.SetGeoTransform(corner.data()) == CE_None;
}

bool fill(GDALRasterBand& to, const RasterBand& from, const Grid& grid) {
    to.SetDescription(from.name.c_str());
    to.SetUnitType(from.unit.c_str());
    to.SetNoDataValue(std::numeric_limits<double>::quiet_NaN());
    // Our rows run northwards, the file's southwards: begin at the last row and step back. GDAL only reads
    // through the pointer.
    const auto lineBytes = GSpacing(sizeof(float)) * grid.columns;
    auto* lastRow = const_cast<float*>(from.values->data() + grid.index(0, grid.rows - 1));
    return to.RasterIO(GF_Write, 0, 0, grid.columns, grid.rows, lastRow, grid.columns, grid.rows, GDT_Float32,
                       sizeof(float), -lineBytes, nullptr) == CE_None;
}

bool addOverviews(GDALDataset& dataset, const Grid& grid) {
    std::vector<int> factors;
    for (int factor = 2; std::max(grid.columns, grid.rows) > tileCells * factor / 2; factor *= 2)
        factors.push_back(factor);
    if (factors.empty()) return true;
    return dataset.BuildOverviews("AVERAGE", int(factors.size()), factors.data(), 0, nullptr, nullptr,
                                  nullptr) == CE_None;
}

bool writeAll(GDALDataset& dataset, const Frame& frame, const Grid& grid,
              const std::vector<RasterBand>& bands) {
    if (!place(dataset, frame, grid)) return false;
    for (std::size_t i = 0; i < bands.size(); ++i)
        if (!fill(*dataset.GetRasterBand(int(i) + 1), bands[i], grid)) return false;
    dataset.FlushCache(false);
    return addOverviews(dataset, grid);
}

Result<void> checkedBands(const std::filesystem::path& file, const Grid& grid,
                          const std::vector<RasterBand>& bands) {
    if (grid.columns < 1 || grid.rows < 1 || bands.empty())
        return notWritten(file, "there are no cells or no bands");
    for (const RasterBand& band : bands)
        if (band.values == nullptr || band.values->size() != grid.size())
            return notWritten(file, fmt::format("band '{}' does not have one value a cell", band.name));
    return {};
}

}  // namespace

Result<void> writeGeoTiff(const std::filesystem::path& file, const Frame& frame, const Grid& grid,
                          const std::vector<RasterBand>& bands) {
    if (auto sound = checkedBands(file, grid, bands); !sound) return sound;
    const GdalCalls calls;
    PendingFile pending(file);
    GDALDatasetUniquePtr dataset = created(pending.path(), grid, bands.size());
    const bool written = dataset && writeAll(*dataset, frame, grid, bands);
    dataset.reset();  // flushes: a full disk shows here
    if (!written || calls.failed()) return notWritten(file, calls.why());
    return pending.commit();
}

}  // namespace noonmark
