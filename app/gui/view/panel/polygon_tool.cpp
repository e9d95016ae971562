#include "app/gui/view/panel/polygon_tool.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "core/city/footprints/repair_footprint.h"

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
        return Q_EMIT refused({"The direction of the side is not known",
                               {},
                               "Move the cursor to where the side leads, or type an azimuth: 40<90"});
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
                               "Click more corners, or press Esc"});
    const RepairedFootprint repaired = repairFootprint({parseRing(points_)});
    if (repaired.pieces.empty())
        return Q_EMIT refused({"The polygon has no area", {}, "Draw it again with corners farther apart"});
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

}  // namespace noonmark
