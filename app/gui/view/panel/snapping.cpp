#include "app/gui/view/panel/snapping.h"

#include <QGuiApplication>
#include <QObject>
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <utility>

namespace noonmark {

namespace {

constexpr double widestM = 500;

std::vector<Box2> boxesOf(const std::vector<std::shared_ptr<const Building>>& buildings) {
    std::vector<Box2> boxes;
    boxes.reserve(buildings.size());
    for (const auto& building : buildings) boxes.push_back(bounds(*building));
    return boxes;
}

bool meets(const Box2& a, const Box2& b) {
    return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}

// The nearest corner and the nearest point of an edge, of all that are added.
class NearestPoint {
public:
    NearestPoint(glm::dvec2 cursor, const SnapReach& reach)
        : cursor_(cursor),
          reach_(reach),
          box_{glm::vec2(cursor - reach.halfBoxM()), glm::vec2(cursor + reach.halfBoxM())} {}

    [[nodiscard]] const Box2& box() const { return box_; }

    void add(const Footprint& footprint) {
        if (!meets(bounds(footprint), box_)) return;
        add(footprint.outer);
        for (const Ring& hole : footprint.holes) add(hole);
    }
    void addEdge(glm::dvec2 a, glm::dvec2 b) {
        const glm::dvec2 side = onScreen(b - a), fromA = onScreen(cursor_ - a);
        const double square = glm::dot(side, side);
        const double along = square > 0 ? std::clamp(glm::dot(fromA, side) / square, 0.0, 1.0) : 0;
        offer(edge_, {SnapKind::edge, a + along * (b - a)});
    }
    void addCorner(glm::dvec2 at) { offer(corner_, {SnapKind::corner, at}); }
    [[nodiscard]] std::optional<Snap> found() const { return corner_.snap ? corner_.snap : edge_.snap; }

private:
    struct Nearest {
        std::optional<Snap> snap;
        double distancePx = 0;
    };
    [[nodiscard]] glm::dvec2 onScreen(glm::dvec2 byM) const { return reach_.pixelsPerMetre * byM; }
    void add(const Ring& ring) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            addCorner(glm::dvec2(ring[i]));
            addEdge(glm::dvec2(ring[i]), glm::dvec2(ring[(i + 1) % ring.size()]));
        }
    }
    void offer(Nearest& nearest, const Snap& snap) {
        const double distancePx = glm::length(onScreen(snap.point - cursor_));
        if (distancePx > reach_.reachPx || (nearest.snap && distancePx >= nearest.distancePx)) return;
        nearest = {snap, distancePx};
    }

    glm::dvec2 cursor_;
    SnapReach reach_;
    Box2 box_;
    Nearest corner_, edge_;
};

// Parts above the ground only where a building has no others: their corners lie in the air.
void addOutlines(NearestPoint& nearest, const Building& building) {
    const bool stands =
        std::ranges::any_of(building.parts, [](const Part& part) { return !part.isOverhanging; });
    for (const Part& part : building.parts)
        if (!stands || !part.isOverhanging) nearest.add(part.footprint);
}

}  // namespace

// The rows of the inverse are the half axes of the ellipse on the ground that is a circle on the screen.
glm::dvec2 SnapReach::halfBoxM() const {
    if (glm::determinant(pixelsPerMetre) == 0) return glm::dvec2(widestM);
    const glm::dmat2 back = glm::transpose(glm::inverse(pixelsPerMetre));
    return glm::min(reachPx * glm::dvec2(glm::length(back[0]), glm::length(back[1])), glm::dvec2(widestM));
}

SnapTargets::SnapTargets(const City& city) : buildings_(city.buildings), boxes_(boxesOf(city.buildings)) {}

std::optional<Snap> SnapTargets::find(glm::dvec2 cursor, const SnapReach& reach,
                                      std::span<const glm::dvec2> line) const {
    NearestPoint nearest(cursor, reach);
    for (const std::size_t i : boxes_.findMeeting(nearest.box())) addOutlines(nearest, *buildings_[i]);
    for (const Footprint& lot : lots_) nearest.add(lot);
    for (std::size_t i = 0; i < line.size(); ++i) {
        nearest.addCorner(line[i]);
        if (i > 0) nearest.addEdge(line[i - 1], line[i]);
    }
    return nearest.found();
}

namespace {

constexpr double markLiftM = 0.3;  // as lines on the ground

bool controlIsDown() { return QGuiApplication::keyboardModifiers().testFlag(Qt::ControlModifier); }

PointMarks::Mark markOf(const Snap& snap, const City& city) {
    const auto shape =
        snap.kind == SnapKind::corner ? PointMarks::Shape::snappedCorner : PointMarks::Shape::snappedEdge;
    return {shape, {snap.point, double(groundAt(city, snap.point)) + markLiftM}};
}

}  // namespace

SnapReach computeSnapReach(const CameraPose& pose, const ViewLens& lens, const glm::dvec3& ground) {
    constexpr double stepM = 0.01;
    SnapReach reach;
    const auto here = pixelOf(pose, lens, ground);
    const auto east = pixelOf(pose, lens, ground + glm::dvec3(stepM, 0, 0));
    const auto north = pixelOf(pose, lens, ground + glm::dvec3(0, stepM, 0));
    if (here && east && north)
        reach.pixelsPerMetre = glm::dmat2((*east - *here) / stepM, (*north - *here) / stepM);
    return reach;
}

QString describeSnap(SnapKind kind) {
    return kind == SnapKind::corner ? QObject::tr("corner") : QObject::tr("edge");
}

void Snapping::setCity(std::shared_ptr<const OpenCity> city) {
    city_ = std::move(city);
    targets_.reset();
}

void Snapping::setLots(std::vector<Footprint> lots) {
    lots_ = std::move(lots);
    if (targets_) targets_->setLots(lots_);
}

std::optional<Snap> Snapping::find(const glm::dvec3& ground, std::span<const glm::dvec2> line) {
    std::optional<Snap> snap;
    if (city_ && !controlIsDown()) {
        if (!targets_) targets_.emplace(city_->city()).setLots(lots_);
        snap = targets_->find(glm::dvec2(ground), computeSnapReach(view_.pose(), view_.lens(), ground), line);
    }
    view_.pointMarks().showSnap(snap ? std::optional(markOf(*snap, city_->city())) : std::nullopt);
    return snap;
}

void Snapping::clearMark() { view_.pointMarks().showSnap(std::nullopt); }

}  // namespace noonmark
