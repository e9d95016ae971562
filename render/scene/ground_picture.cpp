#include "render/scene/ground_picture.h"

#include <algorithm>
#include <array>

namespace noonmark {

namespace {

using Pixel = GroundPicture::Pixel;

Pixel mean(const GroundPicture& picture, int column, int row, int k) {
    std::array<unsigned, 4> sums{};
    unsigned count = 0;
    for (int y = row * k; y < std::min((row + 1) * k, picture.grid.rows); ++y)
        for (int x = column * k; x < std::min((column + 1) * k, picture.grid.columns); ++x, ++count) {
            const Pixel pixel = picture.pixels[picture.grid.index(x, y)];
            sums[0] += pixel.r;
            sums[1] += pixel.g;
            sums[2] += pixel.b;
            sums[3] += pixel.a;
        }
    const auto share = [count](unsigned sum) { return std::uint8_t((sum + count / 2) / count); };
    return {share(sums[0]), share(sums[1]), share(sums[2]), share(sums[3])};
}

int ceilDivided(int a, int b) { return (a + b - 1) / b; }

}  // namespace

GroundPicture fitPicture(GroundPicture picture, int maximum) {
    const int k = ceilDivided(std::max(picture.grid.columns, picture.grid.rows), maximum);
    if (k <= 1) return picture;
    GroundPicture small;
    small.grid = picture.grid;
    small.grid.cellM *= k;
    small.grid.columns = ceilDivided(picture.grid.columns, k);
    small.grid.rows = ceilDivided(picture.grid.rows, k);
    small.pixels.reserve(small.grid.size());
    for (int row = 0; row < small.grid.rows; ++row)
        for (int column = 0; column < small.grid.columns; ++column)
            small.pixels.push_back(mean(picture, column, row, k));
    return small;
}

}  // namespace noonmark
