#include "core/city/trees/tree.h"

#include <fmt/format.h>

#include <utility>

#include "core/describe/choice.h"

namespace noonmark {

namespace {

constexpr std::array crownShapeNames{Choice{CrownShape::ellipsoid, "ellipsoid"},
                                     Choice{CrownShape::cone, "cone"},
                                     Choice{CrownShape::cylinder, "cylinder"}};
constexpr std::array treeSourceNames{
    Choice{TreeSource::measured, "measured"}, Choice{TreeSource::estimated, "estimated"},
    Choice{TreeSource::assumed, "assumed"}, Choice{TreeSource::designed, "designed"}};

}  // namespace

std::string_view nameOf(CrownShape shape) { return keyOf<CrownShape>(crownShapeNames, shape); }
std::optional<CrownShape> parseCrownShape(std::string_view name) {
    return findChoice<CrownShape>(crownShapeNames, name);
}

std::string_view nameOf(TreeSource source) { return keyOf<TreeSource>(treeSourceNames, source); }
std::optional<TreeSource> parseTreeSource(std::string_view name) {
    return findChoice<TreeSource>(treeSourceNames, name);
}

Warning makeTreeWarning(std::string where, std::string_view why) {
    return {WarningKind::leftOut, fmt::format("trees: {}", why), std::move(where)};
}

Warnings warnOfTrees(const std::shared_ptr<const Trees>& trees, std::string_view why) {
    if (!trees || trees->trees.empty()) return {};
    const std::size_t count = trees->trees.size();
    return {makeTreeWarning(fmt::format("{} tree{}", count, count == 1 ? "" : "s"), why)};
}

}  // namespace noonmark
