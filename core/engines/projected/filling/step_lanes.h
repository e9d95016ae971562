#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>

#include "core/engines/projected/casters/ring_lines.h"

namespace noonmark {

/// Number of consecutive steps of the sun whose shadows are filled together, each in a lane of a register
/// (step_registers-inl.h); these steps differ so little that their shadows cross the same rows.
inline constexpr std::size_t stepsTogether = 8;
/// The same word of the rasters of these steps; rasters are filled and counted as arrays of such words.
struct alignas(64) StepWords {
    std::uint64_t words[stepsTogether];
};

/// One number per step.
struct alignas(64) StepDoubles {
    double values[stepsTogether];
    double& operator[](std::size_t step) { return values[step]; }
    double operator[](std::size_t step) const { return values[step]; }
};

/// One point per step.
struct StepPoints {
    StepDoubles x, y;
};

/// The offset, in cells, of the shadow of a point one metre up.
struct StepOffsets {
    StepPoints at{};
    glm::dvec2 low{}, high{};  ///< bounds over all steps
};

/// The line column = atRow0 + row x slope at each step.
struct StepLine {
    StepDoubles atRow0, slope;
};

/// Lines that bound a shape on both sides: a row's span begins after all western lines and ends at the first
/// eastern one. A line that does not bound the shape at some step lies far away there.
struct StepLines {
    std::array<StepLine, 3> western, eastern;
    std::size_t westerns = 0, easterns = 0;
};

/// Edges of a convex ring that bound a shape on one side, in upward order, shifted by `at`. Each edge applies
/// only within its own rows.
struct EdgeChain {
    static constexpr std::size_t maxEdges = 62;
    std::array<const RingEdge*, maxEdges> edges;
    std::size_t count = 0;
    StepPoints at;
    double minUp = 0, maxUp = 0;  ///< bounds of at.y, wider than rounding

    // The caller must set `at`.
    void begin(double lowY, double highY) {
        count = 0;
        minUp = lowY - 1e-6;
        maxUp = highY + 1e-6;
    }
    void add(const RingEdge& edge) { edges[count++] = &edge; }
};

/// A convex shape at each of eight steps, in cells: lines that bound all its rows, and chains of edges at its
/// far end and at its near end.
struct StepShape {
    StepLines sides;
    std::array<EdgeChain, 2> western, eastern;
    StepDoubles low, high;           ///< range of its rows; low > high: no shape at this step
    glm::dvec2 lowest{}, highest{};  ///< bounds over all steps, or larger
};

}  // namespace noonmark
