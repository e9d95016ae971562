#pragma once

#include <map>
#include <string>
#include <string_view>

#include "core/io/meshes/mesh_scene.h"

namespace noonmark {

/// Whether a file is an IFC, by its beginning.
bool isIfc(const std::string& file);

/// Gathers the objects of an IFC by building. The mesh library names each "IfcWall_name_id". What lies in an
/// IfcBuilding is one object with that building's name. Everything outside the buildings (the site, its trees
/// and furniture) is left out and counted by class, and so are furniture, plants and the like inside. A file
/// without an IfcBuilding that holds geometry keeps its other objects as they are.
class IfcObjects {
public:
    /// The class in a node's name: "IfcBuilding"; empty for other names.
    static std::string_view classOf(std::string_view name);
    /// Furniture, plants, vehicles and what is no body at all.
    static bool isLeftOut(std::string_view className);

    /// `building`: the name of the node of its IfcBuilding; empty outside.
    void add(MeshObject object, const std::string& building);

    /// All objects: the buildings, or what lies outside if there is none, then one for what was left out.
    std::vector<MeshObject> take();

private:
    std::map<std::string, MeshObject> buildings_;
    std::vector<MeshObject> outside_;
    std::map<std::string, std::size_t, std::less<>> leftOut_;
};

}  // namespace noonmark
