#pragma once

// The folder core/city is the model of a city: City holds Buildings, Buildings hold Parts (building.h), and a
// part is a prism over a footprint or a mesh. Footprints are polygons in plan (footprints/), meshes are
// triangles (meshes/), the ground is in terrain/. build_footprints.h decides which raised parts are
// overhangs, building_heights.h counts the sources of heights, map_context.h holds streets, parks and water,
// which are drawn (water is no ground either), and city_position.h places the observer who sees the sun.
// Readers of files are in core/io.

#include <cstdint>
#include <memory>
#include <stop_token>
#include <vector>

#include "core/city/building.h"
#include "core/city/terrain/terrain.h"
#include "core/geo/frame.h"

namespace noonmark {

struct MapContext;  // map_context.h
struct Trees;       // trees/tree.h

/// An immutable city: cheap to copy; copies share what an edit did not change. A building is identified by
/// its index.
struct City {
    Frame frame;
    std::vector<std::shared_ptr<const Building>> buildings;  ///< none null
    std::shared_ptr<const Terrain> terrain;                  ///< null: the ground is flat at z = 0
    std::shared_ptr<const MapContext> context;               ///< on the ground; null: none is known
    std::shared_ptr<const Trees> trees;                      ///< null: none is known, or none is counted
};

/// Every part of every building as triangles, each with the index of its building.
struct CityMesh {
    TriangleMesh mesh;
    std::vector<std::uint32_t> buildingOfTriangle;  ///< one per triangle
};

/// O(points log points), on all cores; about 0.3 s for 40,000 buildings on two cores. Does not contain the
/// terrain. After a stop request it returns soon, with an incomplete mesh: check the token.
CityMesh meshOf(const City& city, const std::stop_token& stop = {});

/// A closed mesh of a part: its own mesh, or its footprint extruded, with triangulated caps.
TriangleMesh meshOf(const Part& part);

Box2 bounds(const City& city);

/// Local z of the ground: the terrain's, or 0.
float groundAt(const City& city, glm::dvec2 point);

}  // namespace noonmark
