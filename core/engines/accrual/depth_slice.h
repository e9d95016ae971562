#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace noonmark {

/// The depth map of one step: 32-bit depths, larger is closer to the sun. Row-major, `stride` floats per row
/// (more than there are columns, so that vectors may extend past the end).
struct DepthSlice {
    static constexpr float empty = -1e30F;  ///< value of texels without a face

    DepthSlice(int columnCount, int rowCount);
    void clear();

    int columns = 0;
    int rows = 0;
    std::uint32_t stride = 0;
    std::vector<float> depth;
};

/// Corners of a face in the coordinates of a map.
struct MapPolygon {
    static constexpr std::size_t most = 5;  ///< four, and one more if it is clipped
    std::array<glm::dvec2, most> place{};   ///< texels, counter-clockwise
    std::array<double, most> depth{};
    std::size_t corners = 0;
};

/// A section of a row, with the depth at its first texel.
struct DepthSpan {
    std::uint32_t at = 0;  ///< index of its first texel in DepthSlice::depth
    std::int32_t count = 0;
    float depth = 0;
};

/// How a face's depth continues along its rows: by `gradient` per texel, clamped to `low` and `high`.
struct RowDepth {
    float gradient = 0, low = 0, high = 0;
};

/// Draws polygons into slices; reuses its buffer. One per thread.
class DepthPen {
public:
    /// Raises the slice where the polygon is closer to the sun. Texels are chosen by the half-open rule of
    /// convex_spans.h. Returns the number of rows drawn.
    int draw(const MapPolygon& polygon, DepthSlice& slice);

private:
    std::vector<DepthSpan> spans_;
};

}  // namespace noonmark
