#include "core/city/trees/tree.h"

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

}  // namespace noonmark
