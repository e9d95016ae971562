#include "app/report/book/answer_books.h"

#include <algorithm>
#include <functional>
#include <map>

#include "app/report/book/elevation_pages.h"
#include "app/report/book/flow.h"
#include "app/report/maps/answer_legends.h"
#include "app/report/maps/sheet_text.h"
#include "app/report/sheets/report_sections.h"
#include "app/report/sheets/study_text.h"
#include "core/city/footprints/plan_overlay.h"
#include "core/describe/shown_as.h"
#include "core/receivers/points/glazing_pane.h"
#include "core/study/contributions/contributions.h"
#include "core/study/elements/element_study.h"
#include "core/study/elements/element_tables.h"
#include "core/study/text/breakdown_text.h"

namespace noonmark {

namespace {

/// What elevations of points need to know besides the points.
struct PointsOnBuildings {
    const City& city;
    const ElementMap& map;
    std::vector<std::size_t> buildings;  ///< by point: index in City::buildings; beyond them: of none
    std::function<double(const Building&)> storeyOf;
    QString subtitle;
};

/// The points of one building that elevations show, as indices of the map.
struct PointsOfBuilding {
    std::size_t building = 0;
    std::vector<std::size_t> points;
    double meanMin = 0;
};

ElevationPane paneOf(const MeasuredElement& element) {
    return {glm::dvec3(element.position), glm::dvec3(element.normal),
            element.pane.isKnown() ? element.pane : defaultPane};
}

std::vector<PointsOfBuilding> groupPoints(const PointsOnBuildings& from) {
    const std::vector<MeasuredElement>& elements = from.map.elements;
    std::map<std::size_t, PointsOfBuilding> byBuilding;
    for (std::size_t i = 0; i < elements.size(); ++i) {
        if (elements[i].kind == ElementKind::plane || !hasElevation(paneOf(elements[i]))) continue;
        const std::size_t building = from.buildings[i];
        PointsOfBuilding& group =
            byBuilding.try_emplace(building, PointsOfBuilding{building, {}, 0}).first->second;
        group.points.push_back(i);
        group.meanMin += elements[i].sunlitMin;
    }
    std::vector<PointsOfBuilding> groups;
    for (auto& [building, group] : byBuilding) {
        group.meanMin /= double(group.points.size());
        groups.push_back(std::move(group));
    }
    std::ranges::stable_sort(groups, {}, &PointsOfBuilding::meanMin);
    return groups;
}

ElevationBuilding drawBuilding(const PointsOnBuildings& from, const PointsOfBuilding& group,
                               const ColourScale& scale) {
    const MeasuredElement& first = from.map.elements[group.points.front()];
    const std::string& name = first.buildingName.empty() ? first.building : first.buildingName;
    ElevationBuilding drawn{
        name.empty() ? sheetText("Points at no building") : plainText(name), nullptr, {}, {{}}, {}};
    if (group.building < from.city.buildings.size()) {
        drawn.building = from.city.buildings[group.building].get();
        drawn.storeyM = from.storeyOf(*drawn.building);
    }
    for (const std::size_t i : group.points) {
        drawn.panes.push_back(paneOf(from.map.elements[i]));
        const Rgb colour = scale.colourOf(scale.shownOf(from.map.elements[i].grossMin));
        drawn.cells[0].push_back({toColour(colour), ElevationMark::none});
    }
    return drawn;
}

std::vector<BookPage> makeElevations(const PointsOnBuildings& from, const BookSettings& settings) {
    const Legend legend = makeSunLegend(from.map, settings.legend);
    const ColourScale scale = coloursOf(legend);
    ElevationSheets sheets{
        sheetText("Elevations: ") + (isEnglishInUse() ? legend.title.toLower() : sheetWord(legend.title)),
        from.subtitle,
        sheetText("Elevations"),
        {sheetWord(legend.title) + sheetText(", mean over the days")},
        {{legend}},
        from.city.frame};
    sheets.foot.hasMarks = false;
    sheets.foot.note = sheetText("Seen square to the wall, from outside.");
    sheets.scale = settings.scale;
    sheets.maxPages = maxSidePages(settings);
    // Each side takes a third of a page at least: more buildings cannot be drawn.
    const std::size_t maxDrawn = 3 * sheets.maxPages;
    std::vector<ElevationBuilding> buildings;
    for (const PointsOfBuilding& group : groupPoints(from))
        buildings.push_back(buildings.size() > maxDrawn ? ElevationBuilding{}
                                                        : drawBuilding(from, group, scale));
    return makeElevationPages(settings.setup, std::move(sheets), buildings);
}

PointsOnBuildings pointsOf(const ElementStudy& study, const ElementMap& map) {
    PointsOnBuildings from{study.city, map, {}, {}, {}};
    for (const auto& element : study.receivers.elements) from.buildings.push_back(element.building);
    from.storeyOf = [&study](const Building& building) {
        return findStoreyM(building, study.elements.facades, study.elements.parts.storeys);
    };
    from.subtitle =
        QStringLiteral("%1. %2.").arg(describePeriod(study.settings.period), describeFloors(study.elements));
    return from;
}

// The buildings of a city as it is now: by their ids.
PointsOnBuildings pointsOf(const ElementMap& map, const City& city, QString subtitle) {
    std::map<std::string, std::size_t> byId;
    for (std::size_t i = 0; i < city.buildings.size(); ++i) byId.try_emplace(city.buildings[i]->sourceId, i);
    PointsOnBuildings from{
        city, map, {}, [](const Building&) { return defaultStoreyM; }, std::move(subtitle)};
    for (const MeasuredElement& element : map.elements) {
        const auto known = byId.find(element.building);
        from.buildings.push_back(known == byId.end() ? city.buildings.size() : known->second);
    }
    return from;
}

TextBlocks summariseElements(const ElementStudy& study) {
    const ElementFigures figures = computeFigures(study);
    TextBlocks blocks{heading(sheetText("Summary"))};
    const auto add = [&](const QString& text) { blocks.push_back(body(text)); };
    add(sheetText("Points on %1. %2.")
            .arg(sheetText(nameOf(study.elements.places)), describePeriod(study.settings.period)));
    const auto withTrees = listFiguresWithTrees(study);
    const auto lines = listElementLines(figures, withTrees);
    for (const FigureText& figure : figureTexts(lines))
        add(QStringLiteral("%1: %2.").arg(figure.name, figure.value));
    blocks.push_back(heading(sheetText("Method")));
    add(study.engineKey == referenceEngine
            ? sheetText("Rays at every step of the sun.")
            : sheetText("Horizons of the points, in bins of a quarter of a degree."));
    if (!study.whyRays.empty()) add(sheetText("Chosen since %1.").arg(plainText(study.whyRays)));
    if (study.error) add(sheetText("Error against rays: %1.").arg(plainText(describe(*study.error))));
    add(defineFigures(lines));
    return blocks;
}

TextBlocks describeSources(const ElementStudy& study, const LegendChoice& legend) {
    Study sources;
    sources.city = study.city;
    sources.warnings = study.warnings;
    sources.provenance = study.provenance;
    sources.heights = study.heights;
    return sourceBlocks(sources, repeatBlocks(makeRepeatCommand(study, bookCharacters), false,
                                              listLegendOptions(legend, false), bookCharacters));
}

}  // namespace

Book makeElementBook(const ElementStudy& study, const ElementMap& map, const BookSettings& settings) {
    const SheetScope words(settings.language);
    const QString title = sheetText("Hours of sun on %1").arg(sheetText(nameOf(study.elements.places)));
    Book book = beginBook(settings, title, study.provenance.attribution);
    book.record = {QStringLiteral("study.json"), inEnglish([&] { return elementStudyJson(study, {}); })};
    const auto append = [&](std::vector<BookPage> pages) {
        std::ranges::move(pages, std::back_inserter(book.pages));
    };
    append(makeTextPages(settings.setup, {title, {}, sheetText("Summary")}, summariseElements(study)));
    append(makeElevations(pointsOf(study, map), settings));
    if (settings.heightMap)
        book.pages.push_back(makeHeightMapPage(study.city, bounds(study.settings.region), settings.setup));
    append(makeTextPages(settings.setup, {sheetText("Sources"), {}, sheetText("Sources")},
                         describeSources(study, settings.legend)));
    return book;
}

Book makeSavedBook(const SavedResult& result, const SavedOrigin& origin, const SavedSource& source,
                   const SavedElements& points, const std::vector<FigureLine>& lines,
                   const BookSettings& settings) {
    const SheetScope words(settings.language);
    return makeSavedBook(result, origin, source, lines, settings,
                         makeElevations(pointsOf(points.map, source.city,
                                                 plainText(origin.period.words) + QStringLiteral(".")),
                                        settings));
}

namespace {

constexpr std::size_t maxMarks = 30, maxBars = 12;
constexpr double minShare = 0.001;  // of all shadow, of a building that has a row
constexpr double rowPt = 7.8;

/// A row of the table: a building, the other buildings or the terrain, m2 h.
struct Contribution {
    QString name;
    double attributedM2h = 0, soleM2h = 0;
};

struct Contributions {
    std::vector<Contribution> buildings;  ///< of the least share and more, the largest first
    std::vector<MapMark> marks;
    Contribution others;
    std::size_t otherCount = 0;
    std::optional<Contribution> terrain;
    double allM2h = 0;
};

Contribution makeContribution(QString name, const BuildingShadow& shadow) {
    return {std::move(name), sumOf(shadow.attributedMinM2) / minutesPerHour,
            sumOf(shadow.soleMinM2) / minutesPerHour};
}

QString nameBuilding(const Building& building, std::uint32_t index) {
    if (!building.name.empty()) return plainText(building.name);
    if (!building.sourceId.empty()) return plainText(building.sourceId);
    return sheetText("building %1").arg(index);
}

/// On the building's largest part.
MapMark makeMark(const Building& building, std::size_t number) {
    const Part& largest =
        *std::ranges::max_element(building.parts, {}, [](const Part& part) { return area(part.footprint); });
    return {findPointInside(largest.footprint), QString::number(number)};
}

double sumOfAll(const ShadowBreakdown& breakdown) {
    double all = breakdown.terrain ? sumOf(breakdown.terrain->attributedMinM2) : 0;
    for (const BuildingShadow& shadow : breakdown.buildings) all += sumOf(shadow.attributedMinM2);
    return all / minutesPerHour;
}

Contributions collectContributions(const Study& study) {
    const ShadowBreakdown& breakdown = *study.breakdown;
    Contributions all;
    all.allM2h = sumOfAll(breakdown);
    for (const BuildingShadow& shadow : sortContributions(breakdown)) {
        const Building& building = *study.city.buildings[shadow.building];
        Contribution one = makeContribution(nameBuilding(building, shadow.building), shadow);
        if (one.attributedM2h < minShare * all.allM2h) {
            all.others.attributedM2h += one.attributedM2h;
            ++all.otherCount;
            continue;
        }
        all.buildings.push_back(std::move(one));
        if (all.marks.size() < maxMarks) all.marks.push_back(makeMark(building, all.buildings.size()));
    }
    if (breakdown.terrain) all.terrain = makeContribution(sheetText("Terrain"), *breakdown.terrain);
    return all;
}

QString describeWhenAndWhere(const Study& study) {
    return describePeriod(study.settings.period) + QStringLiteral(". ") +
           plainText(regionText(study.settings.region.name)) + QStringLiteral(", ") +
           describePlace(study.settings.region, study.city.frame);
}

BookPage makeNumberedMapPage(const Study& study, const Contributions& all, const BookSettings& settings) {
    const QString title = sheetText("Contributions of buildings");
    const Legend legend = makeLegend(study.field, ShadowMeasure::gross, settings.legend);
    SheetMap map{makeGrossScene(study.city, study.settings.region, study.field, coloursOf(legend)), legend};
    const QString name = sheetWord(legend.title);
    map.scene.marks = all.marks;
    BookPage page{title, describeWhenAndWhere(study), sheetText("Map"), 0, {}};
    page.items.push_back(
        {contentArea(settings.setup),
         PageMap{std::make_shared<const SheetMap>(std::move(map)),
                 {sheetText("%1 and the buildings that make most of the shadow").arg(name),
                  sheetText("Numbers as in the table; buildings outside of the map are not shown")}}});
    return page;
}

BookPage makeBarPage(const Contributions& all, const BookSettings& settings) {
    const QString title = sheetText("Largest contributions");
    BarChart chart{{{sheetText("Attributed"), shade::proposal}, {sheetText("Sole"), shade::incremental}},
                   {},
                   true,
                   settings.units};
    for (std::size_t i = 0; i < std::min(maxBars, all.buildings.size()); ++i)
        chart.groups.push_back(
            {QString::number(i + 1), {all.buildings[i].attributedM2h, all.buildings[i].soleM2h}});
    QRectF area = contentArea(settings.setup);
    area.setHeight(area.height() / 2);
    BookPage page{title, {}, title, 0, {}};
    page.items.push_back({area, PageChart{std::move(chart),
                                          {sheetText("Area x hours in shadow, by building"),
                                           sheetText("Numbers as in the table")}}});
    return page;
}

std::vector<QString> makeShareRow(const QString& number, const Contribution& one, bool hasSole, double allM2h,
                                  UnitSystem units) {
    const auto hours = [units](double m2h) { return QString::fromStdString(formatAreaHours(m2h, units)); };
    const double percent = allM2h > 0 ? 100 * one.attributedM2h / allM2h : 0;
    return {number, one.name, describeAmount(percent, 2) + QStringLiteral(" %"), hours(one.attributedM2h),
            hasSole ? hours(one.soleM2h) : QString()};
}

PageTable makeTable(const Contributions& all, const BookSettings& settings) {
    PageTable table{{sheetText("No."), sheetText("Building"), sheetText("Share of all shadow"),
                     sheetText("Attributed"), sheetText("Sole")},
                    {},
                    {},
                    {},
                    rowPt * textScale(settings.setup)};
    const auto add = [&](const QString& number, const Contribution& one, bool hasSole) {
        table.rows.push_back(makeShareRow(number, one, hasSole, all.allM2h, settings.units));
    };
    for (std::size_t i = 0; i < all.buildings.size(); ++i)
        add(QString::number(i + 1), all.buildings[i], true);
    if (all.otherCount > 0) {
        Contribution others = all.others;
        others.name = sheetText("Other buildings: %1").arg(describeCount(all.otherCount));
        add({}, others, false);
    }
    if (all.terrain) add({}, *all.terrain, true);
    add({}, {sheetText("All shadow"), all.allM2h}, false);
    return table;
}

std::vector<BookPage> makeShareTablePages(const Study& study, const Contributions& all,
                                          const BookSettings& settings) {
    const QString title = sheetText("Contributions"),
                  note = sheetText(
                             "Attributed: %1. Sole: %2. Area x hours over the whole period. Engine: %3. "
                             "Rows below 0.1 % are added up; contributions.csv lists each.")
                             .arg(plainText(std::string(attributedDefinition())),
                                  plainText(std::string(soleDefinition())),
                                  describeEngineUsed(study.breakdown->engine));
    return makeTablePages(settings.setup, {title, {}, title, 0, {}},
                          {{sheetText("By building"), note, makeTable(all, settings)}});
}

// Those that take most, with their seasons unless the legend shows trees as evergreens.
std::vector<BookPage> makeTreePages(const Study& study, const BookSettings& settings) {
    constexpr std::size_t maxTrees = 60;
    const std::vector<TreeContribution> trees = listTreeContributions(study);
    if (trees.empty()) return {};
    const bool asEvergreens = settings.legend.trees == TreeColumns::evergreen;
    const TreeColumns column =
        chooseRankedColumn(trees, asEvergreens ? TreeColumns::evergreen : TreeColumns::seasonal);
    PageTable table{
        {sheetText("Tree"), sheetText("Share of all shadow"), sheetText("Attributed"), sheetText("Sole")},
        {},
        {},
        {},
        rowPt * textScale(settings.setup)};
    const auto hours = [&](double minM2) {
        return QString::fromStdString(formatAreaHours(minM2 / minutesPerHour, settings.units));
    };
    for (const TreeContribution& tree : trees)
        for (const auto& [of, one] : tree.columns)
            if (of == column && table.rows.size() < maxTrees)
                table.rows.push_back({plainText(noonmark::nameOf(one)),
                                      describeAmount(100 * one.share, 2) + QStringLiteral(" %"),
                                      hours(one.attributedMinM2), hours(one.soleMinM2)});
    const QString title = sheetText("Contributions of trees"),
                  note = sheetText(
                             "What trees take of the sun that buildings leave, %1. The first %2 of "
                             "%3; tree_contributions.csv lists each.")
                             .arg(sheetText(describeTrees(column)), describeCount(table.rows.size()),
                                  describeCount(trees.size()));
    return makeTablePages(settings.setup, {title, {}, title, 0, {}},
                          {{sheetText("By tree"), note, std::move(table)}});
}

}  // namespace

Book makeContributionBook(const Study& study, const BookSettings& settings) {
    const SheetScope words(settings.language);
    Book book = beginBook(settings, sheetText("Contributions of buildings"), study.provenance.attribution);
    const Contributions all = collectContributions(study);
    book.pages.push_back(makeNumberedMapPage(study, all, settings));
    book.pages.push_back(makeBarPage(all, settings));
    std::ranges::move(makeShareTablePages(study, all, settings), std::back_inserter(book.pages));
    std::ranges::move(makeTreePages(study, settings), std::back_inserter(book.pages));
    if (settings.heightMap)
        book.pages.push_back(makeHeightMapPage(study.city, bounds(study.settings.region), settings.setup));
    return book;
}

}  // namespace noonmark
