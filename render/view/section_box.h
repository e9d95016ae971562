#pragma once

#include <optional>

#include "render/view/camera_pose.h"

namespace noonmark {

/// What the view shows of the scene: a box along east, north and up, in local metres. What lies outside is
/// not drawn and cannot be picked; shadows remain those of the whole city.
struct SectionBox {
    glm::dvec3 lowM{0};   ///< west, south, bottom
    glm::dvec3 highM{0};  ///< east, north, top
    bool operator==(const SectionBox&) const = default;
};

/// A side of a section box: axis 0 east, 1 north, 2 up; its high or low side.
struct SectionSide {
    int axis = 0;
    bool high = false;
};
inline constexpr SectionSide sectionSides[] = {{0, false}, {0, true},  {1, false},
                                               {1, true},  {2, false}, {2, true}};

/// No side of a section box is shorter, metres.
inline constexpr double minSectionM = 1;

/// A box that contains all of `bounds`, with a margin.
SectionBox makeSectionAround(const ViewBounds& bounds);

/// `box` with numbers that are finite, within 1e7 m, and sides of minSectionM or more; nothing if a number
/// is not.
std::optional<SectionBox> repairSection(SectionBox box);

double positionOf(const SectionBox& box, SectionSide side);  ///< along the side's axis
glm::dvec3 centreOf(const SectionBox& box, SectionSide side);

/// Moves a side to `toM` along its axis, but not past the opposite side: minSectionM remain.
SectionBox moveSide(SectionBox box, SectionSide side, double toM);

/// The part of a ray inside the box, as distances along it; empty if the ray misses the box.
struct RaySpan {
    double fromM = 0;
    double toM = 0;
};
std::optional<RaySpan> findSpan(const SectionBox& box, const ViewRay& ray);

bool contains(const SectionBox& box, const glm::dvec3& point);

}  // namespace noonmark
