#include "app/report/book/answer_books.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "app/report/book/flow.h"
#include "app/report/maps/city_painter.h"
#include "app/report/maps/legend_painter.h"
#include "app/report/maps/map_view.h"
#include "app/report/maps/sheet_text.h"
#include "app/report/sheets/report_sections.h"
#include "app/report/sheets/study_text.h"
#include "core/base/units.h"
#include "core/city/footprints/plan_overlay.h"
#include "core/describe/command_options.h"
#include "core/describe/figure_text.h"
#include "core/describe/shown_as.h"
#include "core/measures/shadow_figures.h"
#include "core/receivers/place_names.h"
#include "core/study/provenance/command_text.h"

namespace noonmark {

namespace {

const SunByPlace& sunOf(const SunOfCities& all) { return all.baseline; }

QString hoursText(double hours) {
    return std::isnan(hours) ? QString() : sheetNumbers(formatNumber(hours, 2));
}
QString percentText(double share) {
    return std::isnan(share) ? QString() : QStringLiteral("%1 %").arg(fixedNumber(100 * share, 0));
}

/// The places by what they lose to the first scenario or, without one, by their sun; least first. Places
/// without figures come last.
std::vector<std::size_t> sortByInterest(const SunOfCities& all) {
    std::vector<std::size_t> order(sunOf(all).places.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto key = [&](std::size_t i) {
        const double value =
            all.compared.empty() ? sunOf(all).sun[i].meanHours : all.compared.front().changes[i].meanHours;
        return std::isnan(value) ? 1e9 : value;
    };
    std::ranges::stable_sort(order, {}, key);
    return order;
}

// The sentences of the answer, as the window and the command line state them.
TextBlocks describeFinding(const SunOfCities& all, UnitSystem units, ShownAs show) {
    const AnswerPage page = makePage(all, show);
    TextBlocks blocks{heading(sheetText("Finding")),
                      body(plainText(formatText(asOnSheets(page.headline), units)) + QStringLiteral("."))};
    for (const Sentence& finding : page.findings)
        blocks.push_back(body(plainText(formatText(asOnSheets(finding), units))));
    return blocks;
}

TextBlocks describeMethod(const SunOfCities& all) {
    const SunByPlace& sun = sunOf(all);
    TextBlocks blocks{heading(sheetText("How this was made"))};
    const auto add = [&](const QString& text) { blocks.push_back(body(text)); };
    add(QStringLiteral("%1. %2.").arg(describePeriod(sun.settings.study.period),
                                      plainText(localText(sun.field.engine))));
    add(sheetText("Cells of %1 m; places with fewer than %2 of them have cells of %3 m. Cells on the edge "
                  "of a place count with the share of them that lies in it.")
            .arg(shortNumber(sun.settings.study.receivers.cellM, 6))
            .arg(SunByPlaceSettings::smallPlaceCells)
            .arg(shortNumber(std::min(sun.settings.smallCellM, sun.settings.study.receivers.cellM), 6)));
    add(sheetText("Without any shadow there would be %1 h of sun a day.").arg(hoursText(sun.possibleHours)));
    for (const SunWithTrees& with : sun.withTrees)
        add(sheetText("Also measured with %1.").arg(sheetText(describeTrees(with.column))));
    const std::string& how = shownCity(all).treesHow;  // a baseline may have none
    if (!how.empty()) add(sheetText("Trees: %1.").arg(plainText(how)));
    add(sheetText("Error of cells: %1. The error of each figure is in the table at the end.")
            .arg(plainText(describeCellError(sun.error))));
    if (!all.compared.empty())
        add(sheetText("The baseline is %1. Ground that is built on in any scenario counts in none.")
                .arg(plainText(sun.name)));
    return blocks;
}

TextBlocks describeSources(const SunByPlace& sun) {
    Study sources;
    sources.city = sun.city;
    sources.warnings = sun.warnings;
    sources.provenance = sun.provenance;
    return sourceBlocks(sources);
}

QString nameOfDate(const SunByPlace& sun, std::size_t date) {
    return describeDates(sun.settings.dates[date]);
}

Legend legendOf(const SunByPlace& sun, const PlaceColours& colours) {
    const bool isShadow = chooseShown(sun, colours).isShadow;
    const QString unit = isShadow ? sheetText("minutes of shadow") : sheetText("hours of sun");
    Legend legend{isShadow ? sheetText("Shadow by place") : sheetText("Sun by place"),
                  unit + sheetText(" a day")};
    if (!sun.name.empty())
        legend.title = sheetWord(legend.title) + QStringLiteral(": ") + plainText(sun.name);
    if (colours.date) legend.unit = sheetText("%1 on %2").arg(unit, nameOfDate(sun, *colours.date));
    if (colours.column) nameTrees(legend, *colours.column);
    legend.colours = makeScale(sun, colours);
    legend.scale = {legend.colours->high, legend.colours->tick};
    return legend;
}

/// What a map colours the places by, in the unit of its legend; NaN: no figure.
struct PlaceMap {
    Legend legend;
    std::vector<double> values;
};

PlaceMap makeMap(const SunByPlace& sun, const PlaceColours& colours) {
    PlaceMap map{legendOf(sun, colours), {}};
    const ShownSunOrShadow shown = chooseShown(sun, colours);
    for (const SunOfPlace& place : sun.sun) map.values.push_back(shown.of(hoursOf(place, colours.date)));
    return map;
}

PlaceMap makeChangeMap(const ComparedSun& compared, const PlaceColours& colours) {
    PlaceMap map{{sheetText("Change of sun by place: ") + plainText(compared.sun.name),
                  sheetText("minutes of sun a day")},
                 {}};
    if (colours.column) nameTrees(map.legend, *colours.column);
    map.legend.colours = makePlaceChangeScale(colours.legend);
    map.legend.scale = {map.legend.colours->high, map.legend.colours->tick};
    for (const SunChange& change : compared.changes) map.values.push_back(minutesPerHour * change.meanHours);
    return map;
}

// Small places lie on top.
std::vector<std::size_t> sortByArea(const SunByPlace& sun) {
    std::vector<std::size_t> order(sun.places.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, std::greater(), [&](std::size_t i) { return area(sun.places[i]); });
    return order;
}

void paintPlaces(const Canvas& canvas, const MapView& view, const SunByPlace& sun, const PlaceMap& map) {
    canvas.painter.setPen(linePen(canvas, shade::buildingLine, 0.2));
    for (const std::size_t i : sortByArea(sun)) {
        QPainterPath path;
        path.setFillRule(Qt::WindingFill);
        for (const Footprint& polygon : sun.places[i].polygons) view.addTo(path, polygon);
        const double value = map.values[i];
        canvas.painter.setBrush(std::isnan(value) ? QBrush(Qt::NoBrush)
                                                  : QBrush(toColour(map.legend.colours->colourOf(value))));
        canvas.painter.drawPath(path);
    }
}

// Those of the largest first, where they meet no other; streets are too many.
void paintNames(const Canvas& canvas, const MapView& view, const SunByPlace& sun, const QRectF& map) {
    constexpr double namePt = 6, haloPt = 1.5;
    const QFont font = textFont(canvas, namePt, QFont::DemiBold);
    const QFontMetricsF metrics(font);
    std::vector<QRectF> taken;
    for (const std::size_t i : sortByArea(sun)) {
        const Place& place = sun.places[i];
        if (!hasOwnName(place) || place.kind == PlaceKind::street) continue;
        const QString name = plainText(place.name);
        const Box2 box = bounds(*std::ranges::max_element(
            place.polygons, {}, [](const Footprint& polygon) { return area(polygon); }));
        QRectF room = metrics.boundingRect(name);
        const QPointF start(view.at(glm::dvec2(box.low + box.high) * 0.5) - room.center());
        room.translate(start);
        const auto meets = [&](const QRectF& other) { return other.intersects(room); };
        if (!map.contains(room) || std::ranges::any_of(taken, meets)) continue;
        taken.push_back(room);
        QPainterPath text;
        text.addText(start, font, name);
        canvas.painter.strokePath(
            text, QPen(ink::paper, haloPt * canvas.point, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        canvas.painter.fillPath(text, ink::text);
    }
}

QImage paintMap(const SunByPlace& sun, const City& city, const Box2& shown, const PlaceMap& of,
                const QSizeF& sizePt, double pixelsPerPt, double marginPt = 0) {
    constexpr double gapPt = 6;
    QImage image((sizePt * pixelsPerPt).toSize(), QImage::Format_RGB32);
    image.fill(ink::paper);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    const Canvas canvas{painter, pixelsPerPt};
    const double marginPx = marginPt * pixelsPerPt;
    const QRectF all = QRectF(QPointF(0, 0), image.size()).adjusted(marginPx, marginPx, -marginPx, -marginPx);
    const double footPx = legendHeightPt * pixelsPerPt;
    const QRectF map = all.adjusted(0, 0, 0, -footPx - gapPt * pixelsPerPt);
    const MapView view(shown, map);
    painter.setClipRect(map);
    paintPlaces(canvas, view, sun, of);
    paintBuildings(canvas, view, city, withProposals({shade::building, shade::buildingLine, 0.1}));
    paintNames(canvas, view, sun, map);
    painter.setClipping(false);
    const QRectF foot(all.left(), all.bottom() - footPx, all.width(), footPx);
    paintLegend(canvas, foot.adjusted(0, 0, -foot.width() * 0.45, 0), of.legend);
    paintScaleBar(canvas, foot.adjusted(foot.width() * 0.6, 0, -40 * pixelsPerPt, 0),
                  scaleBarWithin(foot.width() * 0.25 / view.unitsPerM()), view.unitsPerM());
    paintNorthArrow(canvas, QRectF(foot.right() - 30 * pixelsPerPt, foot.top(), 30 * pixelsPerPt, footPx));
    return image;
}

QString describeShown(bool isShadow, bool onDate) {
    const QString unit = isShadow ? sheetText("minutes of shadow") : sheetText("hours of sun");
    return onDate ? unit + sheetText(" on this day") : sheetText("mean %1 a day").arg(unit);
}

constexpr std::size_t maxNumbered = 40;
constexpr double placeKeyPt = 6.8;

/// What a page with a map of places refers to besides the places.
struct PlacesScene {
    Region noRegion;  // the places stand for it
    PlaceMap map;
    std::optional<SheetMap> sheet{};
};

/// The number of each place in the table, from 1.
MapMark makeMark(const Place& place, std::size_t number) {
    const Footprint& largest =
        *std::ranges::max_element(place.polygons, {}, [](const Footprint& polygon) { return area(polygon); });
    return {findPointInside(largest), QString::number(number)};
}

/// "1 Elm Park   2 Mill Lane": the names of the numbers on a map.
QString describeKey(const SunByPlace& sun, const std::vector<std::size_t>& order) {
    constexpr qsizetype maxName = 40;
    QStringList names;
    for (std::size_t i = 0; i < std::min(maxNumbered, order.size()); ++i) {
        QString name = plainText(sun.places[order[i]].name);
        if (name.size() > maxName) name = name.left(maxName - 1) + QChar(0x2026);
        names << QStringLiteral("%1\u00a0%2").arg(i + 1).arg(name.replace(u' ', QChar(0x00a0)));
    }
    QString key = names.join(QStringLiteral("   "));
    if (order.size() > maxNumbered)
        key += sheetText("   Further places: table, %1 and on.").arg(maxNumbered + 1);
    return key;
}

// A saved result has no region.
Box2 groundOf(const SunByPlace& sun) {
    const Box2 region = bounds(sun.settings.study.region);
    return region.empty() ? bounds(sun.places) : region;
}

/// The places of a city, in the order of the table that lists them.
struct OrderedPlaces {
    const SunByPlace& sun;
    const std::vector<std::size_t>& order;
};

SheetMap makeSheetMap(const OrderedPlaces& of, const std::shared_ptr<PlacesScene>& scene) {
    SheetMap sheet{{of.sun.city, scene->noRegion, {}, {}}, scene->map.legend};
    sheet.scene.shown = groundOf(of.sun);
    sheet.scene.ground = [&sun = of.sun, map = scene.get()](const Canvas& canvas, const MapView& view) {
        paintPlaces(canvas, view, sun, map->map);
    };
    for (std::size_t i = 0; i < std::min(maxNumbered, of.order.size()); ++i)
        if (const Place& place = of.sun.places[of.order[i]]; !place.polygons.empty())
            sheet.scene.marks.push_back(makeMark(place, i + 1));
    return sheet;
}

// `shown`: in a sentence.
BookPage pageOf(const OrderedPlaces& of, PlaceMap map, const QString& title, const QString& when,
                const QString& shown, const PageSetup& setup) {
    QRectF area = contentArea(setup);
    BookPage page{title, when, sheetText("Map"), 0, {}};
    const double points = placeKeyPt * textScale(setup);
    constexpr double unit = MeasuringCanvas::unitsPerPoint;
    MeasuringCanvas measure;
    const TextBlocks key{body(describeKey(of.sun, of.order))};
    const double height = heightOf(measure.canvas(), key, area.width() * unit, points) / unit + 1;
    area.setHeight(area.height() - height - points);
    page.items.push_back(
        {{area.left(), area.bottom() + points, area.width(), height}, PageText{key, points}});
    auto scene = std::make_shared<PlacesScene>(PlacesScene{{}, std::move(map)});
    scene->sheet.emplace(makeSheetMap(of, scene));
    page.items.push_back(
        {area, PageMap{{scene, &*scene->sheet},
                       {sheetText("Places by their %1").arg(shown),
                        sheetText("Numbers as in the key and the table; a number that would cover another "
                                  "one is left out. Outlines without colour: places without figures.")}}});
    return page;
}

QString titleWith(const QString& title, const SunByPlace& sun) {
    return sun.name.empty() ? title : title + QStringLiteral(": ") + plainText(sun.name);
}

BookPage mapPage(const OrderedPlaces& of, const PlaceColours& colours, const PageSetup& setup) {
    const SunByPlace& sun = of.sun;
    const bool isShadow = chooseShown(sun, colours).isShadow;
    const QString title =
        isShadow ? sheetText("Minutes of shadow by place") : sheetText("Hours of sun by place");
    return pageOf(of, makeMap(sun, colours), titleWith(title, sun),
                  colours.date ? nameOfDate(sun, *colours.date) : describePeriod(sun.settings.study.period),
                  describeShown(isShadow, colours.date.has_value()), setup);
}

BookPage changePage(const ComparedSun& compared, const std::vector<std::size_t>& order,
                    const std::string& baseline, const PlaceColours& colours, const PageSetup& setup) {
    return pageOf({compared.sun, order}, makeChangeMap(compared, colours),
                  titleWith(sheetText("Change of sun by place"), compared.sun),
                  describePeriod(compared.sun.settings.study.period),
                  sheetText("change of mean sun a day against %1, minutes").arg(plainText(baseline)), setup);
}

bool hasRemarks(const SunByPlace& sun) {
    return std::ranges::any_of(sun.sun, [](const SunOfPlace& of) { return !listRemarks(of).empty(); });
}

// Of hours and areas with their unit, where the name of the figure does not end with it.
QString titleOf(const Figure& figure, const ShownSunOrShadow& shown) {
    if (const ShadowFigure* shadow = shown.isShadow ? findShadow(figure) : nullptr)
        return plainText(std::string(shadow->label)) + sheetText(", min");
    const QString label = sheetText(figure.label);
    if (figure.unit == FigureUnit::squareMetres) return label + QStringLiteral(", m²");
    if (figure.unit == FigureUnit::share) return label;
    return figure.unit == FigureUnit::minutesADay ? label + sheetText(", min")
                                                  : label + QStringLiteral(", h");
}

QString textOf(const Figure& figure, double value) {
    if (std::isnan(value)) return {};
    if (figure.unit == FigureUnit::share) return percentText(value);
    const int decimals = figure.unit == FigureUnit::squareMetres ? 0 : figure.shownDecimals;
    return fixedNumber(value, decimals);
}

// The change of the mean is the only one that has a column for each scenario.
const Figure& changeFigure() { return sunChangeFigures().rows().front(); }

// Of the figures with trees, too, the mean is the only one that has columns.
QString meanTitle(TreeColumns column, const ShownSunOrShadow& shown) {
    if (!shown.isShadow) return titleOf(sunFiguresWithTrees(column).front(), shown);
    return sheetText("%1, %2, min")
        .arg(sheetText(shadowOfPlaceFigures().front().label), sheetText(describeTrees(column)));
}

// In minutes, as the window states changes.
QString changeTitle(const ShownSunOrShadow& shown) {
    return shown.isShadow ? sheetText("Change of mean shadow, min")
                          : sheetText(changeFigure().label) + sheetText(", min");
}

QString changeText(double hours, const ShownSunOrShadow& shown) {
    if (std::isnan(hours)) return {};
    return plainText(formatSigned((shown.isShadow ? -minutesPerHour : minutesPerHour) * hours, 1));
}

// As hours or minutes, with the digits of the window.
QString timeText(double sunHours, const ShownSunOrShadow& shown) {
    if (std::isnan(sunHours)) return {};
    return shown.isShadow ? sheetNumbers(formatNumber(shown.of(sunHours), 0)) : hoursText(sunHours);
}

std::vector<QString> titlesOf(const SunOfCities& all, const ShownSunOrShadow& shown) {
    std::vector<QString> titles{sheetText("No."), sheetText("Place"), sheetText("Kind")};
    for (const Figure& figure : sunOfPlaceFigures().rows()) titles.push_back(titleOf(figure, shown));
    for (const SunWithTrees& with : shownCity(all).withTrees) titles.push_back(meanTitle(with.column, shown));
    for (const CivilDate& date : shownCity(all).settings.dates)
        titles.push_back(sheetText("Below, %1").arg(describeDates(date)));
    for (const ComparedSun& one : all.compared)
        titles.push_back(QStringLiteral("%1, %2").arg(changeTitle(shown), plainText(one.sun.name)));
    if (hasRemarks(shownCity(all))) titles.push_back(sheetText("Remarks"));
    return titles;
}

QString remarksOf(const SunOfPlace& of) {
    QStringList words;
    for (const std::string_view remark : listRemarks(of)) words << plainText(std::string(remark));
    return words.join(QStringLiteral("; "));
}

std::vector<QString> rowOf(const SunOfCities& all, std::size_t i, std::size_t number,
                           const ShownSunOrShadow& shown) {
    const SunByPlace& sun = shownCity(all);
    const SunOfPlace& of = sun.sun[i];
    std::vector<QString> row{QString::number(number), plainText(sun.places[i].name),
                             sheetText(nameOf(sun.places[i].kind))};
    for (const Figure& figure : sunOfPlaceFigures().rows())
        row.push_back(findShadow(figure) ? timeText(figure.get(&of), shown)
                                         : textOf(figure, figure.get(&of)));
    for (const SunWithTrees& with : sun.withTrees) row.push_back(timeText(with.sun[i].meanHours, shown));
    for (std::size_t date = 0; date < sun.settings.dates.size(); ++date)
        row.push_back(date < of.belowShare.size() ? percentText(of.belowShare[date]) : QString());
    for (const ComparedSun& one : all.compared) row.push_back(changeText(one.changes[i].meanHours, shown));
    if (hasRemarks(sun)) row.push_back(remarksOf(of));
    return row;
}

NamedTable tableOf(const SunOfCities& all, const std::vector<std::size_t>& order,
                   const ShownSunOrShadow& shown, std::size_t maxRows) {
    const std::size_t listed = std::min(order.size(), maxRows);
    NamedTable table{sheetText("Places"), {}, {titlesOf(all, shown), {}, {}}};
    const QString which = all.compared.empty() ? sheetText("with least sun")
                                               : sheetText("that lose most to the first scenario");
    table.note = order.size() == listed
                     ? sheetText("All %1, those %2 first.").arg(describeCount(order.size(), "place"), which)
                     : sheetText("The %1 of %2 %3; all of them are in places.csv.")
                           .arg(describeCount(listed), describeCount(order.size(), "place"), which);
    if (!all.compared.empty())
        table.note += sheetText(" The figures are those of %1; changes are from %2.")
                          .arg(scenarioText(shownCity(all).name), scenarioText(all.baseline.name));
    for (std::size_t i = 0; i < listed; ++i) table.table.rows.push_back(rowOf(all, order[i], i + 1, shown));
    return table;
}

// Without a scenario's name where there is one city.
NamedTable errorTableOf(const SunByPlace& sun, bool isNamed) {
    NamedTable table{sheetText("Errors against the ray reference, on a sample"), {}, {}};
    if (isNamed) table.title += QStringLiteral(": ") + plainText(sun.name);
    for (const char* title : {NM_TEXT("Figure"), NM_TEXT("Of"), NM_TEXT("Mean"), NM_TEXT("99 of 100 within"),
                              NM_TEXT("Largest"), NM_TEXT("Values")})
        table.table.titles.push_back(sheetText(title));
    for (const ShownError& error : sun.errors) {
        std::vector<QString> row{sheetText(error.facts.label), plainText(asOnSheets(error.of))};
        for (const double off : {error.mean, error.p99, error.largest})
            row.push_back(plainText(formatDifference(off, error.facts.unit)));
        row.push_back(describeCount(error.count));
        table.table.rows.push_back(std::move(row));
    }
    if (sun.errors.empty()) table.note = sheetText("Not measured.");
    return table;
}

std::vector<NamedTable> tablesOf(const SunOfCities& all, const ShownSunOrShadow& shown, std::size_t maxRows) {
    std::vector<NamedTable> tables{tableOf(all, sortByInterest(all), shown, maxRows),
                                   errorTableOf(sunOf(all), !all.compared.empty())};
    for (const ComparedSun& one : all.compared) tables.push_back(errorTableOf(one.sun, true));
    return tables;
}

}  // namespace

QImage paintPlacesMap(const SunByPlace& sun, const City& city, const PlaceColours& colours, int widthPx) {
    const SheetScope words;
    constexpr double widthPt = 540;  // of the texts' size: that of a picture in a page
    constexpr double marginPt = 14;
    Box2 shown;
    for (const Place& place : sun.places) shown.add(bounds(place));
    const glm::vec2 size = shown.high - shown.low;
    const double aspect = std::clamp(double(size.y) / double(size.x), 0.4, 1.6);
    return paintMap(sun, city, shown, makeMap(sun, colours),
                    {widthPt, (widthPt - 2 * marginPt) * aspect + legendHeightPt + 2 * marginPt},
                    widthPx / widthPt, marginPt);
}

std::vector<CommandOption> listColourOptions(const PlaceColours& colours) {
    std::vector<CommandOption> options = listLegendOptions(colours.legend, false);
    const std::string show(flagOf(legendFields().rows(), "show"));
    std::erase_if(options, [&](const CommandOption& one) { return one.name == show; });
    if (colours.legend.show != ShownAs::sun)
        options.push_back({show, {std::string(keyOf(shownChoices(), colours.legend.show))}});
    if (colours.thresholdHours)
        options.push_back({flags::threshold, {fmt::format("{:g}", *colours.thresholdHours)}});
    return options;
}

namespace {

/// Maps of scenarios and of dates, unless all pages are asked for.
constexpr std::size_t maxMapsOfKind = 6;

// As many rows as pages are left, unless all are asked for: names may be long, and rows several lines high.
std::vector<BookPage> makePlaceTables(const SunOfCities& all, const BookSettings& settings,
                                      const PlaceColours& colours, std::size_t pagesBefore) {
    const auto pagesOf = [&](std::size_t maxRows) {
        return makeTablePages(settings.setup, {sheetText("Places"), {}, sheetText("Places")},
                              tablesOf(all, chooseShown(shownCity(all), colours), maxRows));
    };
    constexpr std::size_t leastRows = 10;
    std::vector<BookPage> pages = pagesOf(maxRowsOfPlaces);
    for (std::size_t rows = maxRowsOfPlaces * 2 / 3;
         !settings.allPages && pagesBefore + pages.size() > BookSettings::defaultPages && rows >= leastRows;
         rows = rows * 2 / 3)
        pages = pagesOf(rows);
    return pages;
}

// Maps of what is shown, and what the tables list of all columns.
void addPlaces(Book& book, const SunOfCities& all, const SunOfCities& mapped, const BookSettings& settings,
               const PlaceColours& colours) {
    const SunByPlace &sun = sunOf(mapped), &shown = shownCity(mapped);
    const std::vector<std::size_t> order = sortByInterest(all);
    const OrderedPlaces places{shown, order};
    const auto limited = [&](std::size_t count) {
        return settings.allPages ? count : std::min(maxMapsOfKind, count);
    };
    book.pages.push_back(mapPage(places, colours, settings.setup));
    for (const ComparedSun& one : std::span(mapped.compared).first(limited(mapped.compared.size())))
        book.pages.push_back(changePage(one, order, sun.name, colours, settings.setup));
    PlaceColours ofDate = colours;
    for (std::size_t date = 0; date < limited(sun.settings.dates.size()); ++date) {
        ofDate.date = date;
        book.pages.push_back(mapPage(places, ofDate, settings.setup));
    }
    if (settings.heightMap)
        book.pages.push_back(makeHeightMapPage(shown.city, groundOf(shown), settings.setup));
    std::ranges::move(makePlaceTables(all, settings, colours, book.pages.size()),
                      std::back_inserter(book.pages));
}

void addSummary(Book& book, const TextBlocks& blocks) {
    std::ranges::move(makeTextPages(book.setup, {book.title, {}, sheetText("Summary")}, blocks),
                      std::back_inserter(book.pages));
}

}  // namespace

Book makeSunByPlaceBook(const SunOfCities& all, const BookSettings& settings, const PlaceColours& colours,
                        const SunOfCities* mapped) {
    const SheetScope words(settings.language);
    const SunByPlace& sun = sunOf(all);
    Book book = beginBook(settings, sheetText("Sun by place"), sun.provenance.attribution);
    book.record = {QStringLiteral("places.json"), inEnglish([&] {
                       return extendRepeat(toJson(sun, all.compared), listColourOptions(colours));
                   })};
    TextBlocks blocks = describeFinding(all, settings.units, colours.legend.show);
    const TextBlocks repeat = repeatBlocks(makeRepeatCommand(sun, all.compared, bookCharacters), false,
                                           listColourOptions(colours), bookCharacters);
    for (const TextBlocks& more : {describeMethod(all), repeat, describeSources(sun)})
        blocks.insert(blocks.end(), more.begin(), more.end());
    addSummary(book, blocks);
    addPlaces(book, all, mapped ? *mapped : all, settings, colours);
    return book;
}

Book makeSavedBook(const SavedResult& result, const SavedOrigin& origin, const SavedSource& source,
                   const SunOfCities& sun, const BookSettings& settings, const PlaceColours& colours,
                   const SunOfCities* mapped) {
    const SheetScope words(settings.language);
    Book book = beginBook(settings, sheetText("Sun by place"), attributionOf(result));
    book.record = {QStringLiteral("result.json"), result.settings};
    TextBlocks blocks = describeFinding(sun, settings.units, colours.legend.show);
    for (const TextBlocks& section : makeSavedSections(result, origin, source))
        blocks.insert(blocks.end(), section.begin(), section.end());
    addSummary(book, blocks);
    addPlaces(book, sun, mapped ? *mapped : sun, settings, colours);
    return book;
}

}  // namespace noonmark
