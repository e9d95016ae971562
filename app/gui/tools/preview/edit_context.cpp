#include "app/gui/tools/preview/edit_context.h"

#include <QGuiApplication>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "app/gui/base/looks/units.h"
#include "app/gui/base/widgets/number_text.h"
#include "core/base/units.h"

namespace noonmark {

namespace {

constexpr double minSine = 0.1392;  // sine of 8 degrees

}  // namespace

// The nearest points of the two lines, origin + s direction and foot + h z: their difference is perpendicular
// to both.
std::optional<double> heightOnVertical(const ViewRay& ray, glm::dvec3 foot) {
    const glm::dvec2 along(ray.direction);
    const double level2 = along.x * along.x + along.y * along.y;  // squared sine of the angle to the vertical
    if (level2 < minSine * minSine) return std::nullopt;
    const glm::dvec3 away = foot - ray.origin;
    const double distance = (along.x * away.x + along.y * away.y) / level2;
    if (!(distance > 0)) return std::nullopt;
    return ray.origin.z + distance * ray.direction.z - foot.z;
}

double roundToStoreys(double heightM, double storeyM) {
    const double maximum = std::floor(tallestBuildingM / storeyM + 1e-9);
    return std::clamp(std::round(heightM / storeyM), 1.0, maximum) * storeyM;
}

double roundHeight(double heightM, double storeyM) {
    return std::clamp(std::round(heightM * 10) / 10, storeyM, tallestBuildingM);
}

namespace {

constexpr double reachPx = 30;   // around the handle's middle
constexpr double steepDeg = 70;  // steeper than this, a vertical is too short on screen to be dragged along

glm::dvec2 of(QPointF point) { return {point.x(), point.y()}; }

bool shiftIsDown() { return QGuiApplication::keyboardModifiers().testFlag(Qt::ShiftModifier); }

}  // namespace

ExtrudeHandle::ExtrudeHandle(ViewPanel& panel, QObject* parent)
    : QObject(parent),
      panel_(panel),
      claim_(panel.view(), [this](int key) { return tower_ && typed_.claims(key); }) {
    next_.setSingleShot(true);
    next_.setInterval(0);
    connect(&next_, &QTimer::timeout, this, &ExtrudeHandle::follow);
    connect(&panel.navigator(), &ViewNavigator::hovered, this,
            [this](QPointF pixel) { panel_.view().overlay().lightHandle(isAt(pixel)); });
    panel.navigator().addTarget(*this);
}

ExtrudeHandle::~ExtrudeHandle() { panel_.navigator().removeTarget(*this); }

void ExtrudeHandle::place(const Tower& tower) {
    tower_ = tower;
    panel_.view().overlay().showHandle(tower.foot + glm::dvec3(0, 0, tower.heightM));
}

void ExtrudeHandle::hide() {
    if (!tower_) return;
    tower_.reset();
    grabbedM_.reset();
    typed_.clear();
    next_.stop();
    panel_.view().overlay().showHandle(std::nullopt);
    panel_.cursorLabel().hide();
}

bool ExtrudeHandle::isAt(QPointF pixel) const {
    const auto middle = panel_.view().overlay().handlePixel(panel_.view().pose(), panel_.view().lens());
    return tower_ && middle && glm::distance(*middle, of(pixel)) < reachPx;
}

// Seen from nearly straight above, a vertical has no length on screen: each pixel counts as the metres that a
// pixel covers at the view's target.
double ExtrudeHandle::metresUp(QPointF pixel) const {
    const CityView& view = panel_.view();
    return (view.lens().heightPx - pixel.y()) * metresPerPixel(view.pose(), view.lens());
}

std::optional<double> ExtrudeHandle::heightAt(QPointF pixel) const {
    if (fromAbove_) return metresUp(pixel);
    const CityView& view = panel_.view();
    return heightOnVertical(makeRayThrough(view.pose(), view.lens(), of(pixel)), tower_->foot);
}

bool ExtrudeHandle::grab(QPointF pixel) {
    if (!isAt(pixel)) return false;
    typed_.clear();
    pixel_ = pixel;
    fromAbove_ = panel_.view().pose().pitchDeg > steepDeg;
    grabbedM_ = heightAt(pixel).value_or(tower_->heightM) - tower_->heightM;
    Q_EMIT dragged(tower_->heightM);
    return true;
}

void ExtrudeHandle::dragTo(QPointF pixel) {
    pixel_ = pixel;
    if (!next_.isActive()) next_.start();
}

void ExtrudeHandle::follow() {
    if (!tower_ || !grabbedM_) return;
    const auto height = heightAt(pixel_);
    if (!height) return;
    const double wanted = *height - *grabbedM_;
    Q_EMIT dragged(shiftIsDown() ? roundHeight(wanted, tower_->storeyM)
                                 : roundToStoreys(wanted, tower_->storeyM));
}

void ExtrudeHandle::drop() {
    follow();
    next_.stop();
    grabbedM_.reset();
    panel_.cursorLabel().hide();
    if (tower_) Q_EMIT dropped(tower_->heightM);
}

void ExtrudeHandle::showFigures(const QString& figures) {
    if (grabbedM_) panel_.cursorLabel().show(pixel_, figures);
}

bool ExtrudeHandle::key(int key) {
    if (!tower_) return false;
    const TypedLength::Taken taken = typed_.take(key);
    if (taken == TypedLength::Taken::no) return false;
    if (taken == TypedLength::Taken::entered) takeTyped();
    showTyped();
    return true;
}

void ExtrudeHandle::takeTyped() {
    const auto height = parseLength(typed_.finish().toStdString(), unitsInUse());
    if (height) Q_EMIT dragged(roundHeight(*height - heightZeroM(tower_->groundElevationM), tower_->storeyM));
    Q_EMIT dropped(tower_->heightM);
}

void ExtrudeHandle::showTyped() {
    const auto at = panel_.view().overlay().handlePixel(panel_.view().pose(), panel_.view().lens());
    if (!at) return;
    const QString words = heightReferenceInUse() == HeightReference::datum
                              ? tr("Top above datum: %1  (Enter)")
                              : tr("Height: %1  (Enter)");
    panel_.cursorLabel().show({at->x, at->y}, typed_.empty() ? QString() : words.arg(typed_.withUnit()));
}

}  // namespace noonmark
