#include "app/report/maps/field_image.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace noonmark {

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

class Picture {
public:
    Picture(const ShadowField& field, const Receivers& receivers, ShadowMeasure measure,
            const ColourScale& scale)
        : grid_(field.grid), receivers_(receivers), values_(getValues(field, measure)), scale_(scale) {}

    [[nodiscard]] QImage reduced(int factor) const {
        const auto pixels = [factor](int cells) { return (cells + factor - 1) / factor; };
        QImage image(pixels(grid_.columns), pixels(grid_.rows), QImage::Format_RGB32);
        if (image.isNull()) return image;
        for (int y = 0; y < image.height(); ++y) paintLine(image, y, factor);
        return image;
    }

private:
    void paintLine(QImage& image, int y, int factor) const {
        auto* line = reinterpret_cast<QRgb*>(image.scanLine(y));
        const int row = grid_.rows - (y + 1) * factor;  // may be negative where the last block is cut
        for (int x = 0; x < image.width(); ++x) line[x] = colourOf(valueAt(x, row, factor));
    }

    [[nodiscard]] double valueAt(int x, int row, int factor) const {
        if (factor > 1) return meanOf(x * factor, row, factor);
        const float value = values_[grid_.index(x, row)];
        return std::isnan(value) && isBuilding(x, row) ? meanOf(x - 1, row - 1, 3) : double(value);
    }

    [[nodiscard]] QRgb colourOf(double value) const {
        const auto colour = scale_.pick(value);
        return colour ? qRgb(colour->red, colour->green, colour->blue) : qRgb(255, 255, 255);
    }

    /// Mean over the receivers in the square of `side` cells with this south-western cell.
    [[nodiscard]] double meanOf(int column, int row, int side) const {
        double sum = 0;
        int count = 0;
        for (int r = std::max(row, 0); r < std::min(row + side, grid_.rows); ++r)
            for (int c = std::max(column, 0); c < std::min(column + side, grid_.columns); ++c) {
                const float value = values_[grid_.index(c, r)];
                if (std::isnan(value)) continue;
                sum += double(value);
                ++count;
            }
        return count > 0 ? sum / count : nothing;
    }

    [[nodiscard]] bool isBuilding(int column, int row) const {
        const std::size_t cell = grid_.index(column, row);
        return cell < receivers_.kind.size() && receivers_.kind[cell] == CellKind::building;
    }

    const Grid& grid_;
    const Receivers& receivers_;
    const std::vector<float>& values_;
    const ColourScale& scale_;
};

int factorFor(const Grid& grid, int wantedPixels) {
    return std::max(1, std::max(grid.columns, grid.rows) / std::max(1, wantedPixels));
}

int pixelsOf(int cells, int factor) { return (cells + factor - 1) / factor; }

QRgb meanColour(const Grid& grid, const CellColour& colour, int column, int row, int side) {
    int red = 0, green = 0, blue = 0, count = 0;
    for (int r = std::max(row, 0); r < row + side; ++r)
        for (int c = column; c < std::min(column + side, grid.columns); ++c, ++count) {
            const QColor one = colour(grid.index(c, r)).value_or(Qt::white);
            red += one.red();
            green += one.green();
            blue += one.blue();
        }
    return count > 0 ? qRgb(red / count, green / count, blue / count) : qRgb(255, 255, 255);
}

}  // namespace

FieldImage makeColourImage(const Grid& grid, const CellColour& colour, int wantedPixels) {
    const int factor = factorFor(grid, wantedPixels);
    QImage image(pixelsOf(grid.columns, factor), pixelsOf(grid.rows, factor), QImage::Format_RGB32);
    for (int y = 0; y < image.height(); ++y) {
        auto* line = reinterpret_cast<QRgb*>(image.scanLine(y));
        const int row = grid.rows - (y + 1) * factor;  // may be negative where the last block is cut
        for (int x = 0; x < image.width(); ++x) line[x] = meanColour(grid, colour, x * factor, row, factor);
    }
    return {image, factor};
}

FieldImage makeFieldImage(const ShadowField& field, const Receivers& receivers, ShadowMeasure measure,
                          const ColourScale& scale, int wantedPixels) {
    const int factor = factorFor(field.grid, wantedPixels);
    return {Picture(field, receivers, measure, scale).reduced(factor), factor};
}

}  // namespace noonmark
