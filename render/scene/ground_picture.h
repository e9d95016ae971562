#pragma once

#include <cstdint>
#include <vector>

#include "core/geo/grid.h"

namespace noonmark {

/// A picture on the ground: one pixel per cell of `grid`, row 0 the southernmost.
struct GroundPicture {
    /// Red, green, blue, alpha, each 0 to 255, colours premultiplied by alpha. Where transparent, the
    /// ground's own colour shows.
    struct Pixel {
        std::uint8_t r = 0, g = 0, b = 0, a = 0;
        bool operator==(const Pixel&) const = default;
    };
    Grid grid;
    std::vector<Pixel> pixels;  ///< grid order

    /// Texture size per side that every graphics card supports.
    static constexpr int maxPixels = 8192;
};

/// The picture itself, or one in which k x k pixels are averaged where a side is longer than `maximum`.
GroundPicture fitPicture(GroundPicture picture, int maximum = GroundPicture::maxPixels);

}  // namespace noonmark
