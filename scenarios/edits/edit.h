#pragma once

// The folder scenarios/edits/ changes cities. This file defines the edits, placed_building.h the geometry of
// moving, turning and scaling a building; read_shape.h reads a building from a mesh file; apply_edits.h gives
// buildings unique ids and applies a list of edits to a City.

#include <memory>
#include <string>
#include <variant>

#include "core/city/city.h"
#include "core/city/trees/tree.h"
#include "scenarios/edits/placed_building.h"

namespace noonmark {

/// One change to a city, as a plain value. An edit names a building by its `sourceId`, which is unique in a
/// project (apply_edits.h). New buildings give z relative to the ground under them (0: on the ground);
/// applying the edit puts them onto the terrain. Buildings compare by pointer: a copied edit is equal, an
/// edit with a newly built equal shape is not.
using NewShape = std::shared_ptr<const Building>;  ///< never null, at least one part

struct TowerDesign;  // scenarios/massing/tower_design.h
/// The massing from which a new building was made; null: it was not designed in Noonmark. It says how the
/// shape came about and changes nothing in the city.
using DesignOfShape = std::shared_ptr<const TowerDesign>;

struct Demolish {
    std::string building;
    bool operator==(const Demolish&) const = default;
};

/// The new building takes the old one's place in the list. Its id must be free or that of the old building.
struct Replace {
    std::string building;
    NewShape with;
    DesignOfShape design{};
    bool operator==(const Replace&) const = default;
};

struct AddBuilding {
    NewShape building;
    DesignOfShape design{};
    bool operator==(const AddBuilding&) const = default;
};

struct ChangeHeight {
    std::string building;
    double heightM = 0;  ///< above the building's ground, 0.1 to 2000; see withHeight()
    bool operator==(const ChangeHeight&) const = default;
};

struct Move {
    std::string building;
    glm::dvec2 byM{0, 0};  ///< east, north; on terrain the building follows the ground up and down
    bool operator==(const Move&) const = default;
};

struct Rotate {
    std::string building;
    double clockwiseDeg = 0;  ///< about the centroid of its outlines, findMiddle()
    bool operator==(const Rotate&) const = default;
};

/// A building read from a mesh file, placed and scaled by the user.
struct ImportMesh {
    NewShape shape;  ///< as read_shape.h reads it
    Placement placement;
    std::string file;          ///< source file, for display only
    double storeyHeightM = 0;  ///< 2 to 10, of its storeys from the ground up; 0: not known
    /// How the user had the file read, for its next edition (read_shape.h).
    std::string reading;   ///< formatText() of axes, unit, stand, reference system and level of detail
    double readScale = 1;  ///< ReadSettings::meshScale, 0.001 to 1000
    bool operator==(const ImportMesh&) const = default;
};

// Edits of trees name one by its `sourceId`, which is unique in a project, too. A tree stands on the ground:
// its `groundM` is found when the edit is applied.

struct PlantTree {
    Tree tree;  ///< its id must be free
    bool operator==(const PlantTree&) const = default;
};

struct FellTree {
    std::string tree;
    bool operator==(const FellTree&) const = default;
};

/// The new tree stands where the old one stood, under its id.
struct ReplaceTree {
    std::string tree;
    Tree with;
    bool operator==(const ReplaceTree&) const = default;
};

struct MoveTree {
    std::string tree;
    glm::dvec2 byM{0, 0};  ///< east, north
    bool operator==(const MoveTree&) const = default;
};

/// The tree after some years. Holds the measures that growTree() found, so that a scenario stays as it is
/// when what is assumed of growth changes.
struct GrowTree {
    std::string tree;
    double years = 0;
    double heightM = 0, crownBaseM = 0, crownDiameterM = 0;
    bool operator==(const GrowTree&) const = default;
};

using Edit = std::variant<Demolish, Replace, AddBuilding, ChangeHeight, Move, Rotate, ImportMesh, PlantTree,
                          FellTree, ReplaceTree, MoveTree, GrowTree>;

/// "Demolish One57", "Move lot 17 by 3.0 m east, 0.0 m north": for edit lists and undo menus.
std::string formatText(const Edit& edit);

/// The keyword in the project file and on the command line: "demolish", "replace", "add", "height", "move",
/// "rotate", "import", "plant", "fell", "replace-tree", "move-tree", "grow".
std::string_view getKind(const Edit& edit);

}  // namespace noonmark
