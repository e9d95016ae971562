#include "core/accumulate/horizon/sheared_tile.h"

#include <algorithm>
#include <cmath>

namespace noonmark {

namespace {
constexpr std::size_t floatsALine = 16;
}

ShearedTile::ShearedTile(const TileBox& box, glm::dvec2 away)
    : corner_(box.firstColumn, box.firstRow), swapped_(std::abs(away.x) > std::abs(away.y)) {
    const double along = swapped_ ? away.x : away.y, across = swapped_ ? away.y : away.x;
    alongs_ = swapped_ ? box.columns : box.rows;
    acrosses_ = swapped_ ? box.rows : box.columns;
    flipped_ = along < 0;
    mirrored_ = swapped_ != flipped_;
    alongPerDistance_ = std::abs(along);
    k_ = across / std::abs(along);
    shear();
    findEnds();
}

void ShearedTile::shear() {
    const double most = std::ceil(std::abs(k_) * (alongs_ - 1));
    offset_ = k_ > 0 ? most : 0;
    lines_ = acrosses_ + int(most) + 1;
    shifts_.resize(std::size_t(alongs_));
    fractions_.assign((std::size_t(alongs_) + floatsALine - 1) / floatsALine, {});
    for (int along = 0; along < alongs_; ++along) {
        const double shift = offset_ - k_ * along, whole = std::floor(shift);
        shifts_[std::size_t(along)] = int(whole);
        fractions_[std::size_t(along) / floatsALine].values[along % int(floatsALine)] = float(shift - whole);
    }
}

// Of the lines -width to the last: reached[line + width] is the first `along` whose shift is at most the line
// (where shifts fall) or above it (where they rise). A line enters the tile at the one and leaves it at the
// other, `width` lines away.
std::vector<int> ShearedTile::firstReaching() const {
    std::vector<int> reached(std::size_t(lines_ + acrosses_));
    int along = k_ > 0 ? alongs_ : 0;
    for (int line = -acrosses_; line < lines_; ++line) {
        if (k_ > 0)
            while (along > 0 && shifts_[std::size_t(along - 1)] <= line) --along;
        else
            while (along < alongs_ && shifts_[std::size_t(along)] <= line) ++along;
        reached[std::size_t(line + acrosses_)] = along;
    }
    return reached;
}

void ShearedTile::findEnds() {
    const std::vector<int> reached = firstReaching();
    firsts_.assign(reached.begin() + acrosses_, reached.end());
    ends_.assign(reached.begin(), reached.begin() + lines_);
    if (k_ <= 0) firsts_.swap(ends_);
}

}  // namespace noonmark
