#include "render/view/view_navigator.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

namespace noonmark {

namespace {

constexpr double dragThresholdPx = 4;
constexpr double zoomPerNotch = 0.82;
constexpr double keyStep = 0.08;  // share of the distance to the target

glm::dvec2 of(QPointF point) { return {point.x(), point.y()}; }

bool pans(const QMouseEvent& event) {
    return event.buttons().testFlag(Qt::RightButton) || event.modifiers().testFlag(Qt::ShiftModifier);
}

bool drawsBox(const QMouseEvent& event) {
    return event.buttons() == Qt::LeftButton &&
           event.modifiers().testFlags(Qt::ControlModifier | Qt::ShiftModifier);
}

}  // namespace

ViewNavigator::ViewNavigator(CityView& view) : QObject(&view), view_(view) { view.installEventFilter(this); }

bool ViewNavigator::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
        case QEvent::MouseButtonPress:
            press(static_cast<QMouseEvent&>(*event));
            return true;
        case QEvent::MouseMove:
            drag(static_cast<QMouseEvent&>(*event));
            return true;
        case QEvent::MouseButtonRelease:
            release(static_cast<QMouseEvent&>(*event));
            return true;
        case QEvent::MouseButtonDblClick:
            doubled_ = true;
            Q_EMIT doubleClicked(inPicture(static_cast<QMouseEvent&>(*event).position()));
            return true;
        case QEvent::Wheel:
            wheel(static_cast<QWheelEvent&>(*event));
            return true;
        case QEvent::KeyPress:
            return key(static_cast<QKeyEvent&>(*event));
        case QEvent::Leave:
            Q_EMIT left();
            break;
        default:
            break;
    }
    return QObject::eventFilter(watched, event);
}

std::optional<Pick> ViewNavigator::pickAt(QPointF pixel) const {
    const ViewRay ray = makeRayThrough(view_.pose(), view_.lens(), of(pixel));
    return view_.section() ? scene_.pick(ray, *view_.section()) : scene_.pick(ray);
}

std::optional<glm::dvec3> ViewNavigator::groundAt(QPointF pixel) const {
    return scene_.ground(makeRayThrough(view_.pose(), view_.lens(), of(pixel)));
}

void ViewNavigator::removeTarget(DragTarget& target) {
    std::erase(targets_, &target);
    if (held_ == &target) held_ = nullptr;
}

void ViewNavigator::go(const CameraPose& pose) {
    const auto ground = [this](glm::dvec2 point) { return scene_.groundAt(point); };
    view_.setPose(keepAboveGround(pose, computeLimits(view_.viewBounds()), ground));
}

// Not called during a drag, which goes on in the picture in which it began.
QPointF ViewNavigator::inPicture(QPointF position) {
    side_ = view_.sideOffset(position);
    return position - QPointF(side_, 0);
}

void ViewNavigator::press(const QMouseEvent& event) {
    pressedAt_ = last_ = inPicture(event.position());
    dragging_ = doubled_ = boxing_ = false;
    // The target of a level elevation lies above the ground.
    const glm::dvec3 middle = view_.pose().target;
    pivot_ = {middle.x, middle.y, scene_.groundAt({middle.x, middle.y})};
    if (event.button() != Qt::LeftButton) return;
    const auto takes = [&](DragTarget* target) { return target->grab(pressedAt_); };
    const auto target = std::ranges::find_if(targets_, takes);
    held_ = target != targets_.end() ? *target : nullptr;
}

void ViewNavigator::drag(const QMouseEvent& event) {
    if (event.buttons() == Qt::NoButton) return Q_EMIT hovered(inPicture(event.position()));
    const QPointF here = event.position() - QPointF(side_, 0);
    if (held_) return held_->dragTo(here);
    const QPointF far = here - pressedAt_;
    if (!dragging_ && std::hypot(far.x(), far.y()) < dragThresholdPx) return;
    if (!std::exchange(dragging_, true)) boxing_ = drawsBox(event);
    if (boxing_) return Q_EMIT boxDragged(QRectF(pressedAt_, here).normalized());
    if (event.modifiers().testFlag(Qt::ControlModifier))
        Q_EMIT sunDragged(here - last_);
    else if (pans(event))
        go(pan(view_.pose(), of(last_), of(here), view_.lens()));
    else
        go(orbit(view_.pose(), pivot_, of(here - last_), view_.lens()));
    last_ = here;
}

