#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>

namespace noonmark {

/// Consecutive steps of the sun whose shadows are filled together, each in a lane of a vector: they differ so
/// little that they cross the same rows.
inline constexpr std::size_t stepsTogether = 8;
/// The same word of the rasters of these steps; rasters are filled and counted as arrays of such words.
struct alignas(64) StepWords {
    std::uint64_t words[stepsTogether];
};

/// The same, as a vector.
using StepBits = std::uint64_t __attribute__((vector_size(64), may_alias));

/// Whether any bit is set.
[[gnu::always_inline]] inline bool anySet(const StepBits& bits) {
    using Four = std::uint64_t __attribute__((vector_size(32)));
    using Two = std::uint64_t __attribute__((vector_size(16)));
    const Four four =
        __builtin_shufflevector(bits, bits, 0, 1, 2, 3) | __builtin_shufflevector(bits, bits, 4, 5, 6, 7);
    const Two two = __builtin_shufflevector(four, four, 0, 1) | __builtin_shufflevector(four, four, 2, 3);
    return (two[0] | two[1]) != 0;
}

using StepDoubles = double __attribute__((vector_size(64), may_alias));

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
template <std::size_t most>
struct StepLines {
    std::array<StepLine, most> western, eastern;
    std::size_t westerns = 0, easterns = 0;
};

/// A convex shape at each of eight steps, in cells: some lines bound all its rows, the others matter only in
/// rows [endLow, endHigh].
struct StepShape {
    static constexpr std::size_t mostEnds = 64;
    StepLines<4> sides;
    StepLines<mostEnds> ends;
    double endLow = 0, endHigh = 0;
    StepDoubles low{}, high{};       ///< bounds of its rows; where low > high there is no shape
    glm::dvec2 lowest{}, highest{};  ///< bounds of all steps, or more
};

}  // namespace noonmark
