#pragma once

#include <stop_token>
#include <string>
#include <vector>

#include "core/city/mesh.h"
#include "core/io/read_part.h"

namespace noonmark {

/// One object of a mesh file, in local metres.
struct NamedMesh {
    std::string name;
    TriangleMesh mesh;
};

/// Adds the buildings of mesh objects to a piece. An object is one building, or several where its pieces
/// stand apart: pieces belong together when they share points or stand over one another (a shared wall line
/// is not enough), so a whole city in one object becomes buildings. Flat pieces at an object's lowest level
/// that are not all of it are ground, and left out. False when stopped.
bool addBuildings(const std::vector<NamedMesh>& objects, const std::string& file, FilePiece& piece,
                  Progress& progress, const std::stop_token& stop);

}  // namespace noonmark
