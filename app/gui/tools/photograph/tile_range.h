#pragma once

#include <QString>
#include <array>

#include "core/base/result.h"
#include "core/city/footprints/footprint.h"
#include "core/geo/frame.h"

namespace noonmark {

/// Tiles of the web's map scheme ("XYZ"): 2^zoom x 2^zoom squares of Web Mercator, x from the west, y from
/// the north.
struct TileRange {
    int zoom = 0;
    int west = 0, north = 0;    ///< the first x and y
    int columns = 0, rows = 0;  ///< 1 or more
    [[nodiscard]] int count() const { return columns * rows; }
    bool operator==(const TileRange&) const = default;
};

/// No more tiles are fetched for one picture.
inline constexpr int maxTiles = 256;
inline constexpr int finestZoom = 19;

/// The tiles over `box` (local metres) at the finest zoom, up to finestZoom, at which there are no more than
/// `most`.
TileRange chooseTiles(const Frame& frame, const Box2& box, int most = maxTiles);

/// The range's georeference in EPSG:3857 for tiles of this many pixels, as GDAL has it.
std::array<double, 6> computeTransform(const TileRange& range, int tilePixels);

/// Error: not http or https, or without {x}, {y} or {z}.
Result<void> checkTemplate(const QString& address);

/// The address of a tile: {x}, {y} and {z} are replaced.
QString addressOf(const QString& address, int zoom, int x, int y);

}  // namespace noonmark
