#include "app/gui/view/panel/snapping.h"

#include <QGuiApplication>
#include <QObject>
#include <utility>

namespace noonmark {

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
