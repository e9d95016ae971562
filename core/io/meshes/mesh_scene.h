#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace noonmark {

/// Polygons that share points, in the file's own axes and unit.
struct MeshPiece {
    std::vector<glm::vec3> points;            ///< may contain values that are not finite
    std::vector<std::uint32_t> cornerCounts;  ///< per polygon, at least three
    /// Corners of all polygons, one after the other; in broken files indices may exceed `points`
    std::vector<std::uint32_t> corners;
    /// What all points are counted from, so that those in map coordinates keep their precision as float32.
    glm::dvec3 origin{0};
    /// The file stores its points rounded to about this, in its own unit; 0 where they are exact to a
    /// millimetre in a thousand kilometres.
    double rounding = 0;
    bool operator==(const MeshPiece&) const = default;
};

/// Adds a point, of which the file's own numbers are given. The first one decides the piece's origin: near it
/// if it lies farther than 10,000 units from zero, where float32 rounds to a thousandth.
void addPoint(MeshPiece& piece, glm::dvec3 point);

/// One object of a mesh file; the transformations in the file's tree of objects are applied to its pieces.
struct MeshObject {
    std::string name;
    std::vector<MeshPiece> pieces;
    std::string parent = {};  ///< name of the object that contains it; empty for the file itself
    /// What the reader left out, such as "3DSOLID (2)"; such an object has nothing else. Empty: none.
    std::string note = {};
    enum class Kind : char {
        pieces,    ///< geometry decides what a building is
        building,  ///< all of a building, which is not to be split
        window,    ///< of an IFC; its pieces are those of a building, too, which another object holds
        door,      ///< as a window
        outlines,  ///< of a drawing without masses: closed lines, whose height must be stated
    };
    Kind kind = Kind::pieces;
    std::optional<std::int32_t> floor = {};  ///< of a window or door: 0 is at the building's own zero
    [[nodiscard]] bool isOpening() const { return kind == Kind::window || kind == Kind::door; }
    bool operator==(const MeshObject&) const = default;
};

/// Advice of the errors of a file that is sound and holds no building; of several files it is left out.
inline constexpr const char* trianglesAdvice = "Export the buildings as triangle or polygon meshes";

/// The content of a mesh file, as the reader process returns it.
using MeshScene = std::vector<MeshObject>;

/// Serialisation of a scene by the reader process: a header, then objects, then an end mark or an error.
/// Numbers are in this machine's byte order. The functions append to `bytes`.
void appendSceneHead(std::string& bytes);
void appendObject(std::string& bytes, const MeshObject& object);
void appendSceneEnd(std::string& bytes);
void appendError(std::string& bytes, const Error& error);

/// Parses the output of the reader process: a scene, or the Error that it reports. Every count is checked
/// against the number of bytes present, so that a wrong count from a broken process allocates nothing. If the
/// bytes end early or are not a scene, `complete` becomes false and an Error is returned. O(bytes).
Result<MeshScene> parseScene(std::string_view bytes, bool& complete);

}  // namespace noonmark
