#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <optional>
#include <span>

namespace noonmark {

/// How a square map of `mapSize` texels a side is laid over points of a plane: the matrix that MapFrame calls
/// texelFromPlane. Every point lies on the map.

/// Stretched over their box.
glm::dmat3 fitBox(std::span<const glm::dvec2> points, int mapSize);

/// Stretched over a trapezoid around them whose narrow side is turned to `eye` (Martin and Tan, Anti-aliasing
/// and continuity with trapezoidal shadow maps, 2004): the axis runs from the eye to the middle of the
/// points, and the nearest 80 % of them get 80 % of the map's length (their 80 % rule, with the focus where
/// that many points are). None where that would not help: points no denser near the eye, or the eye over
/// their middle.
std::optional<glm::dmat3> fitTrapezoid(std::span<const glm::dvec2> points, glm::dvec2 eye, int mapSize);

}  // namespace noonmark
