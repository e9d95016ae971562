#include "app/gui/view/panel/map_layer.h"

#include <QImage>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include "app/gui/view/panel/ground_layers.h"
#include "app/report/maps/city_painter.h"
#include "core/city/city_position.h"
#include "core/city/trees/tree.h"
#include "render/view/city_view.h"

namespace noonmark {

namespace {

constexpr float aroundM = 500;  // of map beyond the buildings
constexpr int restMs = 250;     // without movement, before the map is painted finer
// Painted beyond what is seen, and how far its pixels may be from those of the screen until it is painted
// again: so that small movements paint nothing.
constexpr float marginShare = 0.15F;
constexpr double maxCoarser = 1.5, maxFiner = 3;
constexpr int finerPixels = 3072;

static_assert(sizeof(GroundPicture::Pixel) == 4);

GroundPicture pictureOf(const QImage& image, const Grid& grid) {
    GroundPicture picture{grid, std::vector<GroundPicture::Pixel>(grid.size())};
    for (int row = 0; row < grid.rows; ++row)
        std::memcpy(&picture.pixels[std::size_t(row) * std::size_t(grid.columns)], image.constScanLine(row),
                    std::size_t(grid.columns) * sizeof(GroundPicture::Pixel));
    return picture;
}

Box2 boxOf(const Grid& grid) {
    Box2 box;
    box.add({float(grid.westM), float(grid.southM)});
    box.add({float(grid.eastM()), float(grid.northM())});
    return box;
}

Box2 widen(Box2 box, glm::vec2 byM) {
    box.low -= byM;
    box.high += byM;
    return box;
}

double longerSideM(const Box2& box) {
    const glm::vec2 size = box.high - box.low;
    return double(std::max(size.x, size.y));
}

}  // namespace

GroundPicture paintContextPicture(const MapContext& context, const Box2& around, double cellM, int maxPixels,
                                  bool withTrees) {
    const glm::dvec2 size(around.high - around.low);
    const double cell = std::max(cellM, std::max(size.x, size.y) / maxPixels);
    const Grid grid{double(around.low.x), double(around.low.y), cell,
                    std::max(1, int(std::ceil(size.x / cell))), std::max(1, int(std::ceil(size.y / cell)))};
    QImage image(grid.columns, grid.rows, QImage::Format_RGBA8888_Premultiplied);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    painter.setClipRect(image.rect());  // what lies outside is left out
    // Row 0 is the southernmost, so that the picture is not turned over.
    const QTransform toPixels(1 / cell, 0, 0, 1 / cell, -grid.westM / cell, -grid.southM / cell);
    paintContext(painter, context, toPixels, 1, withTrees);
    painter.end();
    return pictureOf(image, grid);
}

Box2 findCloseGround(const CameraPose& pose, const ViewLens& lens, const ViewBounds& bounds) {
    Box2 seen = noonmark::bounds(visibleGround(pose, lens, bounds));
    if (seen.empty()) return seen;
    const auto reachM = float(metresPerPixel(pose, lens) * std::max(lens.widthPx, lens.heightPx));
    const glm::vec2 target(pose.target);
    seen.low = glm::max(seen.low, target - reachM);
    seen.high = glm::min(seen.high, target + reachM);
    return glm::any(glm::greaterThanEqual(seen.low, seen.high)) ? Box2{} : seen;
}

bool holds(const Box2& outer, const Box2& inner) {
    return glm::all(glm::lessThanEqual(outer.low, inner.low)) &&
           glm::all(glm::greaterThanEqual(outer.high, inner.high));
}

MapLayer::MapLayer(CityView& view, QObject* parent) : QObject(parent), view_(view) {
    rest_.setSingleShot(true);
    rest_.setInterval(restMs);
    connect(&view_, &CityView::poseChanged, &rest_, qOverload<>(&QTimer::start));
    connect(&rest_, &QTimer::timeout, this, &MapLayer::showFiner);
}

// Dots of trees would stay where these were felled, moved or hidden.
void MapLayer::showCity(const City& city) {
    const bool treesStand = city.trees && !city.trees->trees.empty();
    if (city.context == context_ && treesStand == treesStand_) return;
    context_ = city.context;
    treesStand_ = treesStand;
    whole_.reset();
    picture_.reset();
    around_ = findMainPart(city).box;
    if (around_.empty()) around_ = bounds(city);
    around_ = widen(around_, glm::vec2(aroundM));
    show();
}

void MapLayer::setShown(bool shown) {
    shown_ = shown;
    show();
}

std::optional<double> MapLayer::finerCellM() const {
    return finer_ ? std::optional(finer_->grid.cellM) : std::nullopt;
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
    paintingFiner_.drop();
    finer_.reset();
    view_.clearFinerMap();
    const auto& painted = shown_ ? whole_ : picture_;
    painted&& wanted() ? view_.showMap(*painted) : view_.clearMap();
    if (!painted && wanted()) paint();
    rest_.start();
}

void MapLayer::paint() {
    painting_.start<Picture>(
        tr("Painting the map"),
        [context = wanted(), around = around_, withTrees = !treesStand_](
            Progress&, const std::stop_token&) -> Result<Picture> {
            return std::make_shared<const GroundPicture>(
                paintContextPicture(*context, around, wholeMapCellM, wholeMapPixels, withTrees));
        },
        [this](Result<Picture> made) {
            if (!made) return;
            (shown_ ? whole_ : picture_) = *std::move(made);
            show();
        });
}

void MapLayer::showFiner() {
    const Picture& whole = shown_ ? whole_ : picture_;
    if (!whole || !wanted()) return;
    const ViewLens lens = view_.lens();
    const Box2 seen = findCloseGround(view_.pose(), lens, {around_, view_.viewBounds().topM});
    const Box2 wider = seen.empty() ? seen : widen(seen, marginShare * (seen.high - seen.low));
    const double cellM = std::max(metresPerPixel(view_.pose(), lens) / view_.devicePixelRatio(),
                                  longerSideM(wider) / finerPixels);
    if (cellM >= whole->grid.cellM || seen.empty()) {
        paintingFiner_.drop();
        finer_.reset();
        return view_.clearFinerMap();
    }
    const double shownM = finer_ ? finer_->grid.cellM : whole->grid.cellM;
    const bool fits = shownM <= maxCoarser * cellM && shownM * maxFiner >= cellM;
    if (!finer_ || !fits || !holds(boxOf(finer_->grid), seen)) paintFiner(wider, cellM);
}

void MapLayer::paintFiner(const Box2& around, double cellM) {
    paintingFiner_.start<Picture>(
        tr("Painting the map"),
        [context = wanted(), around, cellM, withTrees = !treesStand_](
            Progress&, const std::stop_token&) -> Result<Picture> {
            return std::make_shared<const GroundPicture>(
                paintContextPicture(*context, around, cellM, finerPixels, withTrees));
        },
        [this](Result<Picture> made) {
            if (!made) return;
            finer_ = *std::move(made);
            view_.showFinerMap(*finer_);
        });
}

}  // namespace noonmark
