#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <vector>

#include "core/city/terrain/post_grid.h"
#include "core/geo/crs.h"
#include "core/geo/frame.h"

namespace noonmark {

/// The georeference of a raster in its own coordinate reference system. Pixel coordinates count from the
/// corner of the first pixel, row 0 is the raster's own first row; pixel centres lie at halves.
struct RasterPlace {
    int columns = 0;
    int rows = 0;
    std::array<double, 6> geoTransform{};  ///< as GDAL has it
    [[nodiscard]] glm::dvec2 at(glm::dvec2 pixel) const;
};

/// Transforms pixel coordinates of a raster to local metres. Holds references to its three arguments, which
/// must outlive it.
class PixelPlaces {
public:
    PixelPlaces(const RasterPlace& raster, const CrsToLonLat& crs, const Frame& frame)
        : raster_(raster), crs_(crs), frame_(frame) {}
    /// NaN for a pixel that cannot be transformed, or lies more than 1,000 km from the origin. Some 2 us
    /// each.
    [[nodiscard]] std::vector<glm::dvec2> local(const std::vector<glm::dvec2>& pixels) const;

private:
    const RasterPlace& raster_;
    const CrsToLonLat& crs_;
    const Frame& frame_;
};

/// A window of a raster.
struct PixelExtent {
    int column = 0, row = 0;  ///< the first pixel
    int columns = 0, rows = 0;
    [[nodiscard]] std::size_t size() const { return std::size_t(columns) * std::size_t(rows); }
    bool operator==(const PixelExtent&) const = default;
};

/// The pixels within `farAwayM` of the origin to each side, and few others. Nothing: there are none.
std::optional<PixelExtent> extentNear(const RasterPlace& raster, const PixelPlaces& places, double farAwayM);

/// The centres of a window's pixels as posts.
struct PlacedPosts {
    PostGrid posts;
    bool flipped = false;  ///< the posts' row 0 is the window's last
    /// The largest distance of a post from its true position, checked on 2,600 of them
    double misplacedM = 0;
};

/// Places the posts by steps alone if that is accurate to 1 mm, otherwise with a bend of the third degree.
/// The window must have at least two columns and two rows.
PlacedPosts placePosts(const PixelPlaces& places, const PixelExtent& window);

}  // namespace noonmark
