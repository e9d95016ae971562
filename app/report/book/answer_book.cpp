#include "app/report/book/answer_books.h"

#include <algorithm>

#include "app/report/book/flow.h"
#include "app/report/maps/sheet_text.h"
#include "app/report/sheets/answer_reports.h"
#include "app/report/sheets/report_sections.h"
#include "app/report/sheets/study_report.h"
#include "core/describe/figure_text.h"
#include "core/engines/shade_trees.h"
#include "core/measures/shadow_figures.h"
#include "core/study/provenance/repeat_command.h"
#include "core/study/review_study.h"
#include "core/study/text/breakdown_text.h"
#include "scenarios/impact/impact_figures.h"
#include "scenarios/settings_json.h"
#include "scenarios/weights/score_text.h"

namespace noonmark {

namespace {

/// What the map refers to, for as long as the page is there.
struct MapOfHeights {
    City city;
    Region region;
    std::optional<SheetMap> map{};
};

/// "assumed: 12"
std::vector<LegendPatch> countedPatches(const SourceCounts& counts) {
    std::vector<LegendPatch> patches;
    for (const HeightSourceColour& one : heightSourceColours())
        if (const std::size_t count = counts[std::size_t(one.source)]; count > 0)
            patches.push_back(
                {one.colour, sheetText(one.label) + QStringLiteral(": ") + describeCount(count)});
    return patches;
}

}  // namespace

BookPage makeHeightMapPage(const City& city, const Box2& shown, const PageSetup& setup) {
    auto owned = std::make_shared<MapOfHeights>(MapOfHeights{city, {}});
    Legend legend{sheetText("Source of height"),
                  sheetText("of the highest part of each building; counts are of the whole city")};
    legend.classes = countedPatches(countSources(owned->city));
    MapScene scene{owned->city, owned->region, {}, {}};
    scene.shown = shown.empty() ? bounds(city) : shown;
    scene.fillOf = [](const Building& building) { return colourOf(sourceOfHeight(building)).colour; };
    owned->map.emplace(SheetMap{std::move(scene), std::move(legend)});
    const QString title = sheetText("Where the heights come from");
    BookPage page{title, {}, title, 0, {}};
    page.items.push_back({contentArea(setup), PageMap{{owned, &*owned->map}}});
    return page;
}

namespace {

constexpr double tablePt = 7.8;
constexpr std::size_t maxRows = 300;  // of a table, unless all pages are asked for

/// The answer in a sentence at the top of a page. Returns the y below it.
double addFinding(BookPage& page, const QString& finding, const QRectF& all, double scale) {
    MeasuringCanvas measure;
    constexpr double points = 10, unit = MeasuringCanvas::unitsPerPoint;
    const TextBlocks blocks{heading(plainText(finding))};
    const double height = heightOf(measure.canvas(), blocks, all.width() * unit, points * scale) / unit + 1;
    page.items.push_back({{all.left(), all.top(), all.width(), height}, PageText{blocks, points * scale}});
    return all.top() + height + 4 * scale;
}

/// Of upright paper the share that figures have beside a second map, of paper on its side beside any.
constexpr double besideMap = 0.42, besideMaps = 0.3;

PageTable tableOfFigures(const Sheet& sheet, const PageSetup& setup) {
    PageTable table{{sheetText("Figure"), sheetText("Value")}, {}, {}, {}, tablePt * textScale(setup)};
    for (const FigureText& figure : sheet.figures)
        table.rows.push_back({plainText(figure.name), plainText(figure.value)});
    const double share = setup.landscape ? besideMaps : sheet.smallMap ? besideMap : 1;
    table.widthsPt = fitColumns(table, contentArea(setup).width() * share);
    return table;
}

/// More than beside or below a map are on pages of their own.
bool fitsBesideMap(const PageTable& table, const PageSetup& setup) {
    constexpr double ofPortrait = 0.52, ofLandscape = 0.9;
    const double room = contentArea(setup).height() * (setup.landscape ? ofLandscape : ofPortrait);
    return tableHeightPt(table) <= room;
}

BookPage beginMapPage(const Sheet& sheet, const QString& bookmark) {
    const Headline& headline = sheet.headline;
    return {headline.what, headline.when + QStringLiteral(". ") + headline.where, bookmark, 0, {}};
}

PageMap pageMap(const SheetMap& map) { return {std::make_shared<const SheetMap>(map)}; }

/// Where a page has what is on it.
struct MapPageAreas {
    QRectF map;
    std::optional<QRectF> smallMap{}, figures{};
};

/// Figures of upright paper are below the map, beside the second one; of paper on its side beside both.
MapPageAreas divideMapPage(const QRectF& all, const PageSetup& setup, bool hasSmallMap,
                           std::optional<double> figuresPt) {
    constexpr double minSmallMap = 0.34;  // of the height
    const double gap = 14 * textScale(setup);
    MapPageAreas areas{all};
    if (figuresPt && setup.landscape) {
        const double width = all.width() * besideMaps;
        areas.map.setWidth(all.width() - width - gap);
        areas.figures = QRectF(areas.map.right() + gap, all.top(), width, *figuresPt);
    } else if (figuresPt) {
        const double row = hasSmallMap ? std::max(*figuresPt, minSmallMap * all.height()) : *figuresPt;
        const double width = hasSmallMap ? all.width() * besideMap : all.width();
        areas.map.setHeight(all.height() - row - gap);
        const double top = areas.map.bottom() + gap;
        areas.figures = QRectF(all.left(), top, width, *figuresPt);
        if (hasSmallMap)
            areas.smallMap = QRectF(all.left() + width + gap, top, all.width() - width - gap, row);
    }
    if (hasSmallMap && !areas.smallMap) {
        const QRectF both = areas.map;
        areas.map.setHeight((both.height() - gap) / 2);
        areas.smallMap = areas.map.translated(0, areas.map.height() + gap);
    }
    return areas;
}

/// The finding, the maps of a sheet, and the figures where they have room.
BookPage mapPageWithFigures(const PageSetup& setup, const Sheet& sheet, const PageTable& table) {
    BookPage page = beginMapPage(sheet, sheetText("Map"));
    QRectF all = contentArea(setup);
    if (!sheet.finding.isEmpty()) all.setTop(addFinding(page, sheet.finding, all, textScale(setup)));
    const bool hasFigures = fitsBesideMap(table, setup);
    const MapPageAreas areas = divideMapPage(all, setup, sheet.smallMap.has_value(),
                                             hasFigures ? std::optional(tableHeightPt(table)) : std::nullopt);
    if (areas.figures) page.items.push_back({*areas.figures, table});
    page.items.push_back({areas.map, pageMap(sheet.map)});
    if (areas.smallMap) page.items.push_back({*areas.smallMap, pageMap(*sheet.smallMap)});
    return page;
}

void appendPages(Book& book, std::vector<BookPage> pages) {
    std::move(pages.begin(), pages.end(), std::back_inserter(book.pages));
}

/// `repeat`: the command, in lines that fit a column.
void addText(Book& book, const Sheet& sheet, std::span<const TextBlocks> sections, const TextBlocks& repeat) {
    TextBlocks blocks{heading(sheetText("Definitions"))};
    const auto add = [&](const TextBlocks& more) { blocks.insert(blocks.end(), more.begin(), more.end()); };
    add(sheet.definitions);
    for (const TextBlocks& section : sections) add(section);
    add(repeat);
    const QString title = sheetText("Method and sources");
    appendPages(book, makeTextPages(book.setup, {title, {}, title, 0, {}}, blocks));
}

/// The sections of a comparison or score end with the command in lines of another length.
std::span<const TextBlocks> withoutCommand(const Sheet& sheet) {
    return std::span(sheet.sections).first(sheet.sections.size() - 1);
}

void addMaps(Book& book, const Sheet& sheet) {
    const PageTable table = tableOfFigures(sheet, book.setup);
    book.pages.push_back(mapPageWithFigures(book.setup, sheet, table));
    if (!fitsBesideMap(table, book.setup)) {
        const QString title = sheetText("Figures");
        appendPages(book, makeTablePages(book.setup, {title, {}, title, 0, {}}, {{title, {}, table}}));
    }
}

/// A map with the city that it refers to.
struct MapOfCity {
    City city;
    std::optional<SheetMap> map{};
};

/// One of two scenarios.
struct ComparedSide {
    City city;
    const ShadowField& field;
    const std::string& name;
};

/// Gross shadow of one scenario, on a scale that both share.
PageMap grossMap(const ComparedSide& side, const Region& region, const Legend& legend) {
    auto owned = std::make_shared<MapOfCity>(MapOfCity{side.city});
    owned->map.emplace(SheetMap{makeGrossScene(owned->city, region, side.field, coloursOf(legend)), legend});
    return {{owned, &*owned->map}, {plainText(scenarioText(side.name)), sheetWord(legend.unit)}};
}

/// The city before the change, from that after it.
City findCityBefore(const ImpactAnswer& answer, const City& after) {
    City before = keepOwnBuildings(after, answer.proposal);
    before.buildings.insert(before.buildings.end(), answer.removed.buildings.begin(),
                            answer.removed.buildings.end());
    return before;
}

/// The same for a saved comparison, of which only the scenario's city is known: where it was open ground
/// before, a building is new. Those that were demolished are missing.
City findCityBefore(const SavedImpact::Sides& sides, const City& after) {
    const Grid& grid = sides.before.grid;
    City before = after;
    std::erase_if(before.buildings, [&](const auto& building) {
        const Box2 box = bounds(*building);
        const glm::dvec2 at =
            (glm::dvec2(box.low + box.high) / 2.0 - glm::dvec2(grid.westM, grid.southM)) / double(grid.cellM);
        if (at.x < 0 || at.y < 0 || at.x >= grid.columns || at.y >= grid.rows) return false;
        const std::size_t cell = grid.index(int(at.x), int(at.y));
        return std::isnan(sides.after.grossMin[cell]) && !std::isnan(sides.before.grossMin[cell]);
    });
    return before;
}

/// On the scale of the darker one.
Legend makeSharedLegend(const ShadowField& before, const ShadowField& after, const LegendChoice& choice) {
    const bool beforeIsDarker = topOf(before, ShadowMeasure::gross) > topOf(after, ShadowMeasure::gross);
    return makeLegend(beforeIsDarker ? before : after, ShadowMeasure::gross, choice);
}

/// How high tables are that may stand below maps, points; 0: they are many or none.
double heightBelowMaps(const std::vector<BookPage>& tables, const PageSetup& setup) {
    constexpr double largestShare = 0.2;  // of the page
    if (tables.size() != 1) return 0;
    const QRectF all = contentArea(setup);
    double height = 0;
    for (const PageItem& item : tables.front().items)
        height = std::max(height, item.area.bottom() - all.top());
    return height < largestShare * all.height() ? height : 0;
}

/// On the last page, which has so much room for them, or on their own.
void addTables(Book& book, std::vector<BookPage> tables, double belowPt) {
    if (belowPt == 0) return appendPages(book, std::move(tables));
    for (PageItem& item : tables.front().items) {
        item.area.translate(0, contentArea(book.setup).height() - belowPt);
        book.pages.back().items.push_back(std::move(item));
    }
}

/// `belowPt`: left free at the bottom.
BookPage sideBySide(const ComparedSide& before, const ComparedSide& after, const Region& region,
                    const PageSetup& setup, const Legend& legend, double belowPt) {
    const QString title = sheetText("Scenarios side by side");
    BookPage page{title, sheetText("%1 on one scale.").arg(sheetWord(legend.title)), title, 0, {}};
    const double gap = 12 * textScale(setup);
    QRectF all = contentArea(setup);
    if (belowPt > 0) all.setHeight(all.height() - belowPt - gap);
    const QSizeF half = setup.landscape ? QSizeF((all.width() - gap) / 2, all.height())
                                        : QSizeF(all.width(), (all.height() - gap) / 2);
    const QPointF second = setup.landscape ? QPointF(all.left() + half.width() + gap, all.top())
                                           : QPointF(all.left(), all.top() + half.height() + gap);
    page.items.push_back({{all.topLeft(), half}, grossMap(before, region, legend)});
    page.items.push_back({{second, half}, grossMap(after, region, legend)});
    return page;
}

BookPage sideBySide(const ImpactAnswer& answer, const AnswerSource& source, const PageSetup& setup,
                    const LegendChoice& choice, double belowPt) {
    const ShadowField& before = fieldOfColumn(answer.study.before, choice.trees);
    const ShadowField& after = fieldOfColumn(answer.study.after, choice.trees);
    Legend legend = makeSharedLegend(before, after, choice);
    if (!answer.study.withTrees.empty()) nameTrees(legend, choice.trees);
    return sideBySide({findCityBefore(answer, source.city), before, answer.from},
                      {source.city, after, answer.to}, answer.settings.study.region, setup, legend, belowPt);
}

BookPage sideBySide(const SavedImpact& saved, const MapScene& scene, const BookSettings& settings,
                    double belowPt) {
    const SavedImpact::Sides& sides = *saved.sides;
    return sideBySide({findCityBefore(sides, scene.city), sides.before, saved.figures.from},
                      {scene.city, sides.after, saved.figures.to}, scene.region, settings.setup,
                      makeSharedLegend(sides.before, sides.after, settings.legend), belowPt);
}

QString titleOf(const Figure& figure) { return sheetText(figure.label); }

void addCells(std::vector<QString>& row, const DescribedFigures& figures, const BookSettings& settings,
              ShownAs show) {
    for (const Figure& figure : figures.figures)
        if (isShownAs(figure, show))
            row.push_back(plainText(valueOf({&figure, figures.get(figure)}, settings.units)));
}

/// The sole contribution of each new building.
std::vector<BookPage> contributionPages(const ComparisonFigures& figures, const BookSettings& settings,
                                        ShownAs show) {
    if (figures.byBuilding.empty()) return {};
    PageTable table{
        {sheetText("Building"), sheetText("Threshold")}, {}, {}, {}, tablePt * textScale(settings.setup)};
    for (const Figure& figure : changeFigures().rows())
        if (isShownAs(figure, show)) table.titles.push_back(titleOf(figure));
    QString note;
    for (const auto& building : figures.byBuilding) {
        if (!settings.allPages && table.rows.size() == maxRows) {
            note = sheetText("The first %1 of %2.")
                       .arg(describeCount(maxRows), describeCount(figures.byBuilding.size()));
            break;
        }
        table.rows.push_back({plainText(building.name),
                              describeAmount(building.figures.thresholdMin, 2) + sheetText(" min a day")});
        addCells(table.rows.back(), changeFigures().of(building.figures.gross), settings, show);
    }
    const QString title = sheetText("Contributions");
    return makeTablePages(
        settings.setup, {title, {}, title, 0, {}},
        {{sheetText("Sole contribution of each new building: against the scenario without it"), note,
          std::move(table)}});
}

BookPage sunByMonthPage(const Bars& months, const BookSettings& settings) {
    const QString title = sheetText("Months");
    BookPage page{title, {}, title, 0, {}};
    QRectF area = contentArea(settings.setup);
    area.setHeight(std::min(area.height(), area.width() / 2));
    BarChart chart = makeBarChart(months, FigureUnit::hours, settings.units, QStringLiteral("h"));
    chart.series.front().colour = shade::sun;
    page.items.push_back({area, PageChart{std::move(chart), {sheetText(months.title), {}}}});
    return page;
}

QString monthText(std::chrono::year_month month) {
    if (!isEnglishInUse()) return QString::fromStdString(wordingInUse().month(month.month(), true));
    return QStringLiteral("%1-%2").arg(int(month.year())).arg(unsigned(month.month()), 2, 10, QChar(u'0'));
}

/// A chart of one figure by month.
PageChart monthChart(const Score& score, std::string_view key, QColor colour, const BookSettings& settings) {
    const Figure& figure = findFigure(scoreMonthFigures().rows(), key);
    BarChart chart{
        {{titleOf(figure), colour}}, {}, figure.unit == FigureUnit::squareMetreHours, settings.units};
    for (const MonthFigures& month : score.months)
        chart.groups.push_back({monthText(month.month), {figure.get(&month)}});
    return {std::move(chart), {titleOf(figure) + sheetText(" by month"), definitionText(figure)}};
}

// The rest of the receivers' area, in each month.
PageChart sunChart(const Score& score, const BookSettings& settings) {
    const Figure& figure = findFigure(shadowFigures().rows(), "sun_area_m2");
    BarChart chart{{{titleOf(figure), shade::sun}}, {}, false, settings.units};
    for (const MonthFigures& month : score.months)
        chart.groups.push_back({monthText(month.month), {score.receiverAreaM2 - month.shadowAreaM2}});
    return {std::move(chart), {titleOf(figure) + sheetText(" by month"), definitionText(figure)}};
}

BookPage monthPage(const Score& score, const BookSettings& settings, ShownAs show) {
    const QString title = sheetText("Months");
    BookPage page{title, {}, title, 0, {}};
    const QRectF all = contentArea(settings.setup);
    const PageChart charts[]{show == ShownAs::shadow
                                 ? monthChart(score, "shadow_area_m2", shade::proposal, settings)
                                 : sunChart(score, settings),
                             monthChart(score, "weighted_shade_m2h", shade::incremental, settings)};
    const double gap = 14 * textScale(settings.setup);
    const double height = (all.height() - gap) / double(std::size(charts));
    double top = all.top();
    for (const PageChart& chart : charts) {
        page.items.push_back({{all.left(), top, all.width(), height}, chart});
        top += height + gap;
    }
    return page;
}

std::vector<BookPage> intervalPages(const Score& score, const std::string& weights,
                                    const BookSettings& settings, ShownAs show) {
    PageTable table{{sheetText("Interval")}, {}, {}, {}, tablePt * textScale(settings.setup)};
    for (const Figure& figure : scoreIntervalFigures().rows())
        if (isShownAs(figure, show)) table.titles.push_back(titleOf(figure));
    for (const IntervalFigures& interval : score.intervals) {
        table.rows.push_back({plainText(weightText(interval.name))});
        addCells(table.rows.back(), scoreIntervalFigures().of(interval), settings, show);
    }
    if (table.rows.empty()) return {};
    const QString title = sheetText("Weights");
    return makeTablePages(settings.setup, {title, {}, title, 0, {}},
                          {{plainText(weightText(weights)), {}, std::move(table)}});
}

// Which column a page states, where there are several.
BookPage nameColumn(BookPage page, const Score& score, const LegendChoice& legend) {
    if (score.withTrees.empty()) return page;
    page.subtitle = sheetText(describeTrees(columnOf(score, legend.trees))) + u'.';
    return page;
}

// With the maps of the sheet.
Book beginAnswerBook(const BookSettings& settings, const Sheet& sheet, const std::string& attribution) {
    Book book = beginBook(settings, plainText(sheet.headline.what), attribution);
    book.record = sheet.record;
    addMaps(book, sheet);
    return book;
}

void addHeightMap(Book& book, const City& city, const Region& region, const BookSettings& settings) {
    if (settings.heightMap) book.pages.push_back(makeHeightMapPage(city, bounds(region), settings.setup));
}

}  // namespace

Book makeStudyBook(const Study& study, const BookSettings& settings) {
    const SheetScope words(settings.language);
    const Sheet sheet = makeSheet(study, settings.legend);
    Book book = beginAnswerBook(settings, sheet, study.provenance.attribution);
    if (const Bars months = makeMonthBarsWithTrees(study); !months.groups.empty())
        book.pages.push_back(sunByMonthPage(months, settings));
    addHeightMap(book, study.city, study.settings.region, settings);
    addText(book, sheet, sheet.sections,
            repeatBlocks(makeRepeatCommand(study, bookCharacters), needsRegionFile(study.provenance),
                         listLegendOptions(settings.legend, false), bookCharacters));
    return book;
}

Book makeImpactBook(const ImpactAnswer& answer, const AnswerSource& source, const ChangeScale& scale,
                    const BookSettings& settings, const LegendChoice& legend) {
    const SheetScope words(settings.language);
    const Sheet sheet = makeSheet(answer, source, scale, legend);
    Book book = beginAnswerBook(settings, sheet, answer.provenance.attribution);
    auto contributions = contributionPages(computeFigures(answer), settings, legend.show);
    const double below = heightBelowMaps(contributions, settings.setup);
    book.pages.push_back(sideBySide(answer, source, settings.setup, legend, below));
    addTables(book, std::move(contributions), below);
    addHeightMap(book, source.city, answer.settings.study.region, settings);
    addText(book, sheet, withoutCommand(sheet),
            repeatBlocks(makeRepeatCommand(answer, bookCharacters), needsRegionFile(answer.provenance),
                         drawnOptions(scale, legend), bookCharacters));
    return book;
}

Book makeScoreBook(const ScoreAnswer& answer, const AnswerSource& source, const BookSettings& settings,
                   const LegendChoice& legend) {
    const SheetScope words(settings.language);
    const Sheet sheet = makeSheet(answer, source, legend);
    Book book = beginAnswerBook(settings, sheet, answer.provenance.attribution);
    const auto shown =
        showColumn(std::shared_ptr<const Score>(std::shared_ptr<void>(), &answer.score), legend.trees);
    if (!shown->months.empty())
        book.pages.push_back(nameColumn(monthPage(*shown, settings, legend.show), answer.score, legend));
    for (BookPage& page : intervalPages(*shown, answer.weights.name, settings, legend.show))
        book.pages.push_back(nameColumn(std::move(page), answer.score, legend));
    addHeightMap(book, source.city, answer.settings.region, settings);
    addText(book, sheet, withoutCommand(sheet),
            repeatBlocks(makeRepeatCommand(answer, bookCharacters), needsRegionFile(answer.provenance),
                         listLegendOptions(legend, true), bookCharacters));
    return book;
}

Book makeSavedBook(const SavedMapBook& saved, const BookSettings& settings) {
    const SheetScope words(settings.language);
    const Sheet& sheet = saved.sheet;
    Book book = beginBook(settings, plainText(sheet.headline.what), saved.attribution);
    book.record = sheet.record;
    addMaps(book, sheet);
    if (!saved.months.groups.empty()) book.pages.push_back(sunByMonthPage(saved.months, settings));
    if (saved.comparison) {
        auto contributions = contributionPages(saved.comparison->figures, settings, settings.legend.show);
        const bool hasSides = saved.comparison->sides.has_value();
        const double below = hasSides ? heightBelowMaps(contributions, settings.setup) : 0;
        if (hasSides) book.pages.push_back(sideBySide(*saved.comparison, sheet.map.scene, settings, below));
        addTables(book, std::move(contributions), below);
    }
    if (saved.score) {
        if (!saved.score->months.empty())
            book.pages.push_back(monthPage(*saved.score, settings, settings.legend.show));
        appendPages(book, intervalPages(*saved.score, saved.weights, settings, settings.legend.show));
    }
    addHeightMap(book, sheet.map.scene.city, sheet.map.scene.region, settings);
    addText(book, sheet, sheet.sections, saved.note);
    return book;
}

Book makeSavedBook(const SavedResult& result, const SavedOrigin& origin, const SavedSource& source,
                   const std::vector<FigureLine>& lines, const BookSettings& settings,
                   std::vector<BookPage> more) {
    const SheetScope words(settings.language);
    const QString title = plainText(result.name);
    Book book = beginBook(settings, title, attributionOf(result));
    book.record = {QStringLiteral("result.json"), result.settings};
    PageTable table{
        {sheetText("Figure"), sheetText("Value")}, {}, {}, {}, tablePt * textScale(settings.setup)};
    for (const FigureLine& line : lines)
        table.rows.push_back({plainText(labelOf(line)), plainText(valueOf(line, settings.units))});
    book.pages = makeTablePages(book.setup, {title, plainText(scenarioText(result.scenario)), title, 0, {}},
                                {{sheetText("Figures"), {}, std::move(table)}});
    appendPages(book, std::move(more));
    TextBlocks blocks{heading(sheetText("Definitions")), body(defineFigures(lines))};
    for (const TextBlocks& section : makeSavedSections(result, origin, source))
        blocks.insert(blocks.end(), section.begin(), section.end());
    const QString sources = sheetText("Method and sources");
    appendPages(book, makeTextPages(book.setup, {sources, {}, sources, 0, {}}, blocks));
    return book;
}

}  // namespace noonmark
