#pragma once

#include <cstdint>
#include <vector>

#include "core/geo/grid.h"

namespace noonmark {

/// A picture that lies on the ground: one pixel a cell of `grid`, row 0 the southernmost.
struct GroundPicture {
    /// Red, green, blue, alpha, each 0 to 255; colours multiplied by alpha. Transparent: the ground's own
    /// colour shows.
    struct Pixel {
        std::uint8_t r = 0, g = 0, b = 0, a = 0;
        bool operator==(const Pixel&) const = default;
    };
    Grid grid;
    std::vector<Pixel> pixels;  ///< grid order

    /// Most pixels along a side that every graphics card takes.
    static constexpr int mostPixels = 8192;
};

/// The picture, or where a side is longer than `most`, one with k x k pixels averaged into one.
GroundPicture fitted(GroundPicture picture, int most = GroundPicture::mostPixels);

}  // namespace noonmark
