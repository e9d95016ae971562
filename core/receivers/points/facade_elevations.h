#pragma once

#include <span>
#include <vector>

#include "core/city/city.h"
#include "core/receivers/points/glazing_pane.h"

namespace noonmark {

/// A window to draw, in local metres.
struct ElevationPane {
    glm::dvec3 middle{}, normal{};  ///< `normal`: unit vector, outward
    PaneSize size;                  ///< around `middle`; known
};

/// A place of an elevation is (along, z): metres to the right as seen from outside, and local z.
struct ElevationFace {
    double depthM = 0;  ///< towards the viewer, the larger the nearer
    std::vector<std::vector<glm::dvec2>> polygons;
};
struct ElevationGlazing {
    std::size_t pane = 0;  ///< index in the list of panes
    glm::dvec2 low{}, high{};
};

/// One side of a building, seen square to it, without perspective.
struct FacadeElevation {
    glm::dvec2 normal{};  ///< level, outward, unit vector: towards the viewer
    /// Windows that other walls of the same side would cover (courts, set-backs behind wings) have further
    /// layers, with their own walls only. From 1.
    int layer = 1, layers = 1;
    std::vector<ElevationFace> faces;  ///< from back to front
    std::vector<ElevationGlazing> windows;
    glm::dvec2 low{}, high{};  ///< the box around faces and windows
    double floorM = 0;         ///< z of the lowest wall of the building, from which storeys are counted
};

/// What panes are seen by the elevations: all but those that lean more than 45 degrees.
inline bool hasElevation(const ElevationPane& pane) { return std::abs(pane.normal.z) <= 0.7071; }

/// The sides of a building that have windows, by azimuth in the local frame. Walls and windows within 15
/// degrees of a side's most frequent direction are drawn with it. Null building: windows without walls.
/// Every pane for which hasElevation() is in exactly one elevation. O(panes x walls).
std::vector<FacadeElevation> drawElevations(const Building* building, std::span<const ElevationPane> panes);

}  // namespace noonmark
