#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "core/base/gdal_calls.h"
#include "core/io/files/open_dataset.h"
#include "core/io/files/write_text.h"
#include "core/io/write_raster.h"

namespace noonmark {

namespace {

tl::unexpected<Error> notWritten(const std::filesystem::path& file, const std::string& why) {
    return limitReached("The map could not be written: " + why, file.string(),
                        "Check that the folder exists, is writable and has space");
}

GDALDatasetUniquePtr createDataset(const std::filesystem::path& file, const Grid& grid, std::size_t bands) {
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
    if (driver == nullptr) return nullptr;
    const std::string block = fmt::format("{}", GeoTiffWriter::blockCells);
    CPLStringList options;
    options.SetNameValue("TILED", "YES");
    options.SetNameValue("BLOCKXSIZE", block.c_str());
    options.SetNameValue("BLOCKYSIZE", block.c_str());
    options.SetNameValue("COMPRESS", "DEFLATE");
    // Differences of the bits of neighbours: smaller than floating-point differences at the usual level, and
    // in half the time.
    options.SetNameValue("PREDICTOR", "2");
    options.SetNameValue("ZLEVEL", "3");
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

void describe(GDALDataset& dataset, const std::vector<RasterBand>& bands, const FileTags& tags) {
    for (const auto& [name, text] : tags) dataset.SetMetadataItem(name.c_str(), text.c_str());
    for (std::size_t i = 0; i < bands.size(); ++i) {
        GDALRasterBand& band = *dataset.GetRasterBand(int(i) + 1);
        band.SetDescription(bands[i].name.c_str());
        band.SetUnitType(bands[i].unit.c_str());
        band.SetNoDataValue(std::numeric_limits<double>::quiet_NaN());
    }
}

// Our rows run northwards, the file's southwards: starts at the last row and steps back.
bool transfer(GDALRWFlag direction, GDALRasterBand& band, float* values, const Grid& part, int fileColumn,
              int fileRow) {
    const auto lineBytes = GSpacing(sizeof(float)) * part.columns;
    return band.RasterIO(direction, fileColumn, fileRow, part.columns, part.rows,
                         values + part.index(0, part.rows - 1), part.columns, part.rows, GDT_Float32,
                         sizeof(float), -lineBytes, nullptr) == CE_None;
}

bool addOverviews(GDALDataset& dataset, const Grid& grid, std::stop_token stop) {
    std::vector<int> factors;
    for (int factor = 2; std::max(grid.columns, grid.rows) > GeoTiffWriter::blockCells * factor / 2;
         factor *= 2)
        factors.push_back(factor);
    if (factors.empty()) return true;
    return dataset.BuildOverviews("AVERAGE", int(factors.size()), factors.data(), 0, nullptr,
                                  continueUnlessStopped, &stop) == CE_None;
}

}  // namespace

struct GeoTiffWriter::Pending {
    PendingFile pending;
    std::filesystem::path file;
    Grid grid;
    GDALDatasetUniquePtr dataset;
};

GeoTiffWriter::GeoTiffWriter(std::unique_ptr<Pending> pending) : pending_(std::move(pending)) {}
GeoTiffWriter::GeoTiffWriter(GeoTiffWriter&&) noexcept = default;
GeoTiffWriter& GeoTiffWriter::operator=(GeoTiffWriter&&) noexcept = default;
GeoTiffWriter::~GeoTiffWriter() = default;

Result<GeoTiffWriter> GeoTiffWriter::create(const std::filesystem::path& file, const Frame& frame,
                                            const Grid& grid, const std::vector<RasterBand>& bands,
                                            const FileTags& tags) {
    if (grid.columns < 1 || grid.rows < 1 || bands.empty())
        return notWritten(file, "there are no cells or no bands");
    const GdalCalls calls;
    std::unique_ptr<Pending> pending(new Pending{PendingFile(file), file, grid, nullptr});
    pending->dataset = createDataset(pending->pending.path(), grid, bands.size());
    if (!pending->dataset || !place(*pending->dataset, frame, grid)) return notWritten(file, calls.why());
    describe(*pending->dataset, bands, tags);
    if (calls.failed()) return notWritten(file, calls.why());
    return GeoTiffWriter(std::move(pending));
}

Result<void> GeoTiffWriter::write(const Grid& part, const std::vector<const std::vector<float>*>& values) {
    const GdalCalls calls;
    const Grid& grid = pending_->grid;
    const int column = int(std::lround((part.westM - grid.westM) / grid.cellM));
    const int fileRow = int(std::lround((grid.northM() - part.northM()) / grid.cellM));
    for (std::size_t i = 0; i < values.size(); ++i) {
        auto* first = const_cast<float*>(values[i]->data());  // GDAL only reads through this pointer
        if (!transfer(GF_Write, *pending_->dataset->GetRasterBand(int(i) + 1), first, part, column, fileRow))
            return notWritten(pending_->file, calls.why());
    }
    return {};
}

Result<void> GeoTiffWriter::finish(bool overviews, const std::stop_token& stop) {
    const GdalCalls calls;
    pending_->dataset->FlushCache(false);
    // GDAL ends the process where it makes overviews of a file that could not be written.
    const bool whole =
        !calls.failed() && (!overviews || addOverviews(*pending_->dataset, pending_->grid, stop));
    pending_->dataset.reset();  // flushes: a full disk is reported here
    if (stop.stop_requested()) return cancelled();
    if (!whole || calls.failed()) return notWritten(pending_->file, calls.why());
    return pending_->pending.commit();
}

Result<void> writeGeoTiff(const std::filesystem::path& file, const Frame& frame, const Grid& grid,
                          const std::vector<RasterBand>& bands, const FileTags& tags) {
    std::vector<const std::vector<float>*> values;
    for (const RasterBand& band : bands) {
        if (band.values == nullptr || band.values->size() != grid.size())
            return notWritten(file, fmt::format("band '{}' does not have one value per cell", band.name));
        values.push_back(band.values);
    }
    auto writer = GeoTiffWriter::create(file, frame, grid, bands, tags);
    if (!writer) return tl::make_unexpected(writer.error());
    return writer->write(grid, values).and_then([&] { return writer->finish(); });
}

Result<std::vector<std::vector<float>>> readGeoTiff(const std::filesystem::path& file, const Grid& grid) {
    const GdalCalls calls;
    const auto open = openDataset(file, DatasetContent::maps);
    if (!open || (*open)->GetRasterXSize() != grid.columns || (*open)->GetRasterYSize() != grid.rows)
        return failure("The map is not the one that this run wrote", file.string(),
                       "Remove it and run again");
    GDALDataset& dataset = **open;
    std::vector<std::vector<float>> bands(std::size_t(dataset.GetRasterCount()));
    for (std::size_t i = 0; i < bands.size(); ++i) {
        bands[i].resize(grid.size());
        if (!transfer(GF_Read, *dataset.GetRasterBand(int(i) + 1), bands[i].data(), grid, 0, 0))
            return failure("The map could not be read: " + calls.why(), file.string(),
                           "Remove it and run again");
    }
    return bands;
}

}  // namespace noonmark
