#pragma once

#include <optional>
#include <string>

#include "core/io/meshes/mesh_scene.h"
#include "core/io/settings/read_settings.h"

namespace noonmark {

/// An axis that a mesh probably has upwards, and why: "it is 517 x 600 and only 90 in z".
struct UpAxisGuess {
    UpAxis axis = UpAxis::y;
    std::string why;
};

/// From the shape of a mesh whose format does not state it. In this order: a city is flat,
/// less than half as high as it is wide either way, and 100 m or more wide; a tower is higher than one
/// and a half times its width; buildings have most of their points at their feet; a flat bottom is at 0; the
/// lower one; y, which is usual. O(points).
/// `metresPerUnit`: of the mesh's coordinates.
UpAxisGuess guessUpAxis(const MeshScene& scene, double metresPerUnit = 1);

/// Of a mesh in map coordinates: the axis along which its numbers are small, as heights are, and no
/// coordinates of a map. Nothing where y and z are alike. O(points).
std::optional<UpAxisGuess> guessUpAxisOnMap(const MeshScene& scene, double metresPerUnit = 1);

}  // namespace noonmark
