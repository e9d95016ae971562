#include "app/report/book/element_book.h"

#include <algorithm>
#include <map>

#include "app/report/book/elevation_pages.h"
#include "app/report/book/flow.h"
#include "app/report/maps/element_legend.h"
#include "app/report/sheets/period_words.h"
#include "app/report/sheets/report_sections.h"
#include "app/report/sheets/study_words.h"
#include "core/receivers/points/pane_corners.h"
#include "core/study/elements/element_tables.h"
#include "core/study/elements/repeat_elements.h"

namespace noonmark {

namespace {

/// The points of one building that elevations show, as indices of the map.
struct PointsOfBuilding {
    std::uint32_t building = 0;
    std::vector<std::size_t> points;
    double meanMin = 0;
};

ElevationPane paneOf(const MeasuredElement& element) {
    return {glm::dvec3(element.position), glm::dvec3(element.normal),
            element.pane.isKnown() ? element.pane : defaultPane};
}

std::vector<PointsOfBuilding> groupPoints(const ElementStudy& study, const ElementMap& map) {
    std::map<std::uint32_t, PointsOfBuilding> byBuilding;
    for (std::size_t i = 0; i < map.elements.size(); ++i) {
        if (map.elements[i].kind == ElementKind::plane || !hasElevation(paneOf(map.elements[i]))) continue;
        const std::uint32_t building = study.receivers.elements[i].building;
        PointsOfBuilding& group =
            byBuilding.try_emplace(building, PointsOfBuilding{building, {}, 0}).first->second;
        group.points.push_back(i);
        group.meanMin += map.elements[i].sunlitMin;
    }
    std::vector<PointsOfBuilding> groups;
    for (auto& [building, group] : byBuilding) {
        group.meanMin /= double(group.points.size());
        groups.push_back(std::move(group));
    }
    std::ranges::stable_sort(groups, {}, &PointsOfBuilding::meanMin);
    return groups;
}

ElevationBuilding drawBuilding(const ElementStudy& study, const ElementMap& map,
                               const PointsOfBuilding& group, const ColourScale& scale) {
    const MeasuredElement& first = map.elements[group.points.front()];
    const std::string& name = first.buildingName.empty() ? first.building : first.buildingName;
    ElevationBuilding drawn{
        name.empty() ? QStringLiteral("Points at no building") : plainText(name), nullptr, {}, {{}}, {}};
    if (group.building < study.city.buildings.size()) {
        drawn.building = study.city.buildings[group.building].get();
        drawn.storeyM = findStoreyM(*drawn.building, study.elements.facades, study.elements.parts.storeys);
    }
    for (const std::size_t i : group.points) {
        drawn.panes.push_back(paneOf(map.elements[i]));
        const Rgb colour = scale.colourOf(scale.shownOf(map.elements[i].grossMin));
        drawn.cells[0].push_back({toColour(colour), ElevationMark::none});
    }
    return drawn;
}

std::vector<BookPage> makeElevations(const ElementStudy& study, const ElementMap& map,
                                     const BookSettings& settings) {
    const Legend legend = makeSunLegend(map, settings.legend);
    const ColourScale scale = coloursOf(legend);
    ElevationSheets sheets{
        QStringLiteral("Elevations: ") + legend.title.toLower(),
        QStringLiteral("%1. %2.").arg(describePeriod(study.settings.period), describeFloors(study.elements)),
        QStringLiteral("Elevations"),
        {legend.title + QStringLiteral(", mean over the days")},
        {{legend}},
        study.city.frame};
    sheets.foot.hasMarks = false;
    sheets.foot.note = QStringLiteral("Seen square to the wall, from outside.");
    sheets.scale = settings.scale;
    // Each side takes a third of a page at least: more buildings cannot be drawn.
    const std::size_t maxDrawn = 3 * sheets.maxPages;
    std::vector<ElevationBuilding> buildings;
    for (const PointsOfBuilding& group : groupPoints(study, map))
        buildings.push_back(buildings.size() > maxDrawn ? ElevationBuilding{}
                                                        : drawBuilding(study, map, group, scale));
    return makeElevationPages(settings.setup, std::move(sheets), buildings);
}

TextBlocks summariseElements(const ElementStudy& study) {
    const ElementFigures figures = computeFigures(study);
    TextBlocks blocks{heading(QStringLiteral("Summary"))};
    const auto add = [&](const QString& text) { blocks.push_back(body(text)); };
    add(QStringLiteral("Points on %1. %2.")
            .arg(plainText(nameOf(study.elements.places)), describePeriod(study.settings.period)));
    const auto lines = listLines(elementFigures().of(figures), {.sunlitMin = figures.possibleMin});
    for (const FigureText& figure : figureTexts(lines))
        add(QStringLiteral("%1: %2.").arg(figure.name, figure.value));
    blocks.push_back(heading(QStringLiteral("Method")));
    add(study.engineKey == referenceEngine
            ? QStringLiteral("Rays at every step of the sun.")
            : QStringLiteral("Horizons of the points, in bins of a quarter of a degree."));
    if (!study.whyRays.empty()) add(QStringLiteral("Chosen since %1.").arg(plainText(study.whyRays)));
    if (study.error) add(QStringLiteral("Error against rays: %1.").arg(plainText(describe(*study.error))));
    add(defineFigures(lines));
    return blocks;
}

TextBlocks describeSources(const ElementStudy& study, const LegendChoice& legend) {
    Study sources;
    sources.city = study.city;
    sources.warnings = study.warnings;
    sources.provenance = study.provenance;
    sources.heights = study.heights;
    return sourceBlocks(sources, repeatBlocks(makeRepeatCommand(study, bookLetters), false,
                                              listLegendOptions(legend, false), bookLetters));
}

}  // namespace

Book makeElementBook(const ElementStudy& study, const ElementMap& map, const BookSettings& settings) {
    const QString title = QStringLiteral("Hours of sun on %1").arg(plainText(nameOf(study.elements.places)));
    Book book = beginBook(settings, title, study.provenance.attribution);
    book.record = {QStringLiteral("study.json"), elementStudyJson(study, {})};
    const auto append = [&](std::vector<BookPage> pages) {
        std::ranges::move(pages, std::back_inserter(book.pages));
    };
    append(makeTextPages(settings.setup, {title, {}, QStringLiteral("Summary")}, summariseElements(study)));
    append(makeElevations(study, map, settings));
    append(makeTextPages(settings.setup, {QStringLiteral("Sources"), {}, QStringLiteral("Sources")},
                         describeSources(study, settings.legend)));
    return book;
}

}  // namespace noonmark
