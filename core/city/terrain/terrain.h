#pragma once

// The folder core/city/terrain is the ground of a city. Terrain (this file) holds elevations on a grid of
// posts (post_grid.h) and their origin (terrain_source.h). It is made of rasters in core/io/terrain, of
// triangles by tin_terrain.h, or of points by delaunay.h; fill_gaps.h fills missing posts. building_ground.h
// and ground_contact.h tell where buildings touch the ground.

#include <glm/vec2.hpp>
#include <vector>

#include "core/city/meshes/mesh.h"
#include "core/city/terrain/post_grid.h"
#include "core/city/terrain/terrain_source.h"

namespace noonmark {

/// The ground as elevations of posts. Between posts it is the surface of meshOf's triangles, so that the
/// ground under buildings and the ground that casts shadows agree; beyond the outer posts the nearest value
/// holds.
struct Terrain {
    PostGrid grid;
    std::vector<float> elevationM;  ///< local z of each post; all finite
    TerrainSource source = {};

    bool operator==(const Terrain&) const = default;
};

/// Local z of the ground at a point, metres. Some 15 ns; 0.1 us where the posts' grid is bent.
float elevationAt(const Terrain& terrain, glm::dvec2 point);

/// Two triangles for each cell between posts, facing up: 2 (columns - 1)(rows - 1) triangles. A cell's
/// diagonal runs from its first corner to the one in the next column and row.
TriangleMesh meshOf(const Terrain& terrain);

}  // namespace noonmark