void ViewNavigator::release(const QMouseEvent& event) {
    if (DragTarget* const target = std::exchange(held_, nullptr)) return target->drop();
    if (std::exchange(doubled_, false)) return;
    const QPointF here = event.position() - QPointF(side_, 0);
    if (std::exchange(boxing_, false)) Q_EMIT boxDropped(QRectF(pressedAt_, here).normalized());
    clickModifiers_ = event.modifiers();
    if (!dragging_ && event.button() == Qt::LeftButton) Q_EMIT clicked(pressedAt_);
    if (!dragging_ && event.button() == Qt::RightButton) Q_EMIT rightClicked(pressedAt_);
    dragging_ = false;
}

void ViewNavigator::wheel(const QWheelEvent& event) {
    zoomAt(inPicture(event.position()), std::pow(zoomPerNotch, event.angleDelta().y() / 120.0));
}

void ViewNavigator::zoomAt(QPointF pixel, double factor) {
    const CameraLimits limits = computeLimits(view_.viewBounds());
    const double distance = view_.pose().distanceM;
    const double allowed = std::clamp(factor, limits.nearestM / distance, limits.furthestM / distance);
    const auto hit = pickAt(pixel);
    const bool usable = hit && std::hypot(hit->position.x - view_.pose().target.x,
                                          hit->position.y - view_.pose().target.y) < 4 * distance;
    go(zoom(view_.pose(), usable ? hit->position : view_.pose().target, allowed));
}

bool ViewNavigator::key(const QKeyEvent& event) {
    const CameraPose& pose = view_.pose();
    const QPointF middle(view_.lens().widthPx / 2, view_.lens().heightPx / 2);
    switch (event.key()) {
        case Qt::Key_Left:
            go(moveCamera(pose, -keyStep, 0));
            return true;
        case Qt::Key_Right:
            go(moveCamera(pose, keyStep, 0));
            return true;
        case Qt::Key_Up:
            go(moveCamera(pose, 0, keyStep));
            return true;
        case Qt::Key_Down:
            go(moveCamera(pose, 0, -keyStep));
            return true;
        case Qt::Key_Plus:
        case Qt::Key_Equal:
            zoomAt(middle, zoomPerNotch);
            return true;
        case Qt::Key_Minus:
            zoomAt(middle, 1 / zoomPerNotch);
            return true;
        default:
            Q_EMIT keyPressed(event.key());
            return false;
    }
}

// Shows a pose made for a perspective in the projection chosen: it shows the same at its target.
void ViewNavigator::frame(CameraPose pose) {
    pose.projection = view_.pose().projection;
    go(pose);
}

void ViewNavigator::setProjection(Projection projection) {
    go(project(view_.pose(), projection, [this](glm::dvec2 point) { return scene_.groundAt(point); }));
}

void ViewNavigator::showWholeCity() { frame(wholeCity(view_.viewBounds(), view_.lens())); }

void ViewNavigator::turnNorthUp() {
    CameraPose pose = view_.pose();
    pose.headingDeg = 0;
    go(pose);
}

void ViewNavigator::lookFromAbove() {
    CameraPose pose = view_.pose();
    pose.pitchDeg = 90;
    go(pose);
}

void ViewNavigator::showSlanting(const Box2& box) {
    ViewBounds part = view_.viewBounds();
    part.box = box;
    part.groundM = float(scene_.groundAt(glm::dvec2(box.low + box.high) / 2.0));
    frame(wholeCity(part, view_.lens()));
}

void ViewNavigator::show(const Box2& box) {
    const glm::dvec2 centre = glm::dvec2(box.low + box.high) / 2.0;
    frame(fromAbove(box, scene_.groundAt(centre), view_.lens()));
}

}  // namespace noonmark
