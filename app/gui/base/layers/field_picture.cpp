#include "app/gui/base/layers/field_picture.h"

#include <algorithm>
#include <cmath>

namespace noonmark {

namespace {

using Pixel = GroundPicture::Pixel;
constexpr int shades = 1024;

/// The values of a picture's cells: receivers of one kind, and next to them their mean.
struct ShownCells {
    const std::vector<float>& values;
    const Grid& grid;
    const Receivers* receivers;  ///< null: not known
    CellKind kind;

    [[nodiscard]] float at(int column, int row) const {
        const std::size_t cell = grid.index(column, row);
        if (!receivers || receivers->kind[cell] == kind) return values[cell];
        const CellKind is = receivers->kind[cell];
        const bool wanted = kind == CellKind::roof || (is != CellKind::outside && is != CellKind::water);
        return wanted ? meanAround(column, row) : std::nanf("");
    }

private:
    // Mean over the eight neighbours of the wanted kind; NaN if there are none.
    [[nodiscard]] float meanAround(int column, int row) const {
        float sum = 0;
        int count = 0;
        for (int y = std::max(0, row - 1); y <= std::min(grid.rows - 1, row + 1); ++y)
            for (int x = std::max(0, column - 1); x <= std::min(grid.columns - 1, column + 1); ++x) {
                const std::size_t cell = grid.index(x, y);
                if (receivers->kind[cell] != kind || std::isnan(values[cell])) continue;
                sum += values[cell];
                ++count;
            }
        return count > 0 ? sum / float(count) : std::nanf("");
    }
};

Pixel toPixel(const Rgb& colour) { return {colour.red, colour.green, colour.blue, 255}; }

GroundPicture makePicture(const ShownCells& cells, const ColourScale& scale) {
    const Grid& grid = cells.grid;
    GroundPicture picture;
    picture.grid = grid;
    picture.pixels.resize(grid.size());
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column) {
            const auto colour = scale.pick(double(cells.at(column, row)));
            if (colour) picture.pixels[grid.index(column, row)] = toPixel(*colour);
        }
    return picture;
}

}  // namespace

Pixel pixelOf(const QColor& colour) {
    return {std::uint8_t(colour.red()), std::uint8_t(colour.green()), std::uint8_t(colour.blue()), 255};
}

std::vector<Pixel> paletteOf(const ColourScale& scale, double topMin) {
    std::vector<Pixel> palette;
    palette.reserve(shades);
    for (int i = 0; i < shades; ++i)
        palette.push_back(toPixel(scale.colourOf(scale.quantity.of(topMin * i / (shades - 1)))));
    if (scale.leavesZeroFree()) palette.front() = {};
    return palette;
}

GroundPicture fieldPicture(const ShadowField& field, const Receivers* receivers, ShadowMeasure measure,
                           const ColourScale& scale) {
    return makePicture({getValues(field, measure), field.grid, receivers, CellKind::ground}, scale);
}

std::optional<GroundPicture> roofPicture(const ShadowField& field, const Receivers& receivers,
                                         ShadowMeasure measure, const ColourScale& scale) {
    if (std::ranges::find(receivers.kind, CellKind::roof) == receivers.kind.end()) return std::nullopt;
    return makePicture({getValues(field, measure), field.grid, &receivers, CellKind::roof}, scale);
}

}  // namespace noonmark
