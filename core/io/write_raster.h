#pragma once

#include <filesystem>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/geo/frame.h"
#include "core/geo/grid.h"
#include "core/io/files/file_tags.h"

namespace noonmark {

/// One band of a raster file.
struct RasterBand {
    std::string name;  ///< "gross shadow"
    std::string unit;  ///< "min/day"
    const std::vector<float>*
        values;  ///< grid order (row 0 south); NaN = nodata. Not owned; outlives the call.
};

/// A tiled, deflate-compressed Float32 GeoTIFF in the frame's own projection, nodata NaN, row 0 north as GIS
/// expects, written piece by piece: what it holds of the raster is some blocks of the file. Written beside
/// the target and renamed, so that a killed process leaves no half file. Backend: write_raster_gdal.cpp.
class GeoTiffWriter {
public:
    /// Side of the file's blocks, cells. Pieces whose sides are multiples of it, counted from the grid's
    /// NORTH-WEST corner, are written fastest.
    static constexpr int blockCells = 256;

    /// `bands`: names and units; values are not looked at. `tags`: metadata items of the file.
    static Result<GeoTiffWriter> create(const std::filesystem::path& file, const Frame& frame,
                                        const Grid& grid, const std::vector<RasterBand>& bands,
                                        const FileTags& tags = {});
    GeoTiffWriter(GeoTiffWriter&&) noexcept;
    GeoTiffWriter& operator=(GeoTiffWriter&&) noexcept;
    ~GeoTiffWriter();

    /// A part of the grid, with its values of every band. What is never written is unspecified.
    Result<void> write(const Grid& part, const std::vector<const std::vector<float>*>& values);

    /// Overviews (means of 2 x 2 cells, down to one block) where asked for, and the file takes its name.
    /// cancelled() when stopped before.
    Result<void> finish(bool overviews = true, const std::stop_token& stop = {});

private:
    struct Pending;
    explicit GeoTiffWriter(std::unique_ptr<Pending> pending);
    std::unique_ptr<Pending> pending_;
};

/// All at once, with overviews.
Result<void> writeGeoTiff(const std::filesystem::path& file, const Frame& frame, const Grid& grid,
                          const std::vector<RasterBand>& bands, const FileTags& tags = {});

/// The bands of a file that a GeoTiffWriter wrote over `grid`, each in grid order. Error: it can't be read,
/// or has another size.
Result<std::vector<std::vector<float>>> readGeoTiff(const std::filesystem::path& file, const Grid& grid);

}  // namespace noonmark
