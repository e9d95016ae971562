#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace noonmark {

/// Polygons that share points, in the file's own axes and unit.
struct MeshPiece {
    std::vector<glm::vec3> points;            ///< may hold numbers that are not finite
    std::vector<std::uint32_t> cornerCounts;  ///< per polygon, three at least
    std::vector<std::uint32_t> corners;  ///< of all polygons in turn; may exceed `points` in broken files
    bool operator==(const MeshPiece&) const = default;
};

/// One object of a mesh file: its pieces stand where its place in the file's tree of objects puts them.
struct MeshObject {
    std::string name;
    std::vector<MeshPiece> pieces;
    std::string parent = {};  ///< name of the object that holds it; empty for the file itself
    bool operator==(const MeshObject&) const = default;
};

/// A mesh file as its reader process hands it over.
using MeshScene = std::vector<MeshObject>;

/// The form in which the reader process hands a scene over: a head, then objects, then an end or an error.
/// The numbers are in this machine's byte order. The functions append to `bytes`.
void appendSceneHead(std::string& bytes);
void appendObject(std::string& bytes, const MeshObject& object);
void appendSceneEnd(std::string& bytes);
void appendError(std::string& bytes, const Error& error);

/// What the reader process wrote: a scene, or the Error that it reports. Every count is held against the
/// bytes that are there, so that nothing is reserved for what a broken process merely claims.
/// `complete` becomes false, with an Error, where the bytes end early or are no scene. O(bytes).
Result<MeshScene> parseScene(std::string_view bytes, bool& complete);

}  // namespace noonmark
