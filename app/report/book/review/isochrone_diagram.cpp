#include <algorithm>
#include <array>
#include <optional>

#include "app/report/book/review/review_pages.h"
#include "app/report/maps/sheet_text.h"
#include "app/report/sheets/study_text.h"
#include "core/measures/outlines/day_isochrones.h"
#include "core/receivers/parcels/parcel_lines.h"
#include "core/review/rule/rule_days.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

namespace {

constexpr float aroundM = 20;  // shown around what changes and the lines

std::vector<glm::dvec2> pointsOf(const std::vector<glm::vec2>& points, bool isClosed) {
    std::vector<glm::dvec2> line(points.begin(), points.end());
    if (isClosed && !line.empty()) line.push_back(line.front());
    return line;
}

std::vector<ValueLine> hourLines(const std::vector<Isochrone>& lines, const std::vector<double>& levels,
                                 const std::vector<double>& limits) {
    std::vector<ValueLine> values;
    for (const double level : levels)
        values.push_back({describeAmount(level / 60, 2) + QStringLiteral(" h"),
                          false,
                          {},
                          std::ranges::find(limits, level) != limits.end()});
    for (const Isochrone& line : lines) {
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

Result<DayIsochrones> trace(const ReviewScene& scene, std::size_t day, const Box2& box,
                            const std::stop_token& stop) {
    const Rule& rule = scene.source.study.rule;
    NoProgress progress;
    return traceDayIsochrones(scene.after, chooseDays(scene.sun.sun, std::array{day}),
                              {box, listIsochroneMinutes(rule), planeOf(rule)}, progress, stop);
}

/// What changes and all lines: those of few hours end far from the building. They are found on coarser cells,
/// as far as shadows reach.
Result<Box2> findExtent(const ReviewScene& scene, std::size_t day, const std::stop_token& stop) {
    return trace(scene, day, reachOf(scene, scene.moments), stop).map([&](const DayIsochrones& coarse) {
        Box2 box = focusOf(scene, {});
        for (const Isochrone& line : coarse.lines)
            for (const glm::vec2 point : line.points) box.add(point);
        return Box2{box.low - aroundM, box.high + aroundM};
    });
}

}  // namespace

Result<Diagram> makeIsochrones(const ReviewScene& scene, std::size_t day, const QRectF& area,
                               const std::stop_token& stop) {
    const auto box = findExtent(scene, day, stop);
    if (!box) return tl::make_unexpected(box.error());
    const double scale = textScale(scene.settings.setup);
    const DiagramLayout layout = fitInto(area, scale, *box);
    const Rule& rule = scene.source.study.rule;
    const auto planeM = planeOf(rule);
    const std::vector<double> levels = listIsochroneMinutes(rule);
    const auto isochrones = trace(scene, day, *box, stop);
    if (!isochrones) return tl::make_unexpected(isochrones.error());
    Diagram diagram{
        scene.diagrams, {},           {}, hourLines(isochrones->lines, levels, listLimitMinutes(rule)),
        layout.centre,  layout.scale, {}, scale};
    addDistances(scene, diagram.valueLines);
    const QString where =
        planeM ? sheetText("on a plane %1 m above the mean ground").arg(describeAmount(*planeM, 2))
               : sheetText("on the ground");
    diagram.caption = {dayText(scene.sun.sun.days[day].date),
                       sheetText("Hours of shadow in the rule's hours, %1, on cells of %2 m")
                           .arg(where, describeAmount(isochrones->cellM, 2))};
    return diagram;
}

}  // namespace noonmark
