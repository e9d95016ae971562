#include "core/city/footprints/box_index.h"

#include <geos_c.h>

#include <algorithm>
#include <tuple>

#include "core/city/footprints/geos_shapes.h"

namespace noonmark {

namespace {

Geos::Geometry makeRectangle(const Geos& geos, const Box2& box) {
    return geos.owned(GEOSGeom_createRectangle_r(geos, double(box.low.x), double(box.low.y),
                                                 double(box.high.x), double(box.high.y)));
}

}  // namespace

// GEOS's tree keeps the addresses of rectangles and of positions, so both stay where they are.
struct BoxIndex::Tree {
    Geos geos;
    GEOSSTRtree* tree = GEOSSTRtree_create_r(geos, 10);
    std::vector<Geos::Geometry> rectangles;
    std::vector<std::size_t> positions;

    explicit Tree(const std::vector<Box2>& boxes) {
        positions.reserve(boxes.size());
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            if (boxes[i].empty()) continue;
            positions.push_back(i);
            rectangles.push_back(makeRectangle(geos, boxes[i]));
            GEOSSTRtree_insert_r(geos, tree, rectangles.back().get(), &positions.back());
        }
    }
    Tree(const Tree&) = delete;
    Tree& operator=(const Tree&) = delete;
    ~Tree() { GEOSSTRtree_destroy_r(geos, tree); }
};

BoxIndex::BoxIndex(const std::vector<Box2>& boxes) : tree_(std::make_unique<Tree>(boxes)) {
    std::ignore = findMeeting({{0, 0}, {0, 0}});  // GEOS builds the tree at the first query
}

BoxIndex::~BoxIndex() = default;
BoxIndex::BoxIndex(BoxIndex&&) noexcept = default;
BoxIndex& BoxIndex::operator=(BoxIndex&&) noexcept = default;

std::vector<std::size_t> BoxIndex::findMeeting(const Box2& box) const {
    std::vector<std::size_t> found;
    if (box.empty()) return found;
    const auto keep = [](void* item, void* list) {
        static_cast<std::vector<std::size_t>*>(list)->push_back(*static_cast<std::size_t*>(item));
    };
    GEOSSTRtree_query_r(tree_->geos, tree_->tree, makeRectangle(tree_->geos, box).get(), keep, &found);
    std::ranges::sort(found);
    return found;
}

}  // namespace noonmark
