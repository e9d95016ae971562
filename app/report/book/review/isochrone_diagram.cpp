#include <algorithm>
#include <array>
#include <cmath>

#include "app/report/book/review/review_pages.h"
#include "app/report/sheets/study_words.h"
#include "core/engines/ray/ray_reference.h"
#include "core/measures/outlines/isochrones.h"
#include "core/receivers/line_belts.h"
#include "core/receivers/receivers.h"
#include "core/sun/chosen_days.h"

namespace noonmark {

namespace {

constexpr float aroundM = 120;  // shown around what changes
constexpr double fewCells = 90'000;

/// Everywhere in the box, on the ground or on the rule's plane above its mean, whatever stands there.
Result<Receivers> placeEverywhere(const ReviewScene& scene, const Box2& box, const std::stop_token& stop) {
    const glm::dvec2 size(box.high - box.low);
    const double cellM = std::clamp(std::sqrt(size.x * size.y / fewCells), 0.5, 10.0);
    const City ground{scene.after.frame, {}, scene.after.terrain};
    auto receivers = placeReceiversOnGround(ground, makeRegionFromLocalBox(box), {.cellM = cellM}, stop);
    const RuleReceivers& rule = scene.source.study.rule.receivers;
    if (!receivers || rule.surface != RuleSurface::plane || receivers->cells.empty()) return receivers;
    double sum = 0;
    for (const std::uint32_t cell : receivers->cells) sum += receivers->position(cell).z;
    const double mean = sum / double(receivers->cells.size());
    receivers->groundM.assign(receivers->grid.size(), float(mean + rule.planeM));
    return receivers;
}

/// Each full hour, and the limits of the rule.
std::vector<double> levelsOf(const Rule& rule) {
    std::vector<double> levels;
    for (int hour = 1; hour <= 8; ++hour) levels.push_back(60.0 * hour);
    for (const Criterion& criterion : rule.criteria)
        for (const Limit& limit : criterion.limits)
            if (criterion.measure == Measure::spotTotal && !limit.ofFormer) levels.push_back(limit.value);
    std::ranges::sort(levels);
    levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
    return levels;
}

std::vector<glm::dvec2> pointsOf(const std::vector<glm::vec2>& points, bool isClosed) {
    std::vector<glm::dvec2> line(points.begin(), points.end());
    if (isClosed && !line.empty()) line.push_back(line.front());
    return line;
}

std::vector<ValueLine> hourLines(const ShadowField& field, const std::vector<double>& levels) {
    std::vector<ValueLine> values;
    for (const double level : levels)
        values.push_back({describeAmount(level / 60, 2) + QStringLiteral(" h"), false, {}});
    for (const Isochrone& line : traceIsochrones(field.grid, field.grossMin, levels)) {
        const auto at = std::ranges::find(levels, line.level) - levels.begin();
        if (std::size_t(at) < values.size())
            values[std::size_t(at)].lines.push_back(pointsOf(line.points, line.closed));
    }
    return values;
}

/// The lines at the rule's distances from the parcels.
void addDistances(const ReviewScene& scene, std::vector<ValueLine>& values) {
    const RuleReceivers& rule = scene.source.study.rule.receivers;
    if (!rule.hasLines()) return;
    for (const double distance : {rule.innerLineM, rule.outerLineM}) {
        ValueLine value{describeAmount(distance, 1) + QStringLiteral(" m"), true, {}};
        for (const Place& parcel : scene.diagrams->places)
            if (const auto belt = cutBelt(parcel.polygons, 0, distance))
                for (const Footprint& polygon : *belt) value.lines.push_back(pointsOf(polygon.outer, true));
        values.push_back(std::move(value));
    }
}

}  // namespace

Result<Diagram> makeIsochrones(const ReviewScene& scene, std::size_t day, const QRectF& area,
                               const std::stop_token& stop) {
    Box2 box = focusOf(scene, {});
    box = {box.low - aroundM, box.high + aroundM};
    const double scale = textScale(scene.settings.setup);
    const DiagramLayout layout = fitInto(area, scale, box);
    const auto receivers = placeEverywhere(scene, box, stop);
    if (!receivers) return tl::make_unexpected(receivers.error());
    const SunSteps sun = chooseDays(scene.sun.sun, std::array{day});
    NoProgress progress;
    const auto field = RayReference().accumulate(scene.after, *receivers, sun, progress, stop);
    if (!field) return tl::make_unexpected(field.error());
    Diagram diagram{scene.diagrams, {},           {}, hourLines(*field, levelsOf(scene.source.study.rule)),
                    layout.centre,  layout.scale, {}, scale};
    addDistances(scene, diagram.valueLines);
    const RuleReceivers& rule = scene.source.study.rule.receivers;
    const QString where =
        rule.surface == RuleSurface::plane
            ? QStringLiteral("on a plane %1 m above the mean ground").arg(describeAmount(rule.planeM, 2))
            : QStringLiteral("on the ground");
    diagram.caption = {dayText(scene.sun.sun.days[day].date),
                       QStringLiteral("Hours of shadow in the rule's hours, %1; rays on cells of %2 m")
                           .arg(where, describeAmount(field->grid.cellM, 2))};
    return diagram;
}

}  // namespace noonmark
