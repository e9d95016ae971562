#pragma once

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

}  // namespace noonmark
