#include "app/window/field_picture.h"

#include <cmath>

#include "app/report/palette.h"

namespace noonmark {

namespace {

using Pixel = GroundPicture::Pixel;
constexpr int shades = 1024;

// The mean of the receivers among the eight cells around one; NaN where there is none.
float meanAround(const std::vector<float>& values, const Grid& grid, int column, int row) {
    float sum = 0;
    int count = 0;
    for (int y = std::max(0, row - 1); y <= std::min(grid.rows - 1, row + 1); ++y)
        for (int x = std::max(0, column - 1); x <= std::min(grid.columns - 1, column + 1); ++x) {
            const float value = values[grid.index(x, y)];
            if (std::isnan(value)) continue;
            sum += value;
            ++count;
        }
    return count > 0 ? sum / float(count) : std::nanf("");
}

float shownValue(const std::vector<float>& values, const Grid& grid, const Receivers* receivers, int column,
                 int row) {
    const std::size_t cell = grid.index(column, row);
    if (receivers && receivers->kind[cell] == CellKind::building)
        return meanAround(values, grid, column, row);
    return values[cell];
}

}  // namespace

std::vector<Pixel> shadowPalette() {
    std::vector<Pixel> palette;
    for (int i = 0; i < shades; ++i) {
        const QColor colour = shadowColour(double(i) / (shades - 1));
        palette.push_back(
            {std::uint8_t(colour.red()), std::uint8_t(colour.green()), std::uint8_t(colour.blue()), 255});
    }
    return palette;
}

GroundPicture fieldPicture(const ShadowField& field, const Receivers* receivers, ShadowMeasure measure,
                           double top) {
    const std::vector<Pixel> palette = shadowPalette();
    const std::vector<float>& values = valuesOf(field, measure);
    GroundPicture picture;
    picture.grid = field.grid;
    picture.pixels.resize(field.grid.size());
    for (int row = 0; row < field.grid.rows; ++row)
        for (int column = 0; column < field.grid.columns; ++column) {
            const float value = shownValue(values, field.grid, receivers, column, row);
            if (std::isnan(value)) continue;
            const double share = std::clamp(double(value) / top, 0.0, 1.0);
            picture.pixels[field.grid.index(column, row)] =
                palette[std::size_t(std::lround(share * (shades - 1)))];
        }
    return picture;
}

}  // namespace noonmark
