#include "core/review/glazing/glazing_points.h"

#include <algorithm>
#include <numbers>

namespace noonmark {

namespace {

constexpr double degree = std::numbers::pi / 180;

PanePoint pointAt(const SkyPoint& middle, const PaneSize& pane, glm::dvec2 place) {
    const PaneAxes axes = findPaneAxes(glm::dvec3(middle.normal));
    const glm::dvec3 position = glm::dvec3(middle.position) + place.x * axes.along + place.y * axes.up;
    return {{glm::vec3(position), middle.normal}, pane.low - place, pane.high - place};
}

}  // namespace

PaneSize sizeOrOpening(const RuleGlazing& rule, PaneSize pane) {
    if (pane.isKnown()) return pane;
    const glm::dvec2 half(rule.opening.widthM / 2, rule.opening.heightM / 2);
    return {-half, half};
}

std::vector<PanePoint> placePanePoints(const RuleGlazing& rule, const SkyPoint& middle, PaneSize pane) {
    pane = sizeOrOpening(rule, pane);
    if (rule.point.place == PanePlace::middle) return {pointAt(middle, pane, (pane.low + pane.high) / 2.0)};
    const double wanted = std::max(rule.point.aboveSillM, rule.point.aboveFloorM - rule.opening.sillM);
    const double up = std::clamp(pane.low.y + wanted, pane.low.y, pane.high.y);
    if (rule.point.place == PanePlace::sillMiddle)
        return {pointAt(middle, pane, {(pane.low.x + pane.high.x) / 2, up})};
    return {pointAt(middle, pane, {pane.low.x, up}), pointAt(middle, pane, {pane.high.x, up})};
}

PaneLimits::PaneLimits(const RuleGlazing& rule, const PanePoint& point, PaneSize pane)
    : normal_(point.point.normal),
      axes_(findPaneAxes(normal_)),
      low_(point.low),
      high_(point.high),
      depthM_(rule.point.insideFace ? rule.opening.wallM : 0) {
    const double widthM = sizeOrOpening(rule, pane).widthM();
    const double ofOpening = rule.sweepOfOpening ? std::atan(rule.opening.wallM / widthM) : 0;
    minSweepSine_ = std::sin(std::max(rule.minSweepDeg * degree, ofOpening));
}

bool PaneLimits::lets(glm::dvec3 sun) const {
    const double towards = glm::dot(sun, normal_);
    if (towards <= 0) return false;
    const double level = std::hypot(normal_.x, normal_.y), sunLevel = std::hypot(sun.x, sun.y);
    if (minSweepSine_ > 0 && level > 1e-3) {
        const double sine = (sun.x * normal_.x + sun.y * normal_.y) / (level * std::max(sunLevel, 1e-12));
        if (sine < minSweepSine_ && sunLevel > 1e-6) return false;
    }
    if (depthM_ <= 0) return true;
    const double along = depthM_ * glm::dot(sun, axes_.along) / towards;
    const double up = depthM_ * glm::dot(sun, axes_.up) / towards;
    return along >= low_.x && along <= high_.x && up >= low_.y && up <= high_.y;
}

}  // namespace noonmark
