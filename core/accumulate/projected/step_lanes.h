#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>

#include "core/accumulate/projected/ring_lines.h"

namespace noonmark {

/// Consecutive steps of the sun whose shadows are filled together, each in a lane of a vector: they differ so
/// little that they cross the same rows.
inline constexpr std::size_t stepsTogether = 8;
/// The same word of the rasters of these steps; rasters are filled and counted as arrays of such words.
struct alignas(64) StepWords {
    std::uint64_t words[stepsTogether];
};

/// The same, as a vector. Aligned by word of mouth: left alone the alignment differs between instruction
/// sets, and with it where a structure has its parts.
using StepBits = std::uint64_t __attribute__((vector_size(64), may_alias, aligned(64)));

/// Whether any bit is set.
[[gnu::always_inline]] inline bool anySet(const StepBits& bits) {
    using Four = std::uint64_t __attribute__((vector_size(32)));
    using Two = std::uint64_t __attribute__((vector_size(16)));
    const Four four =
        __builtin_shufflevector(bits, bits, 0, 1, 2, 3) | __builtin_shufflevector(bits, bits, 4, 5, 6, 7);
    const Two two = __builtin_shufflevector(four, four, 0, 1) | __builtin_shufflevector(four, four, 2, 3);
    return (two[0] | two[1]) != 0;
}

using StepDoubles = double __attribute__((vector_size(64), may_alias, aligned(64)));

/// A point at each of these steps.
struct StepPoints {
    StepDoubles x{}, y{};
    [[nodiscard]] StepPoints scaled(double by) const { return {x * by, y * by}; }
};

inline StepPoints operator+(glm::dvec2 point, const StepPoints& by) {
    return {point.x + by.x, point.y + by.y};
}
inline StepPoints operator-(const StepPoints& a, const StepPoints& b) { return {a.x - b.x, a.y - b.y}; }

/// How far, and where to, the shadow of a point one metre up lies, in cells.
struct StepThrows {
    StepPoints at;
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

    void begin(const StepPoints& moved, double lowY, double highY) {
        count = 0;
        at = moved;
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
    StepDoubles low{}, high{};       ///< bounds of its rows; where low > high there is no shape
    glm::dvec2 lowest{}, highest{};  ///< bounds of all steps, or more
};

}  // namespace noonmark
