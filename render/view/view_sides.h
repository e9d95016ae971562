#pragma once

#include <Qt3DCore/QEntity>
#include <array>
#include <vector>

namespace Qt3DRender {
class QLayer;
}

namespace noonmark {

/// How the view shows two cities with one camera: the displayed one, and another that it is compared with.
enum class SideLayout {
    one,     ///< the displayed city alone
    swipe,   ///< one picture, of the other city to the left of a divider
    beside,  ///< two pictures of half the width, the other city's on the left
};

struct ViewSides {
    SideLayout layout = SideLayout::one;
    double divider = 0.5;  ///< with swipe: its place as a share of the width, 0 to 1
    bool operator==(const ViewSides&) const = default;
};

/// A side's columns in a view `widthPx` wide: from `first` up to `last`.
struct SideColumns {
    int first = 0;
    int last = 0;
};
/// `side` 0: the displayed city; 1: the other.
SideColumns columnsOf(const ViewSides& sides, int side, int widthPx);

class ShaderMaterial;

/// The line between two sides of the view.
class SideDivider {
public:
    /// `parent` owns the nodes. `sides`: the layers of what only one side shows.
    SideDivider(Qt3DRender::QLayer* blended, const std::array<Qt3DRender::QLayer*, 2>& sides,
                Qt3DCore::QEntity* parent);

    /// `widthPx` of the view, in device-independent pixels.
    void show(const ViewSides& sides, int widthPx);

private:
    void add(float x, float halfWidth, Qt3DRender::QLayer* side);

    Qt3DRender::QLayer* blended_;
    std::array<Qt3DRender::QLayer*, 2> sideLayers_;
    Qt3DCore::QEntity* parent_;
    ShaderMaterial* material_;
    std::vector<Qt3DCore::QEntity*> bands_;
};

}  // namespace noonmark
