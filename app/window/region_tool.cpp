#include "app/window/region_tool.h"

#include <glm/geometric.hpp>

#include "core/city/repair_footprint.h"

namespace noonmark {

namespace {

// A double click sends its place twice; so does a trembling hand.
constexpr float samePlaceM = 0.05F;

RawRing ringOf(const std::vector<glm::vec3>& points) {
    RawRing ring;
    for (const glm::vec3 point : points) ring.emplace_back(double(point.x), double(point.y));
    return ring;
}

}  // namespace

void RegionTool::begin() {
    points_.clear();
    cursor_.reset();
    active_ = true;
    Q_EMIT activeChanged(true);
    Q_EMIT lineChanged();
}

void RegionTool::addPoint(glm::dvec3 ground) {
    if (!active_) return;
    const glm::vec3 point(ground);
    if (!points_.empty() && glm::distance(points_.back(), point) < samePlaceM) return;
    points_.push_back(point);
    Q_EMIT lineChanged();
}

void RegionTool::moveTo(glm::dvec3 ground) {
    if (!active_ || points_.empty()) return;
    cursor_ = glm::vec3(ground);
    Q_EMIT lineChanged();
}

void RegionTool::removeLastPoint() {
    if (!active_ || points_.empty()) return;
    points_.pop_back();
    Q_EMIT lineChanged();
}

void RegionTool::finish() {
    if (!active_) return;
    if (points_.size() < 3)
        return Q_EMIT refused(
            {"A region needs three corners or more", {}, "Click more corners, or press Esc"});
    const RepairedFootprint repaired = repairFootprint({ringOf(points_)});
    if (repaired.pieces.empty())
        return Q_EMIT refused(
            {"The polygon has no inside", {}, "Draw it again with more room between its corners"});
    end();
    Q_EMIT finished(Region{"drawn on the ground", repaired.pieces});
}

void RegionTool::cancel() {
    if (active_) end();
}

void RegionTool::end() {
    active_ = false;
    points_.clear();
    cursor_.reset();
    Q_EMIT activeChanged(false);
    Q_EMIT lineChanged();
}

std::vector<glm::vec3> RegionTool::line() const {
    std::vector<glm::vec3> line = points_;
    if (cursor_ && !points_.empty()) line.push_back(*cursor_);
    return line;
}

}  // namespace noonmark
