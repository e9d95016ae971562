#include "app/gui/session/study/massing_preview.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>

#include "app/gui/base/widgets/error_text.h"
#include "app/gui/base/widgets/number_text.h"
#include "core/city/city_position.h"

namespace noonmark {

namespace {

constexpr float sketchedM = 700;
// Looking down from the south: depth is shortened, and heights are as they are.
constexpr double depthShare = 0.55, heightShare = 0.85;

float heightOver(const Building& building, const City& city) {
    const Box2 box = bounds(building);
    return topM(building) - groundAt(city, glm::dvec2(box.low + box.high) / 2.0);
}

void addPrisms(const Building& building, const City& city, MassingSketch& sketch) {
    const Box2 around = bounds(building);
    const float groundM = groundAt(city, glm::dvec2(around.low + around.high) / 2.0);
    for (const Part& part : building.parts) {
        if (part.footprint.outer.size() < 3) continue;
        sketch.prisms.push_back({part.footprint.outer, std::max(0.0F, part.bottomM - groundM),
                                 std::max(0.0F, part.topM - groundM), part.heightSource});
        sketch.tallestM = std::max(sketch.tallestM, sketch.prisms.back().topM);
    }
}

bool overlaps(const Box2& a, const Box2& b) {
    return a.low.x < b.high.x && a.high.x > b.low.x && a.low.y < b.high.y && a.high.y > b.low.y;
}

void measureHeights(const City& city, MassingSketch& sketch) {
    std::vector<float> heights;
    for (const auto& building : city.buildings) heights.push_back(heightOver(*building, city));
    if (heights.empty()) return;
    std::ranges::sort(heights);
    sketch.lowM = heights.front();
    sketch.medianM = heights[heights.size() / 2];
    sketch.highM = heights.back();
}

/// From local metres to the widget.
struct SketchView {
    QPointF origin;
    double scale = 1;
    Box2 box;
    [[nodiscard]] QPointF operator()(glm::vec2 at, float heightM) const {
        return origin +
               QPointF(double(at.x - box.low.x) * scale, -double(at.y - box.low.y) * scale * depthShare -
                                                             double(heightM) * scale * heightShare);
    }
};

SketchView fit(const MassingSketch& sketch, const QRectF& area) {
    const glm::dvec2 size = glm::dvec2(sketch.box.high - sketch.box.low);
    const double upM = size.y * depthShare + double(sketch.tallestM) * heightShare;
    const double scale = std::min(area.width() / std::max(1.0, size.x), area.height() / std::max(1.0, upM));
    const QPointF origin(area.center().x() - size.x * scale / 2, area.center().y() + upM * scale / 2);
    return {origin, scale, sketch.box};
}

// Only walls that face the viewer: of an outline that runs counter-clockwise those that run eastwards.
void paintWalls(QPainter& painter, const MassingSketch::Prism& prism, const SketchView& to,
                const QColor& colour) {
    for (std::size_t i = 0; i < prism.outline.size(); ++i) {
        const glm::vec2 a = prism.outline[i], b = prism.outline[(i + 1) % prism.outline.size()];
        const glm::vec2 side = b - a;
        if (side.x <= 0) continue;
        const float eastwards = side.y / (std::abs(side.x) + std::abs(side.y));
        painter.setBrush(colour.darker(140 + int(40 * eastwards)));
        const QPointF wall[] = {to(a, prism.bottomM), to(b, prism.bottomM), to(b, prism.topM),
                                to(a, prism.topM)};
        painter.drawConvexPolygon(wall, 4);
    }
}

void paintPrism(QPainter& painter, const MassingSketch::Prism& prism, const SketchView& to) {
    const QColor colour = colourOf(prism.source).colour;
    painter.setPen(QPen(colour.darker(200), 0.4));
    paintWalls(painter, prism, to, colour);
    QPolygonF roof;
    for (const glm::vec2 point : prism.outline) roof << to(point, prism.topM);
    painter.setBrush(colour);
    painter.drawPolygon(roof);
}

QString describeSources(const SourceCounts& counts) {
    QStringList some;
    for (const HeightSourceColour& one : heightSourceColours())
        if (const std::size_t count = counts[std::size_t(one.source)]; count > 0)
            some << QStringLiteral("%1 %2").arg(formatCount(count), translated(one.label));
    return some.join(QObject::tr(", "));
}

}  // namespace

MassingSketch sketchMassing(const City& city) {
    MassingSketch sketch;
    sketch.buildings = city.buildings.size();
    sketch.sources = countSources(city);
    measureHeights(city, sketch);
    sketch.box = findDensestBox(city, findMainPart(city).box, glm::vec2(sketchedM));
    for (const auto& building : city.buildings)
        if (overlaps(bounds(*building), sketch.box)) addPrisms(*building, city, sketch);
    std::ranges::stable_sort(sketch.prisms, std::greater<>{}, [](const MassingSketch::Prism& prism) {
        return std::pair(bounds(prism.outline).high.y, -prism.topM);
    });
    return sketch;
}

MassingPreview::MassingPreview(QWidget* parent) : QWidget(parent), sketch_(MassingSketch{}) {
    setObjectName(QStringLiteral("massingPreview"));
    setMinimumSize(280, 260);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void MassingPreview::showWaiting() {
    waiting_ = true;
    update();
}

void MassingPreview::show(Result<MassingSketch> sketch) {
    waiting_ = false;
    sketch_ = std::move(sketch);
    setAccessibleName(words());
    update();
}

// A building may lie below the ground: a station, a garage, or one of another elevation than the terrain.
QString MassingPreview::describeLowest() const {
    constexpr float shownM = 0.05F;
    if (sketch_->lowM > -shownM) return describeLength(std::max(0.0, double(sketch_->lowM)));
    return tr("%1 below the ground").arg(describeLength(-double(sketch_->lowM)));
}

QString MassingPreview::words() const {
    if (waiting_) return tr("Reading the files...");
    if (!sketch_) return describeError(sketch_.error());
    if (sketch_->buildings == 0) return tr("The files hold no buildings.");
    return tr("%1 building(s); heights: %2.\nLowest %3, median %4, tallest %5.", "",
              pluralNumber(sketch_->buildings))
        .arg(formatCount(sketch_->buildings), describeSources(sketch_->sources), describeLowest(),
             describeLength(double(sketch_->medianM)), describeLength(double(sketch_->highM)));
}

void MassingPreview::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QString text = words();
    const QRectF all = QRectF(rect()).adjusted(8, 8, -8, -8);
    const QRectF room = painter.boundingRect(all, Qt::TextWordWrap | Qt::AlignBottom, text);
    if (sketch_ && !waiting_ && !sketch_->prisms.empty()) {
        const SketchView to = fit(*sketch_, all.adjusted(0, 0, 0, -room.height() - 8));
        for (const MassingSketch::Prism& prism : sketch_->prisms) paintPrism(painter, prism, to);
    }
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(room, Qt::TextWordWrap | Qt::AlignBottom, text);
}

}  // namespace noonmark
