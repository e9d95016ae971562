#include "core/city/trees/tree.h"

#include <fmt/format.h>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <utility>

#include "core/base/safe_text.h"
#include "core/describe/choice.h"
#include "core/sun/civil_time.h"

namespace noonmark {

namespace {

constexpr std::array crownShapeNames{Choice{CrownShape::ellipsoid, "ellipsoid"},
                                     Choice{CrownShape::cone, "cone"},
                                     Choice{CrownShape::cylinder, "cylinder"}};
constexpr std::array treeSourceNames{
    Choice{TreeSource::measured, "measured"}, Choice{TreeSource::estimated, "estimated"},
    Choice{TreeSource::assumed, "assumed"}, Choice{TreeSource::designed, "designed"}};

}  // namespace

std::string_view nameOf(CrownShape shape) { return keyOf<CrownShape>(crownShapeNames, shape); }
std::optional<CrownShape> parseCrownShape(std::string_view name) {
    return findChoice<CrownShape>(crownShapeNames, name);
}

std::string_view nameOf(TreeSource source) { return keyOf<TreeSource>(treeSourceNames, source); }
std::optional<TreeSource> parseTreeSource(std::string_view name) {
    return findChoice<TreeSource>(treeSourceNames, name);
}

namespace {

constexpr std::chrono::year commonYear{2026};

std::chrono::sys_days newYear() { return commonYear / std::chrono::January / 1; }

}  // namespace

Result<int> parseDayOfYear(std::string_view text) {
    const auto date = parseDate(fmt::format("{}-{}", int(commonYear), text));
    if (!date) return failure("This is no day of the year", std::string(text), "Give MM-DD: 04-15");
    return dayOfCommonYear(*date);
}

std::string formatDayOfYear(const int& dayOfYear) {
    const std::chrono::year_month_day date(newYear() + std::chrono::days(std::clamp(dayOfYear, 1, 365) - 1));
    return fmt::format("{:02}-{:02}", unsigned(date.month()), unsigned(date.day()));
}

LeafDays leafDaysOf(const Tree& tree, const LeafDays& ofCity) {
    return {tree.leafOnDay.value_or(ofCity.on), tree.leafOffDay.value_or(ofCity.off)};
}

std::uint32_t LeafSeasons::of(const Tree& tree) const {
    const LeafDays days = leafDaysOf(tree, days_.front());
    const auto found = numbers_.find({days.on, days.off});
    return tree.evergreen || found == numbers_.end() ? 0 : found->second;
}

std::uint32_t LeafSeasons::add(const Tree& tree) {
    const LeafDays days = leafDaysOf(tree, days_.front());
    if (tree.evergreen || days == days_.front()) return 0;
    const auto [found, isNew] = numbers_.try_emplace({days.on, days.off}, std::uint32_t(days_.size()));
    if (isNew) days_.push_back(days);
    return found->second;
}

Warning makeTreeWarning(std::string where, std::string_view why) {
    return {WarningKind::leftOut, fmt::format("trees: {}", why), std::move(where)};
}

Warnings warnOfTrees(const std::shared_ptr<const Trees>& trees, std::string_view why) {
    if (!trees || trees->trees.empty()) return {};
    const std::size_t count = trees->trees.size();
    return {makeTreeWarning(countOf(count, "tree"), why)};
}

namespace {

constexpr double pi = std::numbers::pi;

double surfaceOfSpheroid(double a, double c) {
    if (std::abs(a - c) < 1e-9 * a) return 4 * pi * a * a;
    if (c < a) {
        const double e = std::sqrt(1 - c * c / (a * a));
        return 2 * pi * a * a * (1 + (1 - e * e) / e * std::atanh(e));
    }
    const double e = std::sqrt(1 - a * a / (c * c));
    return 2 * pi * a * a * (1 + c / (a * e) * std::asin(e));
}

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr LinePart nowhere{0, 0};

void clip(LinePart& part, double low, double high) {
    part.enter = std::max(part.enter, low);
    part.leave = std::min(part.leave, high);
}

// Scaled to a unit sphere; by the point nearest to its centre, which keeps its digits however far away the
// origin is.
LinePart partInEllipsoid(const Crown& crown, glm::dvec3 fromAxis, glm::dvec3 direction) {
    const double half = (crown.topM - crown.bottomM) / 2;
    const glm::dvec3 scale(1 / crown.radiusM, 1 / crown.radiusM, 1 / half);
    const glm::dvec3 d = direction * scale, o = (fromAxis - glm::dvec3(0, 0, half)) * scale;
    const double square = glm::dot(d, d), nearest = -glm::dot(o, d) / square;
    const glm::dvec3 offset = o + nearest * d;
    const double inside = 1 - glm::dot(offset, offset);
    if (inside <= 0) return nowhere;
    const double reach = std::sqrt(inside / square);
    return {nearest - reach, nearest + reach};
}

// Between the levels of a crown's bottom and top.
LinePart partInSlab(double heightM, double aboveBottom, double rise) {
    const double atBottom = -aboveBottom / rise, atTop = (heightM - aboveBottom) / rise;
    if (rise > 0) return {atBottom, atTop};
    if (rise < 0) return {atTop, atBottom};
    return aboveBottom < 0 || aboveBottom > heightM ? nowhere : LinePart{-infinity, infinity};
}

LinePart partInCylinder(const Crown& crown, glm::dvec3 o, glm::dvec3 d) {
    LinePart part = partInSlab(crown.topM - crown.bottomM, o.z, d.z);
    const double square = d.x * d.x + d.y * d.y;
    if (square < 1e-24) return std::hypot(o.x, o.y) < crown.radiusM ? part : nowhere;
    const double nearest = -(o.x * d.x + o.y * d.y) / square;
    const double x = o.x + nearest * d.x, y = o.y + nearest * d.y;
    const double inside = crown.radiusM * crown.radiusM - x * x - y * y;
    if (inside <= 0) return nowhere;
    const double reach = std::sqrt(inside / square);
    clip(part, nearest - reach, nearest + reach);
    return part;
}

// Inside where x2 + y2 <= (slope x depth below the apex)2: a t2 + 2 b t + c <= 0. A line steeper than the
// cone has one end of its part below the apex, the other in the cone above it, which is none of the crown's.
LinePart partInCone(const Crown& crown, glm::dvec3 o, glm::dvec3 d) {
    const double heightM = crown.topM - crown.bottomM, slope = crown.radiusM / heightM;
    LinePart part = partInSlab(heightM, o.z, d.z);
    const double depth = heightM - o.z, square = slope * slope;
    const double a = d.x * d.x + d.y * d.y - square * d.z * d.z;
    const double b = o.x * d.x + o.y * d.y + square * depth * d.z;
    const double c = o.x * o.x + o.y * o.y - square * depth * depth;
    if (std::abs(a) < 1e-12) {
        if (b > 0) clip(part, -infinity, -c / (2 * b));
        if (b < 0) clip(part, -c / (2 * b), infinity);
        return b == 0 && c > 0 ? nowhere : part;
    }
    const double discriminant = b * b - a * c;
    if (a > 0 && discriminant <= 0) return nowhere;
    const double root = std::sqrt(std::max(0.0, discriminant));
    const double first = (-b - root) / a, second = (-b + root) / a;  // second < first if a < 0
    if (a > 0)
        clip(part, first, second);
    else if (d.z > 0)
        clip(part, -infinity, second);
    else
        clip(part, first, infinity);
    return part;
}

}  // namespace

double computeMeanChord(CrownShape shape, double radiusM, double heightM) {
    const double r = radiusM, h = heightM, disc = pi * r * r;
    switch (shape) {
        case CrownShape::ellipsoid:
            return 4 * (disc * h * 2 / 3) / surfaceOfSpheroid(r, h / 2);
        case CrownShape::cone:
            return 4 * (disc * h / 3) / (disc + pi * r * std::hypot(r, h));
        case CrownShape::cylinder:
            return 4 * (disc * h) / (2 * disc + 2 * pi * r * h);
    }
    return 0;
}

Crown makeCrown(const Tree& tree) {
    Crown crown{.x = tree.place.x,
                .y = tree.place.y,
                .bottomM = double(tree.groundM) + double(tree.crownBaseM),
                .topM = double(tree.groundM) + double(tree.heightM),
                .radiusM = double(tree.crownDiameterM) / 2,
                .shape = tree.shape};
    constexpr double darkest = 1e-6;  // a crown that lets nothing through still has a finite depth
    const double chord = computeMeanChord(crown.shape, crown.radiusM, crown.topM - crown.bottomM);
    const auto perMetre = [&](float share) { return -std::log(std::max(double(share), darkest)) / chord; };
    crown.leafOnPerM = perMetre(tree.leafOnTransmissivity);
    crown.leafOffPerM = tree.evergreen ? crown.leafOnPerM : perMetre(tree.leafOffTransmissivity);
    return crown;
}

LinePart findLinePart(const Crown& crown, glm::dvec3 origin, glm::dvec3 direction) {
    const glm::dvec3 fromAxis(origin.x - crown.x, origin.y - crown.y, origin.z - crown.bottomM);
    switch (crown.shape) {
        case CrownShape::ellipsoid:
            return partInEllipsoid(crown, fromAxis, direction);
        case CrownShape::cone:
            return partInCone(crown, fromAxis, direction);
        case CrownShape::cylinder:
            return partInCylinder(crown, fromAxis, direction);
    }
    return nowhere;
}

glm::dvec3 normalAt(const Crown& crown, glm::dvec3 point) {
    const double x = point.x - crown.x, y = point.y - crown.y, heightM = crown.topM - crown.bottomM;
    const double r = crown.radiusM, half = heightM / 2;
    if (crown.shape == CrownShape::ellipsoid)
        return {x / (r * r), y / (r * r), (point.z - crown.bottomM - half) / (half * half)};
    constexpr double onLevel = 1e-6;  // of the height
    if (point.z < crown.bottomM + onLevel * heightM) return {0, 0, -1};
    if (crown.shape == CrownShape::cone) return {x, y, r * r / (heightM * heightM) * (crown.topM - point.z)};
    return point.z > crown.topM - onLevel * heightM ? glm::dvec3(0, 0, 1) : glm::dvec3(x, y, 0);
}

double computeChord(const Crown& crown, glm::dvec3 origin, glm::dvec3 direction) {
    const LinePart part = findLinePart(crown, origin, direction);
    return std::max(0.0, part.leave - std::max(0.0, part.enter));
}

}  // namespace noonmark
