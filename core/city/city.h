#pragma once

// The folder core/city is the model of a city: City holds Buildings, Buildings hold Parts, and a
// part is a prism over a footprint or a mesh. Footprints are polygons in plan (footprints/), meshes are
// triangles (meshes/), the ground is in terrain/. build_footprints.h decides which raised parts are
// overhangs, building_heights.h counts the sources of heights, map_context.h holds streets, parks and water,
// which are drawn (water is no ground either), and city_position.h places the observer who sees the sun.
// Readers of files are in core/io.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "core/city/footprints/footprint.h"
#include "core/city/meshes/mesh.h"
#include "core/city/terrain/terrain.h"
#include "core/geo/frame.h"

namespace noonmark {

/// Origin of a part's height; stored with the part, counted by `info`, shown in reports.
enum class HeightSource {
    measured,  ///< a height field in the data, in a stated unit
    levels,    ///< number of storeys x metres a storey
    assumed,   ///< nothing in the data; the stated default
    mesh,      ///< the geometry is three-dimensional
    designed,  ///< stated by the user: a massing, a variant, a changed height
    madeUp,    ///< of a sample city: drawn at random, of no real place
};
/// All values, in the order in which they are counted: heightSources[i] == HeightSource(i).
inline constexpr std::array heightSources{HeightSource::measured, HeightSource::levels,
                                          HeightSource::assumed,  HeightSource::mesh,
                                          HeightSource::designed, HeightSource::madeUp};
/// "measured", "levels", "assumed", "mesh", "designed", "made up": the names used in files and tables.
std::string_view nameOf(HeightSource source);
/// The source of that name; nothing for any other text.
std::optional<HeightSource> parseHeightSource(std::string_view name);

/// One solid: a footprint between two elevations (a prism), or a general closed mesh with the footprint as
/// its outline.
struct Part {
    std::string sourceId;  ///< the feature it was read from: "way 34633854"
    Footprint footprint;
    float bottomM = 0;  ///< local z of its underside
    float topM = 0;     ///< local z of its highest point; > bottomM
    HeightSource heightSource = HeightSource::assumed;
    /// True for an overhang: a part with open air below it. It is not heightfield-like, and the ground under
    /// it is a receiver.
    bool isOverhanging = false;
    /// Null for a prism. Otherwise the geometry of the part; footprint, bottomM and topM bound it.
    std::shared_ptr<const TriangleMesh> mesh;

    bool operator==(const Part&) const = default;
};

/// What a user sees as one building. Its parts may touch or overlap.
struct Building {
    std::string sourceId;  ///< of the outline, or of the only part
    std::string name;      ///< may be empty
    std::string status;    ///< free text of the source: "built", "to be built"; may be empty
    std::vector<Part> parts;

    bool operator==(const Building&) const = default;
};

Box2 bounds(const Building& building);
float topM(const Building& building);

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
