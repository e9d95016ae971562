#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "core/base/result.h"
#include "core/city/meshes/surface_mesher.h"
#include "core/io/cityjson/cityjson_model.h"
#include "core/io/files/xml_stream.h"

namespace noonmark {

/// Fills `numbers` with those of a list that is separated by blanks or, as in GML 2, by commas. False if
/// there is something else, or a number that is not finite.
bool readGmlNumbers(std::string_view text, std::vector<double>& numbers);

/// A matrix written row by row; the identity if it has not 16 numbers.
glm::dmat4 readGmlMatrix(std::string_view text);

/// The polygons between `first` and `end` of a GmlGeometryReader, some of them only referred to.
struct GmlRange {
    std::size_t first = 0, end = 0;
};

using GmlShell = std::vector<GmlRange>;
using GmlBody = std::vector<GmlShell>;  ///< the outer shell, then cavities

/// What one property of an object holds.
struct GmlGeometry {
    bool solid = false;
    std::vector<GmlBody> bodies;  ///< of surfaces: one with one shell, or none
};

/// What could not be used of the references of a geometry.
struct GmlReferences {
    std::size_t missing = 0;  ///< to ids that the object does not have
    std::size_t foreign = 0;  ///< to other files, which are not opened
    std::size_t steps = 0;    ///< taken so far for the object; limited
};

/// Polygons with points of their own.
struct GmlTemplate {
    std::vector<glm::dvec3> points;
    std::vector<Surface> surfaces;
};
using GmlShared = std::unordered_map<std::string, GmlTemplate>;  ///< by their id

/// Collects the geometries of one object of CityGML with all that it contains, in the coordinates of the
/// file. GML 2, 3.1 and 3.2: polygons, triangles, surfaces, solids, their aggregates, references among them,
/// and CityGML's implicit geometries, which are moved to their place.
class GmlGeometryReader {
public:
    static constexpr std::size_t maxPoints = 40'000'000;  ///< of one object

    /// A property with a geometry begins; begin() and end() take the elements below it.
    void open(const XmlElement& property);
    Result<void> begin(const XmlElement& element);
    Result<void> end(std::string_view name, std::string_view text);
    /// Whether everything below the property has ended.
    [[nodiscard]] bool isAtProperty() const { return open_.size() == 1; }
    /// The property ends.
    GmlGeometry close();

    [[nodiscard]] bool wantsText() const { return wantsText_; }
    [[nodiscard]] const std::vector<glm::dvec3>& points() const { return points_; }
    /// Points that are offsets in metres from `at`.
    struct Offsets {
        std::size_t first, end;
        glm::dvec3 at;
    };
    [[nodiscard]] const std::vector<Offsets>& offsets() const { return offsets_; }

    /// The polygons of a shell, those referred to included, as indices of points().
    [[nodiscard]] std::vector<Surface> surfacesOf(const GmlShell& shell, GmlReferences& references) const;

    /// The ids that the object refers to and does not have.
    [[nodiscard]] std::vector<std::string> unresolved() const;
    /// Keeps those of the object's polygons that have these ids, for other objects.
    void share(const std::unordered_set<std::string>& ids, GmlShared& shared) const;
    /// Copies what the object refers to and another object has.
    void adopt(const GmlShared& shared);

    /// Forgets the object; templates of implicit geometries stay, as later objects refer to them.
    void clear();

    std::size_t flatOutlines = 0;   ///< positions without a height, which were taken at 0
    std::size_t brokenRings = 0;    ///< left out: fewer than three corners, or no numbers
    std::size_t foreignShapes = 0;  ///< implicit geometries in files of their own

private:
    struct Member {
        std::uint32_t index;  ///< of a polygon or a reference
        bool isReference, flipped;
    };
    struct Open {
        std::string id;
        std::size_t first;  ///< member
        int dimension;
        bool flipped;
    };
    enum class Role { other, ring, polygon, solid, implicit };

    void beginPart(std::string_view name);
    void addReference(std::string_view target, bool ofSolid);
    void addMember(Member member);
    void addCorners(std::string_view text, int dimension);
    void finishRing();
    void finishPolygon();
    void finishImplicit();
    void useTemplate(const std::string& id);
    GmlRange copyPolygons(const GmlTemplate& from);
    void expand(const GmlRange& range, bool flipped, int depth, std::vector<Surface>& surfaces,
                GmlReferences& references) const;

    std::vector<glm::dvec3> points_;
    std::vector<Offsets> offsets_;
    std::vector<Surface> polygons_;
    std::vector<std::string> references_;
    std::vector<Member> members_;
    std::unordered_map<std::string, GmlRange> ids_;
    GmlShared templates_;

