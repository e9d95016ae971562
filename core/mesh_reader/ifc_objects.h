#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/meshes/mesh_scene.h"

namespace noonmark {

/// Whether a file is an IFC, by its beginning.
bool isIfc(const std::string& file);

/// What a node of an IFC lies in: names of nodes, empty for none.
struct IfcLocation {
    std::string building;  ///< of an IfcBuilding
    std::string storey;    ///< of an IfcBuildingStorey
    std::string element;   ///< the innermost with a class; shapes that are shared are nodes below it
    double buildingM = 0, storeyM = 0;  ///< elevations of their origins

    void enter(const std::string& node, double elevationM);
};

/// Gathers the objects of an IFC by building. The mesh library names each "IfcWall_name_id". What lies in an
/// IfcBuilding is one object with that building's name. Everything outside the buildings (the site, its trees
/// and furniture) is left out and counted by class, and so are furniture, plants and the like inside. A file
/// without an IfcBuilding that holds geometry keeps its other objects as they are. Windows and doors are
/// objects of their own besides, with the number of their storey.
class IfcObjects {
public:
    /// The class in a node's name: "IfcBuilding"; empty for other names.
    static std::string_view classOf(std::string_view name);
    /// Furniture, plants, vehicles and what is no body at all.
    static bool isLeftOut(std::string_view className);

    void add(MeshObject object, const IfcLocation& within);

    /// All objects: the buildings, or what lies outside if there is none, then windows and doors, then one
    /// for what was left out.
    std::vector<MeshObject> take();

private:
    struct Opening {
        MeshObject object;
        std::string building;
        double storeyM = 0;  // above the building's origin
    };
    void addOpening(const MeshObject& object, const IfcLocation& within);
    void addOpeningsTo(std::vector<MeshObject>& objects);

    std::map<std::string, MeshObject> buildings_;
    std::vector<MeshObject> outside_;
    std::map<std::string, Opening> openings_;                  // by the name of their node
    std::map<std::string, std::vector<double>> storeys_;       // of each building
    std::map<std::string, std::size_t, std::less<>> leftOut_;  // objects by class
    std::string lastLeftOut_;
};

/// The text of an IFC4 file as the mesh library reads it, which knows IFC 2x3 only; empty for a file of that
/// edition, and beyond 20 million faces. Faceted sets of IFC4 become faceted breps, indexed curves become
/// polylines (arcs as two chords), and what IFC4 leaves out though 2x3 asks for it (histories of owners,
/// kinds of composition) is filled in. Reads the file twice, and holds its lists of points.
std::string ifcAs2x3(const std::filesystem::path& file);

}  // namespace noonmark
