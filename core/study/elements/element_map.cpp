#include "core/study/elements/element_map.h"

#include <cmath>
#include <set>

#include "core/receivers/points/glazing_pane.h"

namespace noonmark {

namespace {

void addBuilding(MeasuredElement& measured, const ElementStudy& study, const PointElement& element) {
    const bool onWall = element.kind == ElementKind::facade || element.kind == ElementKind::window;
    if (onWall) measured.floor = element.floor;
    if (element.building >= study.city.buildings.size()) return;
    measured.building = study.city.buildings[element.building]->sourceId;
    measured.buildingName = study.city.buildings[element.building]->name;
}

// `all`: without trees or with them.
void addMinutes(ElementMinutes& measured, const ElementStudy& study, const PointMonths& all,
                std::size_t point, const std::set<unsigned>& months) {
    const auto days = double(study.sun.dayCount());
    measured.sunlitMin = all.sunlitOf(point) / days;
    measured.grossMin = (all.possibleMin - all.sunlitOf(point)) / days;
    measured.continuousMin = double(all.longestShadowMin[point]);
    measured.longestSunMin = double(all.longestSunMin[point]);
    measured.monthMin.fill(std::nan(""));
    for (const unsigned month : months)
        measured.monthMin[month - 1] = double(all.sunlitMin[point][month - 1]);
}

void addTrees(MeasuredElement& measured, const ElementStudy& study, std::size_t point,
              const std::set<unsigned>& months) {
    if (!study.trees) return;
    for (const TreeColumns column : {TreeColumns::evergreen, TreeColumns::seasonal})
        if (const auto& all = study.trees->of(column)) {
            ShadedMinutes& with = measured.withTrees.emplace_back();
            with.column = column;
            addMinutes(with, study, *all, point, months);
        }
}

MeasuredElement measureElement(const ElementStudy& study, std::size_t point,
                               const std::set<unsigned>& months) {
    const PointElement& element = study.receivers.elements[point];
    MeasuredElement measured{.id = element.id,
                             .kind = element.kind,
                             .position = study.receivers.points.positions[point],
                             .normal = study.receivers.points.normals[point],
                             .pane = study.receivers.panes[point]};
    const LonLat place = study.city.frame.lonLatFromLocal(glm::dvec2(measured.position));
    measured.azimuthDeg = facingAzimuthDeg(study.city.frame, place, measured.normal);
    addBuilding(measured, study, element);
    addMinutes(measured, study, study.minutes, point, months);
    addTrees(measured, study, point, months);
    return measured;
}

}  // namespace

std::array<glm::vec3, 4> cornersOf(const MeasuredElement& element) {
    return computePaneCorners(glm::dvec3(element.position), glm::dvec3(element.normal),
                              element.pane.isKnown() ? element.pane : defaultPane);
}

ElementMap makeElementMap(const ElementStudy& study) {
    std::set<unsigned> months;
    for (const SunDay& day : study.sun.days) months.insert(unsigned(day.date.month()));
    ElementMap map;
    map.possibleMin = study.minutes.possibleMin / double(study.sun.dayCount());
    map.elements.reserve(study.receivers.size());
    for (std::size_t point = 0; point < study.receivers.size(); ++point)
        map.elements.push_back(measureElement(study, point, months));
    return map;
}

std::optional<ElementMap> inColumn(const ElementMap& map, TreeColumns column) {
    ElementMap made = map;
    made.column = column;
    for (MeasuredElement& element : made.elements) {
        const auto with = std::ranges::find(element.withTrees, column, &ShadedMinutes::column);
        if (with == element.withTrees.end()) return std::nullopt;
        static_cast<ElementMinutes&>(element) = *with;
        element.withTrees.clear();
    }
    return made.elements.empty() ? std::nullopt : std::optional(std::move(made));
}

}  // namespace noonmark
