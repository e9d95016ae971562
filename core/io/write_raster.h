#pragma once

#include <filesystem>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/geo/frame.h"
#include "core/geo/grid.h"
#include "core/io/files/write_text.h"

namespace noonmark {

/// One band of a raster file.
struct RasterBand {
    std::string name;  ///< "gross shadow"
    std::string unit;  ///< "min/day"
    const std::vector<float>*
        values;  ///< grid order (row 0 south); NaN = nodata. Not owned; must outlive the call.
};

/// Writes a tiled, deflate-compressed Float32 GeoTIFF in the frame's own projection, nodata NaN, row 0 north
/// as GIS expects. The raster is written piece by piece, and only some blocks of the file are in memory.
/// Written beside the target and renamed, so that a killed process leaves no incomplete file. Backend:
/// write_raster_gdal.cpp.
class GeoTiffWriter {
public:
    /// Side of the file's blocks, cells. Fastest for pieces whose sides are multiples of it, counted from the
    /// grid's NORTH-WEST corner.
    static constexpr int blockCells = 256;

    /// `bands`: names and units; values are ignored. `tags`: metadata items of the file.
    static Result<GeoTiffWriter> create(const std::filesystem::path& file, const Frame& frame,
                                        const Grid& grid, const std::vector<RasterBand>& bands,
                                        const FileTags& tags = {});
    GeoTiffWriter(GeoTiffWriter&&) noexcept;
    GeoTiffWriter& operator=(GeoTiffWriter&&) noexcept;
    ~GeoTiffWriter();

    /// Writes a part of the grid, with its values of every band. Cells that are never written have
    /// unspecified values.
    Result<void> write(const Grid& part, const std::vector<const std::vector<float>*>& values);

    /// Adds overviews (means of 2 x 2 cells, down to one block) if wanted, and renames the file to the
    /// target. cancelled() if stopped before.
    Result<void> finish(bool overviews = true, const std::stop_token& stop = {});

private:
    struct Pending;
    explicit GeoTiffWriter(std::unique_ptr<Pending> pending);
    std::unique_ptr<Pending> pending_;
};

/// Writes a whole GeoTIFF, with overviews.
Result<void> writeGeoTiff(const std::filesystem::path& file, const Frame& frame, const Grid& grid,
                          const std::vector<RasterBand>& bands, const FileTags& tags = {});

/// Reads the bands of a file that a GeoTiffWriter wrote over `grid`, each in grid order. Error: it cannot be
/// read, or has another size.
Result<std::vector<std::vector<float>>> readGeoTiff(const std::filesystem::path& file, const Grid& grid);

}  // namespace noonmark
