#pragma once

#include <memory>
#include <string>
#include <variant>

#include "core/city/building.h"
#include "scenarios/edits/placed_building.h"

namespace noonmark {

/// One change to a city, as a plain value. A building is named by its `sourceId`, which a project keeps
/// unique (building_ids.h). New buildings state their z from the ground under them (0: on the ground); they
/// are put onto the terrain when the edit is applied. Equality of buildings is that of the shared value: an
/// edit that was copied is equal, one that was made again is not.
using NewShape = std::shared_ptr<const Building>;  ///< never null, at least one part

struct Demolish {
    std::string building;
    bool operator==(const Demolish&) const = default;
};

/// The new building takes the old one's place; its own id must be free, or the old one's.
struct Replace {
    std::string building;
    NewShape with;
    bool operator==(const Replace&) const = default;
};

struct AddBuilding {
    NewShape building;
    bool operator==(const AddBuilding&) const = default;
};

struct ChangeHeight {
    std::string building;
    double heightM = 0;  ///< above its ground, 0.1 to 2000; see withHeight()
    bool operator==(const ChangeHeight&) const = default;
};

struct Move {
    std::string building;
    glm::dvec2 byM{0, 0};  ///< east, north; on terrain it goes up and down with the ground
    bool operator==(const Move&) const = default;
};

struct Rotate {
    std::string building;
    double clockwiseDeg = 0;  ///< about the middle of its outlines' area
    bool operator==(const Rotate&) const = default;
};

/// A building from a mesh file, placed and scaled by the user.
struct ImportMesh {
    NewShape shape;  ///< as it was read, see read_shape.h
    Placement placement;
    std::string file;  ///< where it came from, for people
    bool operator==(const ImportMesh&) const = default;
};

using Edit = std::variant<Demolish, Replace, AddBuilding, ChangeHeight, Move, Rotate, ImportMesh>;

/// "Demolish One57", "Move lot 17 by 3.0 m east, 0.0 m north": for lists and undo.
std::string textOf(const Edit& edit);

/// The word of the file and the command line: "demolish", "replace", "add", "height", "move", "rotate",
/// "import".
std::string_view getKind(const Edit& edit);

}  // namespace noonmark
