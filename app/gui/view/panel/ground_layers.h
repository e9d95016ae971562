#pragma once

#include "core/city/city.h"
#include "core/receivers/receivers.h"
#include "render/scene/array_entity.h"
#include "render/scene/city_arrays.h"
#include "render/view/camera_pose.h"

namespace noonmark {

/// The outline of a region as lines slightly above the ground.
std::vector<GroundLine> makeGroundLines(const Region& region, const City& city);

/// The outlines of buildings of the drawn city that `city`, which differs from it by `changes`, has no more.
/// A changed building, which keeps its id, is none of them.
std::vector<GroundLine> makeDemolishedLines(const CityArrays& drawn, const ArrayDifference& changes,
                                            const City& city);

/// A point within a polygon where its name can stand: the centre of its area, or, where that lies outside, a
/// point on the line through it.
glm::dvec2 findMarkPoint(const Footprint& polygon);

/// A line through points on the ground; open while being drawn.
GroundLine makeGroundLine(const std::vector<glm::vec3>& points, const City& city, bool closed);

/// The part of the ground plane that a camera sees, cut to the bounding box of the city; no polygon if it
/// sees none of it.
Region visibleGround(const CameraPose& pose, const ViewLens& lens, const ViewBounds& bounds);

}  // namespace noonmark
