#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace noonmark {

/// The depth map of one step: 32-bit depths, larger is nearer to the sun. Row-major, `stride` floats a row
/// (some more than there are columns, so that vectors may run over the end).
struct DepthSlice {
    static constexpr float empty = -1e30F;  ///< where nothing is before the sky

    DepthSlice(int columnCount, int rowCount);
    void clear();

    int columns = 0;
    int rows = 0;
    std::uint32_t stride = 0;
    std::vector<float> depth;
};

/// Corners of a face as a map sees it.
struct MapPolygon {
    static constexpr std::size_t most = 5;  ///< four, and one more where it is cut
    std::array<glm::dvec2, most> place{};   ///< texels, counter-clockwise
    std::array<double, most> depth{};
    std::size_t corners = 0;
};

/// A stretch of a row, with the depth at its first texel.
struct DepthSpan {
    std::uint32_t at = 0;  ///< of its first texel, in DepthSlice::depth
    std::int32_t count = 0;
    float depth = 0;
};

/// Draws polygons into slices; keeps its buffer from one to the next. One a thread.
class DepthPen {
public:
    /// Raises the slice where the polygon is nearer to the sun. Texels by the half-open rule of
    /// convex_spans.h. Says how many rows were drawn.
    int draw(const MapPolygon& polygon, DepthSlice& slice);

private:
    std::vector<DepthSpan> spans_;
};

}  // namespace noonmark
