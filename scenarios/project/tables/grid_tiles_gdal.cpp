#include <cpl_vsi.h>
#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <atomic>
#include <cmath>
#include <limits>

#include "core/base/gdal_calls.h"
#include "core/io/files/open_dataset.h"
#include "scenarios/project/tables/grid_tiles.h"

namespace noonmark {

namespace {

std::string memoryFile() {
    static std::atomic<unsigned> made{0};
    return fmt::format("/vsimem/noonmark-tile-{}.tif", made++);
}

// Row of the grid for a line of a tile; lines run from north to south.
int rowOf(const Grid& grid, int tileRow, int line) { return grid.rows - 1 - (tileRow * tileCells + line); }

std::size_t indexInTile(int line, int column) { return std::size_t(line) * tileCells + std::size_t(column); }

std::vector<float> cellsOf(const Grid& grid, const std::vector<float>& values, int column, int row) {
    std::vector<float> cells(std::size_t(tileCells) * tileCells, tileNoData);
    for (int line = 0; line < tileCells; ++line)
        for (int x = 0; x < tileCells; ++x) {
            const int c = column * tileCells + x, r = rowOf(grid, row, line);
            if (c >= grid.columns || r < 0) continue;
            const float value = values[grid.index(c, r)];
            if (!std::isnan(value)) cells[indexInTile(line, x)] = value;
        }
    return cells;
}

bool wrote(const std::string& file, std::vector<float>& cells) {
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
    if (driver == nullptr) return false;
    const char* const options[] = {"COMPRESS=DEFLATE", "PREDICTOR=3", nullptr};
    const GDALDatasetUniquePtr dataset(
        driver->Create(file.c_str(), tileCells, tileCells, 1, GDT_Float32, const_cast<char**>(options)));
    return dataset &&
           dataset->GetRasterBand(1)->RasterIO(GF_Write, 0, 0, tileCells, tileCells, cells.data(), tileCells,
                                               tileCells, GDT_Float32, 0, 0, nullptr) == CE_None;
}

// GDAL reads whole blocks: a block larger than the tile could exhaust memory.
bool isTile(GDALDataset& dataset) {
    if (dataset.GetRasterXSize() != tileCells || dataset.GetRasterYSize() != tileCells ||
        dataset.GetRasterCount() != 1)
        return false;
    int columns = 0, rows = 0;
    dataset.GetRasterBand(1)->GetBlockSize(&columns, &rows);
    return columns <= tileCells && rows <= tileCells;
}

}  // namespace

std::string localCrsWkt(const Frame& frame) {
    const GdalCalls calls;
    OGRSpatialReference plane;
    plane.importFromProj4(frame.projString().c_str());
    plane.SetProjCS("Local plane of the Noonmark project");
    char* text = nullptr;
    plane.exportToWkt(&text);
    const std::string wkt = text != nullptr ? text : "undefined";
    CPLFree(text);
    return wkt;
}

Bytes encodeTile(const Grid& grid, const std::vector<float>& values, int column, int row) {
    const GdalCalls calls;
    const std::string file = memoryFile();
    std::vector<float> cells = cellsOf(grid, values, column, row);
    Bytes bytes;
    if (wrote(file, cells)) {
        vsi_l_offset size = 0;
        const GByte* data = VSIGetMemFileBuffer(file.c_str(), &size, FALSE);
        if (data != nullptr) bytes.assign(reinterpret_cast<const char*>(data), std::size_t(size));
    }
    VSIUnlink(file.c_str());
    return bytes;
}

bool decodeTile(std::string_view tiff, const Grid& grid, int column, int row, std::vector<float>& values) {
    const GdalCalls calls;
    const std::string file = memoryFile();
    Bytes copy(tiff);
    VSIFCloseL(VSIFileFromMemBuffer(file.c_str(), reinterpret_cast<GByte*>(copy.data()), copy.size(), FALSE));
    std::vector<float> cells(std::size_t(tileCells) * tileCells, tileNoData);
    bool read = false;
    if (const auto dataset = openMapInMemory(file); dataset && isTile(**dataset))
        read = (*dataset)->GetRasterBand(1)->RasterIO(GF_Read, 0, 0, tileCells, tileCells, cells.data(),
                                                      tileCells, tileCells, GDT_Float32, 0, 0,
                                                      nullptr) == CE_None;
    VSIUnlink(file.c_str());
    for (int line = 0; read && line < tileCells; ++line)
        for (int x = 0; x < tileCells; ++x) {
            const int c = column * tileCells + x, r = rowOf(grid, row, line);
            const float value = cells[indexInTile(line, x)];
            if (c < grid.columns && r >= 0 && value != tileNoData) values[grid.index(c, r)] = value;
        }
    return read;
}

}  // namespace noonmark
