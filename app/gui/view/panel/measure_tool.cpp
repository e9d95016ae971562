#include "app/gui/view/panel/measure_tool.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace noonmark {

namespace {

// Closer points count as the same: a double click sends its place twice.
constexpr double samePointM = 0.01;
constexpr double levelM = 0.05;  // a smaller rise is not stated

double planDistance(glm::dvec3 a, glm::dvec3 b) { return glm::distance(glm::dvec2(a), glm::dvec2(b)); }

double planArea(const std::vector<glm::dvec3>& points) {
    double twice = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const glm::dvec3 a = points[i] - points[0], b = points[(i + 1) % points.size()] - points[0];
        twice += a.x * b.y - b.x * a.y;
    }
    return std::abs(twice) / 2;
}

}  // namespace

LineMeasures measureLine(const std::vector<glm::dvec3>& points) {
    LineMeasures measures;
    if (points.size() < 2) return measures;
    const glm::dvec3 from = points[points.size() - 2], to = points.back();
    measures.sideM = planDistance(from, to);
    measures.riseM = to.z - from.z;
    measures.slopeM = glm::distance(from, to);
    for (std::size_t i = 1; i < points.size(); ++i)
        measures.lengthM += planDistance(points[i - 1], points[i]);
    if (points.size() > 2) measures.areaM2 = planArea(points);
    return measures;
}

QString describeMeasures(const LineMeasures& measures, UnitSystem units) {
    if (measures.slopeM == 0 && measures.lengthM == 0) return {};
    const auto length = [units](double m) { return QString::fromStdString(formatLength(m, units)); };
    QString words = length(measures.sideM);
    if (std::abs(measures.riseM) >= levelM)
        words = (measures.riseM > 0 ? QObject::tr("%1, %2 up (%3 in space)")
                                    : QObject::tr("%1, %2 down (%3 in space)"))
                    .arg(words, length(std::abs(measures.riseM)), length(measures.slopeM));
    if (measures.areaM2 == 0) return words;
    return QObject::tr("%1\nAll sides %2, area %3")
        .arg(words, length(measures.lengthM),
             QString::fromStdString(formatSmallArea(measures.areaM2, units)));
}

void MeasureTool::begin() {
    points_.clear();
    cursor_.reset();
    active_ = true;
    Q_EMIT activeChanged(true);
    Q_EMIT lineChanged();
}

void MeasureTool::end() {
    if (!active_) return;
    active_ = false;
    points_.clear();
    cursor_.reset();
    Q_EMIT activeChanged(false);
    Q_EMIT lineChanged();
}

void MeasureTool::addPoint(glm::dvec3 point) {
    if (!active_) return;
    if (!points_.empty() && glm::distance(points_.back(), point) < samePointM) return;
    points_.push_back(point);
    Q_EMIT lineChanged();
}

void MeasureTool::moveTo(glm::dvec3 point) {
    if (!active_ || points_.empty()) return;
    cursor_ = point;
    Q_EMIT lineChanged();
}

void MeasureTool::removeLastPoint() {
    if (!active_ || points_.empty()) return;
    points_.pop_back();
    Q_EMIT lineChanged();
}

std::vector<glm::dvec3> MeasureTool::line() const {
    std::vector<glm::dvec3> line = points_;
    if (cursor_ && !points_.empty() && glm::distance(points_.back(), *cursor_) >= samePointM)
        line.push_back(*cursor_);
    return line;
}

}  // namespace noonmark
