#include "app/gui/base/layers/field_picture.h"

#include <QImage>
#include <QObject>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "app/gui/base/layers/hover_text.h"
#include "app/gui/base/widgets/number_text.h"
#include "core/receivers/place_names.h"

namespace noonmark {

namespace {

double minutesOf(const MeasuredElement& element, ShadowMeasure measure) {
    return measure == ShadowMeasure::gross ? element.grossMin : element.continuousMin;
}

}  // namespace

std::vector<ElementTiles::Tile> makeTiles(const ElementMap& map, ShadowMeasure measure,
                                          const ColourScale& scale) {
    std::vector<ElementTiles::Tile> tiles;
    tiles.reserve(map.elements.size());
    for (const MeasuredElement& element : map.elements) {
        const Rgb shade = scale.colourOf(scale.shownOf(minutesOf(element, measure)));
        tiles.push_back({cornersOf(element), glm::vec3(shade.red, shade.green, shade.blue) / 255.0F});
    }
    return tiles;
}

QString describe(const MeasuredElement& element) {
    QString text =
        QObject::tr("%1 h of sun a day, at most %2 h without a break")
            .arg(groupDigits(element.sunlitMin / 60, 1), groupDigits(element.longestSunMin / 60, 1));
    if (element.floor) text = QObject::tr("floor %1, %2").arg(*element.floor).arg(text);
    return text + QStringLiteral(", ") +
           formatMinutes(float(element.grossMin), float(element.continuousMin), false);
}

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
    if (scale.leavesZeroUncoloured()) palette.front() = {};
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

namespace {

constexpr double maxPixels = 2048;  // a side
constexpr double minPixelM = 0.5;

Grid gridOver(const std::vector<Place>& places) {
    const Box2 box = bounds(places);
    if (box.empty()) return {};
    const glm::dvec2 size = glm::dvec2(box.high) - glm::dvec2(box.low);
    const double cellM = std::max(minPixelM, std::max(size.x, size.y) / maxPixels);
    return {box.low.x, box.low.y, cellM, int(std::ceil(size.x / cellM)), int(std::ceil(size.y / cellM))};
}

void addRing(QPainterPath& path, const Ring& ring, const Grid& grid) {
    QPolygonF corners;
    for (const glm::vec2& corner : ring)
        corners << QPointF((corner.x - grid.westM) / grid.cellM, (corner.y - grid.southM) / grid.cellM);
    path.addPolygon(corners);
    path.closeSubpath();
}

QPainterPath pathOf(const Footprint& polygon, const Grid& grid) {
    QPainterPath path;
    addRing(path, polygon.outer, grid);
    for (const Ring& hole : polygon.holes) addRing(path, hole, grid);
    return path;
}

// Large places first.
std::vector<std::size_t> orderBySize(const std::vector<Place>& places) {
    std::vector<double> areas;
    for (const Place& place : places) areas.push_back(area(place));
    std::vector<std::size_t> order(places.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return areas[a] > areas[b]; });
    return order;
}

// Row 0 of the image is the southernmost, as in the grid. Number 0 is transparent black.
QImage paintNumbers(const std::vector<Place>& places, const Grid& grid) {
    QImage image(grid.columns, grid.rows, QImage::Format_ARGB32);
    image.fill(0);
    QPainter painter(&image);
    painter.setPen(Qt::NoPen);
    for (const std::size_t place : orderBySize(places)) {
        painter.setBrush(QColor::fromRgb(QRgb(0xff000000U | QRgb(place + 1))));
        for (const Footprint& polygon : places[place].polygons) painter.drawPath(pathOf(polygon, grid));
    }
    return image;
}

}  // namespace

PlacePicture::PlacePicture(const std::vector<Place>& places) : grid_(gridOver(places)) {
    if (grid_.size() == 0) return;
    const QImage image = paintNumbers(places, grid_);
    numbers_.reserve(grid_.size());
    for (int row = 0; row < grid_.rows; ++row) {
        const auto* line = reinterpret_cast<const QRgb*>(image.constScanLine(row));
        for (int column = 0; column < grid_.columns; ++column) numbers_.push_back(line[column] & 0xffffffU);
    }
}

std::optional<std::size_t> PlacePicture::placeAt(glm::dvec2 point) const {
    const int column = int(std::floor((point.x - grid_.westM) / grid_.cellM));
    const int row = int(std::floor((point.y - grid_.southM) / grid_.cellM));
    if (column < 0 || row < 0 || column >= grid_.columns || row >= grid_.rows) return std::nullopt;
    const std::uint32_t number = numbers_[grid_.index(column, row)];
    return number == 0 ? std::nullopt : std::optional<std::size_t>(number - 1);
}

GroundPicture PlacePicture::coloured(std::span<const GroundPicture::Pixel> colours) const {
    GroundPicture picture{grid_, std::vector<GroundPicture::Pixel>(numbers_.size())};
    for (std::size_t i = 0; i < numbers_.size(); ++i)
        if (numbers_[i] != 0) picture.pixels[i] = colours[numbers_[i] - 1];
    return picture;
}

}  // namespace noonmark
