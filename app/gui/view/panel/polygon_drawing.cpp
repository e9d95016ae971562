#include "app/gui/view/panel/polygon_drawing.h"

#include <QGuiApplication>
#include <QRegularExpression>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "app/gui/base/looks/units.h"
#include "app/gui/base/widgets/cursor_label.h"
#include "app/gui/base/widgets/number_text.h"
#include "core/city/footprints/repair_footprint.h"
#include "render/view/view_navigator.h"

namespace noonmark {

namespace {

// Closer points count as the same: a double click sends its place twice, and so may an unsteady hand.
constexpr float samePlaceM = 0.05F;

RawRing parseRing(const std::vector<glm::vec3>& points) {
    RawRing ring;
    for (const glm::vec3 point : points) ring.emplace_back(double(point.x), double(point.y));
    return ring;
}

// The point nearest to `to` on the two lines through `from`, along `direction` and perpendicular to it.
glm::vec2 squared(glm::vec2 from, glm::vec2 to, glm::vec2 direction) {
    const float length = glm::length(direction);
    const glm::vec2 along = length > 0 ? direction / length : glm::vec2(1, 0);
    const glm::vec2 across(-along.y, along.x);
    const float a = glm::dot(to - from, along), b = glm::dot(to - from, across);
    return std::abs(a) >= std::abs(b) ? from + a * along : from + b * across;
}

glm::dvec2 directionOf(double azimuthDeg) {
    const double azimuth = glm::radians(azimuthDeg);
    return {std::sin(azimuth), std::cos(azimuth)};
}

}  // namespace

PolygonTool::PolygonTool(QString what, QObject* parent) : QObject(parent), what_(std::move(what)) {}

void PolygonTool::begin() {
    points_.clear();
    cursor_.reset();
    active_ = true;
    Q_EMIT activeChanged(true);
    Q_EMIT lineChanged();
}

glm::vec3 PolygonTool::placed(glm::dvec3 ground, bool square) const {
    const glm::vec3 there(ground);
    if (!square || points_.empty()) return there;
    const glm::vec2 last(points_.back());
    const glm::vec2 side =
        points_.size() > 1 ? last - glm::vec2(points_[points_.size() - 2]) : glm::vec2(1, 0);
    return {squared(last, glm::vec2(there), side), there.z};
}

void PolygonTool::addPoint(glm::dvec3 ground, bool square) {
    if (!active_) return;
    const glm::vec3 point = placed(ground, square);
    if (!points_.empty() && glm::distance(points_.back(), point) < samePlaceM) return;
    points_.push_back(point);
    Q_EMIT lineChanged();
}

void PolygonTool::moveTo(glm::dvec3 ground, bool square) {
    if (!active_ || points_.empty()) return;
    cursor_ = placed(ground, square);
    Q_EMIT lineChanged();
}

void PolygonTool::addSide(double lengthM, std::optional<double> azimuthDeg) {
    if (!active_ || points_.empty()) return;
    const glm::vec3 last = points_.back();
    const auto direction = azimuthDeg ? std::optional(directionOf(*azimuthDeg)) : cursorDirection();
    if (!direction)
        return Q_EMIT refused(
            {QT_TRANSLATE_NOOP("Error", "The direction of the side is not known"),
             {},
             QT_TRANSLATE_NOOP("Error",
                               "Move the cursor to where the side leads, or type an azimuth: 40<90")});
    addPoint(glm::dvec3(glm::dvec2(last) + lengthM * *direction, double(last.z)));
}

std::optional<glm::dvec2> PolygonTool::cursorDirection() const {
    if (!cursor_) return std::nullopt;
    const glm::dvec2 towards = glm::dvec2(*cursor_) - glm::dvec2(points_.back());
    if (glm::length(towards) < double(samePlaceM)) return std::nullopt;
    return glm::normalize(towards);
}

bool PolygonTool::closesAt(glm::dvec2 ground) const {
    return points_.size() > 2 && glm::distance(glm::dvec2(points_.front()), ground) < double(samePlaceM);
}

void PolygonTool::removeLastPoint() {
    if (!active_ || points_.empty()) return;
    points_.pop_back();
    Q_EMIT lineChanged();
}

void PolygonTool::finish() {
    if (!active_) return;
    if (points_.size() < 3)
        return Q_EMIT refused({"A " + what_.toStdString() + " needs three corners or more",
                               {},
                               QT_TRANSLATE_NOOP("Error", "Click more corners, or press Esc")});
    const RepairedFootprint repaired = repairFootprint({parseRing(points_)});
    if (repaired.pieces.empty())
        return Q_EMIT refused({QT_TRANSLATE_NOOP("Error", "The polygon has no area"),
                               {},
                               QT_TRANSLATE_NOOP("Error", "Draw it again with corners farther apart")});
    end();
    Q_EMIT finished(repaired.pieces);
}

void PolygonTool::cancel() {
    if (active_) end();
}

void PolygonTool::end() {
    active_ = false;
    points_.clear();
    cursor_.reset();
    Q_EMIT activeChanged(false);
    Q_EMIT lineChanged();
}

std::vector<glm::vec3> PolygonTool::line() const {
    std::vector<glm::vec3> line = points_;
    if (cursor_ && !points_.empty()) line.push_back(*cursor_);
    return line;
}

double PolygonTool::sideM() const {
    const std::vector<glm::vec3> points = line();
    if (points.size() < 2) return 0;
    return double(glm::distance(glm::vec2(points.back()), glm::vec2(points[points.size() - 2])));
}

double PolygonTool::areaM2() const {
    const std::vector<glm::vec3> points = line();
    return points.size() < 3 ? 0 : std::abs(signedArea(Ring(points.begin(), points.end())));
}

namespace {

bool wantsSquare() { return QGuiApplication::keyboardModifiers().testFlag(Qt::ShiftModifier); }

// Without the last corner and side, on which the next side would fold back.
std::vector<glm::dvec2> lineToSnapTo(const PolygonTool& tool) {
    std::vector<glm::dvec2> line;
    for (std::size_t i = 0; i + 1 < tool.points().size(); ++i) line.emplace_back(tool.points()[i]);
    return line;
}

// "24.6 m, 812 m²"; empty before there is a side.
QString describeDrawn(const PolygonTool& tool) {
    if (tool.sideM() == 0) return {};
    const QString side = describeLength(tool.sideM());
    return tool.areaM2() == 0 ? side : side + QStringLiteral(", ") + describeArea(tool.areaM2());
}

}  // namespace

PolygonDrawing::PolygonDrawing(CityView& view, ViewNavigator& navigator, CursorLabel& label, QObject* parent)
    : QObject(parent),
      navigator_(navigator),
      label_(label),
      snapping_(view),
      tools_{new PolygonTool(tr("region"), this), new PolygonTool(tr("lot"), this),
             new PolygonTool(tr("place"), this)},
      claim_(view, [this](int key) { return active() != nullptr && typed_.claims(key); }) {
    for (PolygonTool* tool : tools_) connectTool(tool);
    connect(&navigator_, &ViewNavigator::clicked, this, &PolygonDrawing::click);
    connect(&navigator_, &ViewNavigator::left, this, [this] { snapping_.clearMark(); });
    connect(&navigator_, &ViewNavigator::doubleClicked, this, [this] {
        if (PolygonTool* tool = active()) tool->finish();
    });
}

// Only one polygon is drawn at a time.
void PolygonDrawing::connectTool(PolygonTool* tool) {
    connect(tool, &PolygonTool::lineChanged, this, &PolygonDrawing::lineChanged);
    connect(tool, &PolygonTool::refused, this, &PolygonDrawing::refused);
    connect(tool, &PolygonTool::activeChanged, this, [this, tool](bool on) {
        for (PolygonTool* other : tools_)
            if (on && other != tool) other->cancel();
        typed_.clear();
        snap_.reset();
        snapping_.clearMark();
        Q_EMIT activeChanged(on);
    });
}

PolygonTool* PolygonDrawing::active() const {
    for (PolygonTool* tool : tools_)
        if (tool->active()) return tool;
    return nullptr;
}

void PolygonDrawing::cancel() {
    if (PolygonTool* tool = active()) tool->cancel();
}

std::optional<glm::dvec3> PolygonDrawing::groundAt(QPointF pixel) {
    auto ground = navigator_.groundAt(pixel);
    snap_.reset();
    if (!ground) snapping_.clearMark();
    if (!ground) return ground;
    snap_ = snapping_.find(*ground, lineToSnapTo(*active()));
    if (snap_) ground = glm::dvec3(snap_->point, ground->z);
    return ground;
}

// The polygon is finished after the click has reached everyone, who would take it for their own otherwise.
void PolygonDrawing::click(QPointF pixel) {
    PolygonTool* tool = active();
    const auto ground = tool != nullptr ? groundAt(pixel) : std::nullopt;
    if (!ground) return;
    if (tool->closesAt(glm::dvec2(*ground)))
        QMetaObject::invokeMethod(tool, &PolygonTool::finish, Qt::QueuedConnection);
    else
        tool->addPoint(*ground, wantsSquare());
}

void PolygonDrawing::hover(QPointF pixel) {
    PolygonTool* tool = active();
    const auto ground = tool != nullptr ? groundAt(pixel) : std::nullopt;
    if (!ground) return;
    pixel_ = pixel;
    tool->moveTo(*ground, wantsSquare());
    showLabel();
}

bool PolygonDrawing::key(int key) {
    PolygonTool* tool = active();
    if (tool == nullptr) return false;
    const TypedLength::Taken taken = tool->points().empty() ? TypedLength::Taken::no : typed_.take(key);
    if (taken == TypedLength::Taken::entered) takeTyped();
    if (taken == TypedLength::Taken::no) editKey(key);
    if (active() != nullptr) showLabel();
    return true;
}

void PolygonDrawing::editKey(int key) {
    PolygonTool* tool = active();
    if (key == Qt::Key_Return || key == Qt::Key_Enter) tool->finish();
    if (key == Qt::Key_Escape) tool->cancel();
    if (key == Qt::Key_Backspace) tool->removeLastPoint();
}

void PolygonDrawing::takeTyped() {
    const QString text = typed_.finish();
    const auto side = parseTypedSide(text, unitsInUse());
    if (side) return active()->addSide(side->lengthM, side->azimuthDeg);
    Q_EMIT refused({QT_TRANSLATE_NOOP("Error", "This is not a length"), text.toStdString(),
                    QT_TRANSLATE_NOOP("Error", "Type it as 40, 40 m or 131' 3\", with an azimuth as 40<90")});
}

void PolygonDrawing::showLabel() { label_.show(pixel_, typed_.empty() ? describe() : describeTyped()); }

QString PolygonDrawing::describe() const {
    const PolygonTool& tool = *active();
    QString words = describeDrawn(tool);
    if (!snap_) return words;
    const QString snapped =
        tool.closesAt(snap_->point) ? tr("first corner: closes the outline") : describeSnap(snap_->kind);
    return words.isEmpty() ? snapped : words + QLatin1Char('\n') + snapped;
}

QString PolygonDrawing::describeTyped() const {
    const QStringList parts = typed_.withUnit().split(QRegularExpression(QStringLiteral("[<;]")));
    if (parts.size() == 1) return tr("Length: %1  (Enter)").arg(parts[0]);
    return tr("Length: %1, azimuth: %2° clockwise from north  (Enter)").arg(parts[0], parts[1]);
}

}  // namespace noonmark
