#include "scenarios/edits/edit.h"

#include <fmt/format.h>

#include <array>

#include "core/base/units.h"

namespace noonmark {

namespace {

struct Words {
    std::string operator()(const Demolish& edit) const { return "Demolish " + edit.building; }
    std::string operator()(const Replace& edit) const {
        return fmt::format("Replace {} with {}", edit.building, edit.with->sourceId);
    }
    std::string operator()(const AddBuilding& edit) const { return "Build " + edit.building->sourceId; }
    std::string operator()(const ChangeHeight& edit) const {
        return fmt::format("Make {} {:.1f} m high", edit.building, edit.heightM);
    }
    std::string operator()(const Move& edit) const {
        return fmt::format("Move {} by {} m east, {} m north", edit.building, formatNumber(edit.byM.x, 1),
                           formatNumber(edit.byM.y, 1));
    }
    std::string operator()(const Rotate& edit) const {
        return fmt::format("Turn {} by {} degrees", edit.building, formatNumber(edit.clockwiseDeg, 1));
    }
    std::string operator()(const ImportMesh& edit) const {
        return fmt::format("Import {} from {}", edit.shape->sourceId, edit.file);
    }
    std::string operator()(const PlantTree& edit) const {
        return fmt::format("Plant {}, {:.1f} m high", edit.tree.sourceId, edit.tree.heightM);
    }
    std::string operator()(const FellTree& edit) const { return "Fell " + edit.tree; }
    std::string operator()(const ReplaceTree& edit) const {
        return fmt::format("Replace {} with a tree {:.1f} m high", edit.tree, edit.with.heightM);
    }
    std::string operator()(const MoveTree& edit) const {
        return fmt::format("Move {} by {} m east, {} m north", edit.tree, formatNumber(edit.byM.x, 1),
                           formatNumber(edit.byM.y, 1));
    }
    std::string operator()(const GrowTree& edit) const {
        return fmt::format("Grow {} by {:g} years to {:.1f} m", edit.tree, edit.years, edit.heightM);
    }
};

}  // namespace

std::string formatText(const Edit& edit) { return std::visit(Words{}, edit); }

std::string_view getKind(const Edit& edit) {
    constexpr std::array<std::string_view, std::variant_size_v<Edit>> kinds{
        "demolish", "replace", "add",  "height",       "move",      "rotate",
        "import",   "plant",   "fell", "replace-tree", "move-tree", "grow"};
    return kinds[edit.index()];
}

}  // namespace noonmark
