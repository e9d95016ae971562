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

/// A part of a ray, in metres from its origin.
struct RayPart {
    double from = 0, to = std::numeric_limits<double>::infinity();
    [[nodiscard]] double length() const { return std::max(0.0, to - from); }
    void clip(double low, double high) {
        from = std::max(from, low);
        to = std::min(to, high);
    }
};

constexpr RayPart nowhere{0, 0};

// Scaled to a unit sphere; by the point nearest to its centre, which keeps its digits however far away the
// origin is.
RayPart partInEllipsoid(const Crown& crown, glm::dvec3 fromAxis, glm::dvec3 direction) {
    const double half = (crown.topM - crown.bottomM) / 2;
    const glm::dvec3 scale(1 / crown.radiusM, 1 / crown.radiusM, 1 / half);
    const glm::dvec3 d = direction * scale, o = (fromAxis - glm::dvec3(0, 0, half)) * scale;
    const double square = glm::dot(d, d), nearest = -glm::dot(o, d) / square;
    const glm::dvec3 offset = o + nearest * d;
    const double inside = 1 - glm::dot(offset, offset);
    if (inside <= 0) return nowhere;
    const double reach = std::sqrt(inside / square);
    RayPart part;
    part.clip(nearest - reach, nearest + reach);
    return part;
}

// Between the levels of a crown's bottom and top.
RayPart partInSlab(double heightM, double aboveBottom, double rise) {
    RayPart part;
    if (rise > 0)
        part.clip(-aboveBottom / rise, (heightM - aboveBottom) / rise);
    else if (aboveBottom < 0 || aboveBottom > heightM)
        return nowhere;
    return part;
}

RayPart partInCylinder(const Crown& crown, glm::dvec3 o, glm::dvec3 d) {
    RayPart part = partInSlab(crown.topM - crown.bottomM, o.z, d.z);
    const double square = d.x * d.x + d.y * d.y;
    if (square < 1e-24) return std::hypot(o.x, o.y) < crown.radiusM ? part : nowhere;
    const double nearest = -(o.x * d.x + o.y * d.y) / square;
    const double x = o.x + nearest * d.x, y = o.y + nearest * d.y;
    const double inside = crown.radiusM * crown.radiusM - x * x - y * y;
    if (inside <= 0) return nowhere;
    const double reach = std::sqrt(inside / square);
    part.clip(nearest - reach, nearest + reach);
    return part;
}

// Inside where x2 + y2 <= (slope x depth below the apex)2: a t2 + 2 b t + c <= 0. A ray steeper than the cone
// is inside up to where it leaves below the apex.
RayPart partInCone(const Crown& crown, glm::dvec3 o, glm::dvec3 d) {
    const double heightM = crown.topM - crown.bottomM, slope = crown.radiusM / heightM;
    RayPart part = partInSlab(heightM, o.z, d.z);
    const double depth = heightM - o.z, square = slope * slope;
    const double a = d.x * d.x + d.y * d.y - square * d.z * d.z;
    const double b = o.x * d.x + o.y * d.y + square * depth * d.z;
    const double c = o.x * o.x + o.y * o.y - square * depth * depth;
    if (std::abs(a) < 1e-12) {
        if (b > 0) part.clip(-std::numeric_limits<double>::infinity(), -c / (2 * b));
        if (b < 0) part.clip(-c / (2 * b), std::numeric_limits<double>::infinity());
        return b == 0 && c > 0 ? nowhere : part;
    }
    const double discriminant = b * b - a * c;
    if (a > 0 && discriminant <= 0) return nowhere;
    const double root = std::sqrt(std::max(0.0, discriminant));
    if (a > 0)
        part.clip((-b - root) / a, (-b + root) / a);
    else
        part.clip(-std::numeric_limits<double>::infinity(), (-b + root) / a);
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

double computeChord(const Crown& crown, glm::dvec3 origin, glm::dvec3 direction) {
    const glm::dvec3 fromAxis(origin.x - crown.x, origin.y - crown.y, origin.z - crown.bottomM);
    switch (crown.shape) {
        case CrownShape::ellipsoid:
            return partInEllipsoid(crown, fromAxis, direction).length();
        case CrownShape::cone:
            return partInCone(crown, fromAxis, direction).length();
        case CrownShape::cylinder:
            return partInCylinder(crown, fromAxis, direction).length();
    }
    return 0;
}

}  // namespace noonmark
