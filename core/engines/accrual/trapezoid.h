#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <optional>
#include <span>

namespace noonmark {

/// Ways to lay a square map of `mapSize` texels per side over points of a plane. They return the matrix
/// MapFrame::texelFromPlane. Every point lies on the map.

/// Stretches the map over the points' bounding box.
glm::dmat3 fitBox(std::span<const glm::dvec2> points, int mapSize);

/// Stretches the map over a trapezoid around the points whose narrow side faces `eye` (Martin and Tan,
/// Anti-aliasing and continuity with trapezoidal shadow maps, 2004): the axis runs from the eye to the centre
/// of the points, and the closest 80 % of them get 80 % of the map's length (their 80 % rule, with the focus
/// where that many points are). Empty if the warp would not help: points no denser near the eye, or the eye
/// above their centre.
std::optional<glm::dmat3> fitTrapezoid(std::span<const glm::dvec2> points, glm::dvec2 eye, int mapSize);

}  // namespace noonmark
