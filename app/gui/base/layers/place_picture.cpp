#include "app/gui/base/layers/place_picture.h"

#include <QImage>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/receivers/place_names.h"

namespace noonmark {

namespace {

constexpr double maxPixels = 2048;  // a side
constexpr double minPixelM = 0.5;

Grid gridOver(const std::vector<Place>& places) {
    Box2 box;
    for (const Place& place : places) box.add(bounds(place));
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
