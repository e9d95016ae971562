#include "render/view/view_sides.h"

#include <algorithm>
#include <cmath>

namespace noonmark {

SideColumns columnsOf(const ViewSides& sides, int side, int widthPx) {
    if (sides.layout == SideLayout::one) return side == 0 ? SideColumns{0, widthPx} : SideColumns{};
    const double share = sides.layout == SideLayout::beside ? 0.5 : std::clamp(sides.divider, 0.0, 1.0);
    const int divider = int(std::lround(share * widthPx));
    return side == 0 ? SideColumns{divider, widthPx} : SideColumns{0, divider};
}

}  // namespace noonmark
