#include "app/gui/view/panel/map_layer.h"

#include <QImage>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <cstring>

#include "app/report/maps/city_painter.h"
#include "core/city/city_position.h"
#include "render/view/city_view.h"

namespace noonmark {

namespace {

constexpr float aroundM = 500;  // of map beyond the buildings
constexpr double finestM = 0.25;

static_assert(sizeof(GroundPicture::Pixel) == 4);

GroundPicture pictureOf(const QImage& image, const Grid& grid) {
    GroundPicture picture{grid, std::vector<GroundPicture::Pixel>(grid.size())};
    for (int row = 0; row < grid.rows; ++row)
        std::memcpy(&picture.pixels[std::size_t(row) * std::size_t(grid.columns)], image.constScanLine(row),
                    std::size_t(grid.columns) * sizeof(GroundPicture::Pixel));
    return picture;
}

}  // namespace

GroundPicture paintContextPicture(const MapContext& context, const Box2& around, int maxPixels) {
    const glm::dvec2 size(around.high - around.low);
    const double cell = std::max(finestM, std::max(size.x, size.y) / maxPixels);
    const Grid grid{double(around.low.x), double(around.low.y), cell,
                    std::max(1, int(std::ceil(size.x / cell))), std::max(1, int(std::ceil(size.y / cell)))};
    QImage image(grid.columns, grid.rows, QImage::Format_RGBA8888_Premultiplied);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    // Row 0 is the southernmost, so that the picture is not turned over.
    const QTransform toPixels(1 / cell, 0, 0, 1 / cell, -grid.westM / cell, -grid.southM / cell);
    paintContext(painter, context, toPixels, 1);
    painter.end();
    return pictureOf(image, grid);
}

MapLayer::MapLayer(CityView& view, QObject* parent) : QObject(parent), view_(view) {}

void MapLayer::showCity(const City& city) {
    if (city.context == context_) return;
    context_ = city.context;
    whole_.reset();
    picture_.reset();
    around_ = findMainPart(city).box;
    if (around_.empty()) around_ = bounds(city);
    around_.low -= aroundM;
    around_.high += aroundM;
    show();
}

void MapLayer::setShown(bool shown) {
    shown_ = shown;
    show();
}

std::shared_ptr<const MapContext> MapLayer::wanted() const {
    if (!context_ || shown_) return context_;
    if (!context_->picture) return nullptr;
    auto alone = std::make_shared<MapContext>();
    alone->picture = context_->picture;
    return alone;
}

void MapLayer::show() {
    painting_.drop();
    const auto& painted = shown_ ? whole_ : picture_;
    painted&& wanted() ? view_.showMap(*painted) : view_.clearMap();
    if (!painted && wanted()) paint();
}

void MapLayer::paint() {
    using Made = std::shared_ptr<const GroundPicture>;
    painting_.start<Made>(
        tr("Painting the map"),
        [context = wanted(), around = around_](Progress&, const std::stop_token&) -> Result<Made> {
            return std::make_shared<const GroundPicture>(paintContextPicture(*context, around));
        },
        [this](Result<Made> made) {
            if (!made) return;
            (shown_ ? whole_ : picture_) = *std::move(made);
            show();
        });
}

}  // namespace noonmark
