#pragma once

// A DXF file is text: pairs of lines, a group code and its value (Autodesk, "DXF Reference"). This file reads
// them as entities and makes polygons from each entity; read_scene.h joins blocks and layers.

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <istream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace noonmark {

/// One entity, or one mark such as SECTION: group 0 and the groups up to the next 0.
struct DxfEntity {
    std::string type;  ///< "3DFACE"
    std::vector<std::pair<int, std::string>> groups;

    [[nodiscard]] std::string text(int code) const;                     ///< the first one; empty: absent
    [[nodiscard]] double number(int code, double otherwise = 0) const;  ///< `otherwise` also where not finite
    [[nodiscard]] int whole(int code, int otherwise = 0) const;
    /// Groups `first`, first + 10 and first + 20: x, y, z. Absent coordinates are 0.
    [[nodiscard]] glm::dvec3 point(int first) const;
    [[nodiscard]] bool has(int code) const;
};

/// A finite number; nothing for any other text.
std::optional<double> parseDxfNumber(const std::string& text);

/// Reads a DXF entity by entity. Broken pairs end the file.
class DxfReader {
public:
    explicit DxfReader(std::istream& stream);
    std::optional<DxfEntity> next();

private:
    bool readPair();

    std::istream& stream_;
    int code_ = -1;  // of the pair that was read last
    std::string value_;
    bool good_ = false;
};

using DxfPolygon = std::vector<glm::dvec3>;  ///< at least three corners, in the drawing's unit

/// The surfaces of one entity.
struct DxfShape {
    std::vector<DxfPolygon> polygons;
    std::string leftOut;      ///< why there are none: "outlines without a thickness"; empty where there are
    DxfPolygon outline = {};  ///< of a closed outline without a thickness
};

/// The directions of the axes that an entity's points are given in, as columns: z is its extrusion direction
/// (groups 210 to 230), x and y follow by the format's rule.
glm::dmat3 ownAxes(const DxfEntity& entity);

/// A 3DFACE.
DxfShape makeFace(const DxfEntity& face);

/// SOLID and TRACE: extruded by their thickness.
DxfShape makeSolid(const DxfEntity& solid);

/// A closed LWPOLYLINE, extruded by its thickness (group 39); arcs (group 42) as chords of at most 10
/// degrees.
DxfShape makeLightOutline(const DxfEntity& outline);

/// A MESH, without its smoothing.
DxfShape makeSubdivisionMesh(const DxfEntity& mesh);

/// A POLYLINE and its VERTEX entities: a polyface mesh, a polygon mesh, or a closed outline, extruded by its
/// thickness.
DxfShape makePolyline(const DxfEntity& polyline, const std::vector<DxfEntity>& vertices);

}  // namespace noonmark