    // What is being read.
    std::vector<Open> open_;
    GmlGeometry geometry_;
    GmlShell loose_;
    std::size_t solidDepth_ = 0, polygonDepth_ = 0, ringDepth_ = 0, shellDepth_ = 0, implicitDepth_ = 0;
    std::size_t shellFirst_ = 0;
    Surface surface_;
    std::vector<std::uint32_t> ring_;
    std::vector<double> numbers_;
    bool wantsText_ = false, ringIsBroken_ = false;

    struct Implicit {
        std::size_t firstPoint = 0, firstMember = 0;
        std::string templateId;  ///< that is defined here, or wanted
        bool isReference = false, inReference = false;
        glm::dmat4 matrix{1};
        glm::dvec3 at{0};
    } implicit_;
};

/// Collects the grid of a RasterRelief whose elevations stand in the file itself (RectifiedGridCoverage).
class GmlRasterReader {
public:
    /// An element below RasterRelief ends.
    void end(std::string_view name, std::string_view text);
    /// Why it cannot be used; empty if it can.
    [[nodiscard]] std::string findFault() const;
    /// The grid as a TINRelief, in the coordinates of the file; of one without fault.
    [[nodiscard]] CityJsonBlock makeBlock(const std::string& id) const;

private:
    std::string file_;
    std::vector<double> elevations_;  // NaN where there is none
    glm::dvec2 low_{0};               // indices of the grid's first post: column, row
    std::optional<glm::dvec2> high_, origin_;
    std::vector<glm::dvec2> offsets_;  // from a post to the next one of its row, of its column
    bool isLinear_ = true;
};

/// What an element of CityGML is, by its name without prefix; the same in versions 1.0, 2.0 and 3.0.
enum class GmlObjectKind {
    other,      ///< left out, with its name
    building,   ///< Building, BuildingPart, BuildingInstallation, BuildingConstructiveElement
    terrain,    ///< TINRelief
    plants,     ///< SolitaryVegetationObject, PlantCover
    container,  ///< of objects: ReliefFeature, CityObjectGroup
};
GmlObjectKind findGmlObjectKind(std::string_view name);

/// Whether an element is one around objects: cityObjectMember, featureMembers.
bool isGmlMember(std::string_view name);

/// Whether an element is a surface of a building, or an opening in one, with geometries of its own.
bool isGmlBoundary(std::string_view name);

/// Whether such a surface is a window or a door.
bool isGmlOpening(std::string_view name);

/// Whether a property holds what shades nothing or is no part of the object: rooms, addresses, appearances.
bool isGmlAside(std::string_view name);

/// What the name of a property says of the geometry in it.
struct LodProperty {
    enum class Shape { body, footprint, roofEdge };
    double lod = 0;
    Shape shape = Shape::body;
};

/// "lod2Solid", "lod0FootPrint", "tin". Nothing for properties with curves, points or no geometry.
std::optional<LodProperty> findLodProperty(std::string_view name);

/// An object of CityGML as it is read: a building, a part of one, a terrain, a tree.
struct GmlObject {
    /// What a geometry belongs to.
    enum class Owner { object, surface, opening };
    struct Lod {
        LodProperty property;
        Owner owner;  ///< surface: collected from walls, roofs and openings; opening: from openings alone
        GmlGeometry geometry;
    };
    struct Opening {
        std::string id;  ///< may be empty
        bool isWindow;
        double lod;
        GmlGeometry geometry;
    };
    CityJsonObject object;  ///< without geometry and values
    std::vector<Lod> lods;
    std::vector<ObjectAttribute> attributes;
    std::vector<Opening> openings;

    /// Adds a geometry; those of walls, roofs and openings of the same level of detail become one.
    void add(const LodProperty& property, Owner owner, GmlGeometry geometry);
    /// Adds an attribute; the first of a name stays. "9.3" is a number.
    void add(std::string name, std::string_view text, std::string_view unit);
};

/// Makes a block of the objects that one top-level object contains, the outermost first: chooses their
/// geometries (cityjson_model.h; of a building and its parts only those of the best level of detail), and
/// keeps the points that they use. `areDegrees`: offsets in metres are turned into degrees.
CityJsonBlock makeBlock(std::vector<GmlObject>& objects, const GmlGeometryReader& reader,
                        const LodChoice& choice, bool areDegrees, const std::string& file,
                        Warnings& warnings);

/// The windows and doors of an object, of the highest level of detail that has some.
std::vector<FileOpening> findOpenings(const GmlObject& object, const GmlGeometryReader& reader);

}  // namespace noonmark
