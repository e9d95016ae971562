#include "app/report/book/review/glazing_book.h"

#include <algorithm>
#include <array>
#include <map>

#include "app/report/book/elevation_pages.h"
#include "app/report/book/review/review_pages.h"
#include "app/report/book/sun_view.h"
#include "app/report/maps/sheet_text.h"
#include "core/describe/text.h"
#include "core/measures/places/place_run.h"
#include "core/review/rule/rule_days.h"
#include "core/study/glazing/glazing_text.h"

namespace noonmark {

namespace {

/// The windows of a building, as indices of GlazingStudy::panes.
struct PanesOfBuilding {
    std::uint32_t building = 0;
    std::vector<std::size_t> panes;
    std::size_t worse = 0, fail = 0, borderline = 0;
};

/// The buildings whose verdicts matter most first.
std::vector<PanesOfBuilding> groupPanes(const GlazingStudy& study) {
    std::map<std::uint32_t, PanesOfBuilding> byBuilding;
    for (std::size_t i = 0; i < study.panes.size(); ++i) {
        if (!hasElevation(study.panes[i].pane)) continue;
        const std::uint32_t building = study.panes[i].building;
        PanesOfBuilding& group =
            byBuilding.try_emplace(building, PanesOfBuilding{building, {}}).first->second;
        group.panes.push_back(i);
        const GlazingReview& review = study.windows[study.panes[i].window];
        group.worse += isWorse(review.formerVerdict, review.verdict) ? 1 : 0;
        group.fail += review.verdict == Verdict::fail ? 1 : 0;
        group.borderline += review.verdict == Verdict::borderline ? 1 : 0;
    }
    std::vector<PanesOfBuilding> groups;
    for (auto& [building, group] : byBuilding) groups.push_back(std::move(group));
    std::ranges::stable_sort(groups, [](const PanesOfBuilding& a, const PanesOfBuilding& b) {
        return std::tuple(a.worse, a.fail, a.borderline) > std::tuple(b.worse, b.fail, b.borderline);
    });
    return groups;
}

QColor sunColour(const std::optional<double>& value, const Legend& legend) {
    return value ? toColour(legend.colours->colourOf(*value)) : ink::line;
}

ElevationMark markOf(Verdict verdict) {
    if (verdict == Verdict::fail) return ElevationMark::fail;
    return verdict == Verdict::borderline ? ElevationMark::borderline : ElevationMark::none;
}

ElevationCell changeCell(const GlazingReview& review, const std::optional<double>& before,
                         const std::optional<double>& after, const Legend& legend) {
    ElevationCell cell{ink::line};
    if (before && after) cell.colour = toColour(legend.colours->colourOf(*after - *before));
    if (isWorse(review.formerVerdict, review.verdict)) cell.mark = ElevationMark::worse;
    if (isWorse(review.verdict, review.formerVerdict)) cell.mark = ElevationMark::better;
    return cell;
}

QString nameOfBuilding(const GlazingStudy& study, const PanesOfBuilding& group) {
    const ReviewedGlazing& window = study.windows[study.panes[group.panes.front()].window].window;
    const std::string& name = window.buildingName.empty() ? window.building : window.buildingName;
    return name.empty() ? sheetText("Windows at no building") : plainText(name);
}

/// Of a measure and of its change.
struct GlazingLegends {
    Legend value, change;
};

ElevationBuilding makeBuilding(const GlazingBookSource& source, const GlazingMeasure& measure,
                               const GlazingLegends& legends, const PanesOfBuilding& group) {
    const GlazingStudy& study = source.study;
    ElevationBuilding building{nameOfBuilding(study, group), nullptr, {}, {{}, {}, {}}, {}};
    if (group.building < source.scenario.buildings.size()) {
        const ElementSettings& elements = study.settings.elements;
        building.building = source.scenario.buildings[group.building].get();
        building.storeyM = findStoreyM(*building.building, elements.facades, elements.parts.storeys);
    }
    bool hasFormer = false;
    for (const std::size_t index : group.panes) {
        const ReviewedPane& pane = study.panes[index];
        const GlazingReview& review = study.windows[pane.window];
        const auto before = shownValue(study.rule, measure, review, true);
        const auto after = shownValue(study.rule, measure, review, false);
        hasFormer = hasFormer || before;
        building.panes.push_back(pane.pane);
        building.cells[0].push_back({sunColour(before, legends.value), markOf(review.formerVerdict)});
        building.cells[1].push_back({sunColour(after, legends.value), markOf(review.verdict)});
        building.cells[2].push_back(changeCell(review, before, after, legends.change));
    }
    if (hasFormer) return building;
    building.cells[0].clear(), building.cells[2].clear();
    building.notes = {sheetText("The building is new or changed"), {}, sheetText("No former values")};
    return building;
}

Legend legendOf(const GlazingMeasure& measure, const LegendChoice& choice, bool isChange) {
    Legend legend;
    legend.title = isChange ? sheetText("Change") : sheetText(measure.title);
    legend.unit = sheetText(measure.unit) + sheetText(", scale locked");
    legend.scale = isChange ? measure.changeScale : measure.scale;
    legend.change = isChange;
    legend.colours = makeWantedScale(choice, legend.scale, isChange);
    return legend;
}

std::vector<BookPage> makePagesOf(const GlazingBookSource& source, const BookSettings& settings,
                                  const GlazingMeasure& measure, const std::vector<PanesOfBuilding>& groups,
                                  std::size_t maxPages) {
    const GlazingStudy& study = source.study;
    const GlazingLegends legends{legendOf(measure, settings.legend, false),
                                 legendOf(measure, settings.legend, true)};
    ElevationSheets sheets{
        sheetText("Elevations: ") + sheetText(measure.title),
        sheetText("%1 and %2. %3. Colours beyond the ends of a scale are "
                  "those of its ends.")
            .arg(scenarioText(source.labels.from), scenarioText(source.labels.to),
                 describeFloors(study.settings.elements)),
        sheetText("Elevations: ") + sheetText(measure.title),
        {scenarioText(source.labels.from), scenarioText(source.labels.to), sheetText("Change")},
        {{legends.value, legends.change}},
        source.scenario.frame,
        maxPages};
    sheets.scale = settings.scale;
    sheets.foot.note = sheetText("Grey: no value. Seen square to the wall, from outside.");
    // Each side takes a quarter of a page at least: more buildings cannot be drawn.
    std::vector<ElevationBuilding> buildings;
    for (const PanesOfBuilding& group : groups) {
        if (buildings.size() > 4 * maxPages) {
            buildings.push_back({nameOfBuilding(study, group), nullptr, {}, {}, {}});
            continue;
        }
        buildings.push_back(makeBuilding(source, measure, legends, group));
    }
    return makeElevationPages(settings.setup, std::move(sheets), buildings);
}

}  // namespace

std::vector<BookPage> makeGlazingElevations(const GlazingBookSource& source, const BookSettings& settings) {
    const std::vector<PanesOfBuilding> groups = groupPanes(source.study);
    std::vector<BookPage> pages;
    const auto measures = listGlazingMeasures(source.study.rule);
    const std::size_t maxPages = settings.allPages
                                     ? maxElevationPages
                                     : defaultElevationPages / std::max<std::size_t>(1, measures.size());
    for (const GlazingMeasure& measure : measures)
        for (BookPage& page : makePagesOf(source, settings, measure, groups, maxPages))
            pages.push_back(std::move(page));
    return pages;
}

namespace {

constexpr double viewDpi = 160;
constexpr double maxViewPixels = 1400;
constexpr float nearM = 200, besideM = 25;  // windows and ground shown around what changes

/// The ground that the views show.
Box2 groundOf(const GlazingBookSource& source, const City& proposal, const City& removed) {
    Box2 box;
    for (const City* city : {&proposal, &removed})
        for (const auto& building : city->buildings) box.add(bounds(*building));
    const Box2 changed = box;
    for (const ReviewedPane& pane : source.study.panes) {
        const glm::vec2 at(glm::dvec2(pane.pane.middle));
        const bool isNear = changed.empty() || (glm::all(glm::greaterThan(at, changed.low - nearM)) &&
                                                glm::all(glm::lessThan(at, changed.high + nearM)));
        if (isNear) box.add(at);
    }
    return {box.low - besideM, box.high + besideM};
}

/// The views of one city.
struct CityViews {
    SunViewScene scene;
    QString name;
};

Result<std::array<CityViews, 2>> makeViews(const GlazingBookSource& source, const std::stop_token& stop) {
    DiagramScene before{source.baseline, {}, {}, {}}, after;
    after.proposal = keepOwnBuildings(source.scenario, source.baseline);
    after.city = keepOwnBuildings(source.scenario, after.proposal);
    const City removed = keepOwnBuildings(source.baseline, source.scenario);
    const Box2 ground = groundOf(source, after.proposal, removed);
    auto existing = SunViewScene::make(before, ground, stop, after.proposal);
    if (!existing) return tl::make_unexpected(existing.error());
    auto proposed = SunViewScene::make(after, ground, stop, after.proposal);
    if (!proposed) return tl::make_unexpected(proposed.error());
    return std::array{CityViews{*std::move(existing), scenarioText(source.labels.from)},
                      CityViews{*std::move(proposed), scenarioText(source.labels.to)}};
}

Caption captionOf(const RuleMoment& moment, const QString& city) {
    return {QStringLiteral("%1, %2: %3").arg(dayText(moment.day), QString::fromStdString(moment.clock), city),
            sheetText("Sun: azimuth %1°, altitude %2°")
                .arg(fixedNumber(double(moment.sun.azimuthDeg), 1))
                .arg(fixedNumber(double(moment.sun.altitudeDeg), 1))};
}

}  // namespace

bool hasSunViews(const Rule& rule) {
    const auto& diagrams = rule.deliverables.diagrams;
    return diagrams && std::ranges::find(diagrams->views, "view from the sun") != diagrams->views.end();
}

Result<std::vector<BookPage>> makeGlazingSunViews(const GlazingBookSource& source,
                                                  const BookSettings& settings, Progress& progress,
                                                  const std::stop_token& stop) {
    std::vector<BookPage> pages;
    if (!hasSunViews(source.study.rule)) return pages;
    const GlazingStudy& study = source.study;
    const auto moments = computeRuleMoments(
        study.rule, {observerOfPlaces(source.scenario), study.settings.zone, study.year}, {}, stop);
    if (!moments) return tl::make_unexpected(moments.error());
    const auto views = makeViews(source, stop);
    if (!views) return tl::make_unexpected(views.error());
    const auto areas = gridAreas(settings.setup, 2, settings.setup.landscape ? 2 : 3);
    const QSizeF shown = mapAreaOf(areas.front(), textScale(settings.setup)).size() * viewDpi / 72;
    const QSize size = (shown * std::min(1.0, maxViewPixels / shown.width())).toSize();
    const QString title = sheetText("Views from the sun");
    std::size_t used = 0;
    for (const RuleMoment& moment : *moments) {
        progress.report(double(used) / double(2 * moments->size()), NM_TEXT("drawing views from the sun"));
        for (const CityViews& view : *views) {
            if (stop.stop_requested()) return cancelled();
            if (used % areas.size() == 0)
                pages.push_back({title,
                                 sheetText("Without perspective, as the sun sees it: what is visible is "
                                           "sunlit, what is hidden is in shadow. New and changed "
                                           "buildings are violet. Clock: %1.")
                                     .arg(plainText(study.clock.text())),
                                 pages.empty() ? title : QString(),
                                 0,
                                 {}});
            pages.back().items.push_back(
                {areas[used++ % areas.size()],
                 PagePicture{view.scene.paint(moment.sun, size), captionOf(moment, view.name)}});
        }
    }
    return pages;
}

}  // namespace noonmark
