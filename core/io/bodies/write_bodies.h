#pragma once

// The folder core/io/bodies hands buildings to other programs as bodies in space. This file makes them, in a
// plane of metres, and writes them as DXF; app/report/bodies writes them as OBJ, glTF, COLLADA, PLY and STL.

#include <filesystem>
#include <functional>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/city/city.h"
#include "core/io/shadows/write_shadows.h"

namespace noonmark {

/// A building as triangles, counter-clockwise seen from outside.
struct Body {
    std::string name;  ///< unique in its set
    bool isProposed = false;
    std::vector<glm::dvec3> vertices;  ///< east and north in the plane, elevation above the datum, metres
    std::vector<glm::uvec3> triangles;
};

struct BodySet {
    std::vector<Body> bodies;
    std::string plane;  ///< in words: where (0, 0) lies and what heights count from
};

/// The buildings in the city's order; their parts may touch or overlap. Error: there is no UTM zone here.
/// O(triangles).
Result<BodySet> collectBodies(const City& city, DrawingPlane plane,
                              const std::function<bool(const Building&)>& isProposed);

/// Creates a DXF (R12, ASCII, metres) with a 3DFACE for each triangle, on the layers `buildings` and
/// `buildings_proposed`, and the plane as a comment at its head. Error: the file cannot be written. Backend:
/// write_bodies_dxflib.cpp.
Result<void> writeBodiesDxf(const std::filesystem::path& file, const BodySet& set);

}  // namespace noonmark
