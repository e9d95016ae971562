#pragma once

#include <cstddef>
#include <stop_token>
#include <string>
#include <vector>

#include "core/io/meshes/mesh_buildings.h"

namespace noonmark {

/// The geometry of one building of a mesh file.
struct MeshUnit {
    TriangleMesh mesh;
    std::size_t object = 0;  ///< index of the object that it is named after
};

/// Objects that are surfaces of one building by their names (surface_names.h), or by their parent's where
/// theirs is only a surface's ("building 12" over "WallSurface" and "RoofSurface"), made one object: where
/// what they cover together is one piece. The others stay as they are.
std::vector<NamedMesh> joinSurfaces(const std::vector<NamedMesh>& objects);

/// Objects cut into buildings. In one object pieces belong together when they share points or stand over one
/// another (a shared wall line is not enough). Walls without roofs belong to the roofs that they stand under,
/// of their own object or else of another:
/// - Roofs tell buildings apart: roofs that meet in an edge are one building's, unless a wall ends there (the
///   party wall between neighbours). Walls join nothing.
/// - Each face of a wall goes to the roof over it, or within 0.25 m of it in plan; of several to the one
///   whose points are nearest to the face's top.
/// - Walls that do not reach the ground but step up from the edge of another roof belong with that roof, and
///   so does what they carry. Likewise what starts in the air and has lower buildings around half of its
///   outline. (A canopy has them on one side.)
/// - A level sheet between the foot and the top of one building that covers nine tenths of it is its floor.
/// Walls under no roof belong to the only building of their object, else they are buildings of their own.
/// Level sheets at the ground (isGround) are left out. In the order of their objects. What is stopped is cut
/// short. Warnings name `file`.
std::vector<MeshUnit> detectUnits(const std::vector<NamedMesh>& objects, const std::string& file,
                                  Warnings& warnings, const std::stop_token& stop);

/// A level sheet is ground up to so much above z = 0, metres; and at the lowest level of its file, where two
/// or more meshes begin on it (one is enough up to openAirM above z = 0).
inline constexpr float groundSheetM = 0.1F;

}  // namespace noonmark
