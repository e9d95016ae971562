#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>

#include "core/engines/projected/casters/ring_lines.h"

namespace noonmark {

/// Consecutive steps of the sun whose shadows are filled together, each in a lane of a register
/// (step_registers.h): they differ so little that they cross the same rows.
inline constexpr std::size_t stepsTogether = 8;
/// The same word of the rasters of these steps; rasters are filled and counted as arrays of such words.
struct alignas(64) StepWords {
    std::uint64_t words[stepsTogether];
};

/// A number at each of these steps.
struct alignas(64) StepDoubles {
    double values[stepsTogether];
    double& operator[](std::size_t step) { return values[step]; }
    double operator[](std::size_t step) const { return values[step]; }
};

/// A point at each of these steps.
struct StepPoints {
    StepDoubles x, y;
};

/// How far, and where to, the shadow of a point one metre up lies, in cells.
struct StepOffsets {
    StepPoints at{};
    glm::dvec2 low{}, high{};  ///< bounds of them all
};

/// The line column = atRow0 + row x slope at each step.
struct StepLine {
    StepDoubles atRow0, slope;
};

/// Bounds of a shape on both sides: a row enters where it has crossed all western lines, and leaves at the
/// first eastern one. A line that does not bound at some step lies far off there.
struct StepLines {
    std::array<StepLine, 3> western, eastern;
    std::size_t westerns = 0, easterns = 0;
};

/// Edges of a convex ring that bound a shape on one side, upwards, moved to `at`. Each matters in its own
/// rows only.
struct EdgeChain {
    static constexpr std::size_t mostEdges = 62;
    std::array<const RingEdge*, mostEdges> edges;
    std::size_t count = 0;
    StepPoints at;
    double leastUp = 0, mostUp = 0;  ///< bounds of at.y, wide of rounding

    // `at` is the caller's to set.
    void begin(double lowY, double highY) {
        count = 0;
        leastUp = lowY - 1e-6;
        mostUp = highY + 1e-6;
    }
    void add(const RingEdge& edge) { edges[count++] = &edge; }
};

/// A convex shape at each of eight steps, in cells: lines that bound all its rows, and chains of edges at its
/// far end and at its near one.
struct StepShape {
    StepLines sides;
    std::array<EdgeChain, 2> western, eastern;
    StepDoubles low, high;           ///< bounds of its rows; where low > high there is no shape
    glm::dvec2 lowest{}, highest{};  ///< bounds of all steps, or more
};

}  // namespace noonmark
