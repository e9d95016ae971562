#include "app/report/sheets/sheet.h"

#include <QFontMetricsF>
#include <QPdfWriter>
#include <algorithm>
#include <limits>
#include <utility>

#include "app/report/maps/legend_painter.h"
#include "app/report/maps/sheet_text.h"
#include "app/report/sheets/pdf_page.h"
#include "core/study/text/region_text.h"

namespace noonmark {

namespace {

constexpr double rowHeight = 1.62;  // times the font size

/// The font in which a text fits, at least three quarters as large.
QFont narrowFont(QFont font, const QString& text, double room) {
    constexpr double minShare = 0.75;
    const double width = QFontMetricsF(font).horizontalAdvance(text);
    if (width > room) font.setPixelSize(int(font.pixelSize() * std::max(minShare, room / width)));
    return font;
}

void paintRow(const Canvas& canvas, const QRectF& row, const FigureText& figure) {
    const QFont font = canvas.painter.font();
    const QFontMetricsF metrics(font);
    const double valueWidth = metrics.horizontalAdvance(figure.value);
    const double room = row.width() - valueWidth - metrics.averageCharWidth();
    canvas.painter.setPen(ink::text);
    canvas.painter.drawText(row, Qt::AlignRight | Qt::AlignVCenter, figure.value);
    const QFont smaller = narrowFont(font, figure.name, room);
    canvas.painter.setFont(smaller);
    // Names of figures differ at their ends.
    canvas.painter.drawText(row, Qt::AlignLeft | Qt::AlignVCenter,
                            QFontMetricsF(smaller).elidedText(figure.name, Qt::ElideMiddle, room));
    canvas.painter.setFont(font);
    canvas.painter.setPen(linePen(canvas, ink::line, 0.4));
    canvas.painter.drawLine(row.bottomLeft(), row.bottomRight());
}

/// Paints a table of names and values from the top of `area`, a hairline below each row, the first row in
/// bold. Values are right-aligned; a name that does not fit beside its value is smaller, then cut in its
/// middle. Returns
/// the y below the table.
double paintFigures(const Canvas& canvas, const QRectF& area, const std::vector<FigureText>& figures,
                    double points) {
    QRectF row(area.left(), area.top(), area.width(), rowHeight * points * canvas.point);
    for (std::size_t i = 0; i < figures.size(); ++i) {
        canvas.painter.setFont(textFont(canvas, points, i == 0 ? QFont::Bold : QFont::Normal));
        paintRow(canvas, row, figures[i]);
        row.translate(0, row.height());
    }
    return row.top();
}

constexpr double bottomPt = 24;
constexpr double gutterPt = 18;
constexpr double largeMapPt = 332;
constexpr double sideColumnPt = contentPt - largeMapPt - gutterPt;
constexpr double definitionPt = 6.6;
constexpr double findingPt = 9;
constexpr double figurePt = 7.4;
constexpr double maxTextPt = 8.2;
constexpr double minTextPt = 5.6;

std::pair<TextBlocks, TextBlocks> splitSections(const std::vector<TextBlocks>& sections, std::size_t split) {
    std::pair<TextBlocks, TextBlocks> columns;
    for (std::size_t i = 0; i < sections.size(); ++i) {
        TextBlocks& column = i < split ? columns.first : columns.second;
        column.insert(column.end(), sections[i].begin(), sections[i].end());
    }
    return columns;
}

class SheetPage {
public:
    SheetPage(QPainter& painter, const Sheet& sheet) : canvas_(pdfCanvas(painter)), sheet_(sheet) {}

    void paint() {
        paintHeadline(canvas_, area(sidePt, topPt, contentPt, headlineHeightPt), sheet_.headline);
        const double maps = paintFinding(topPt + headlineHeightPt + 2);
        const double below = std::max(paintLargeMap(maps), paintSideColumn(maps)) + 8;
        const double foot = pageHeightPt - bottomPt - 10;
        paintSmallPrint(canvas_, area(sidePt, foot, contentPt, 10), sheet_.credit);
        const double repeat = paintRepeat(below, foot - 4);
        paintText(below, repeat - 8);
    }

private:
    [[nodiscard]] QRectF area(double x, double y, double width, double height) const {
        return {x * canvas_.point, y * canvas_.point, width * canvas_.point, height * canvas_.point};
    }

    /// At least as wide as high, which leaves half of the page for text.
    [[nodiscard]] double mapAspect() const { return std::max(1.0, aspectOf(shownGround(sheet_.map.scene))); }

    /// Map, foot and definitions. Returns the y below them, points.
    double paintLargeMap(double top) {
        const double height = largeMapPt / mapAspect();
        const MapView view = makeMapView(sheet_.map.scene, area(sidePt, top, largeMapPt, height));
        paintMap(canvas_, view, sheet_.map.scene);
        const double foot = top + height + 8;
        paintMapFoot(canvas_, area(sidePt, foot, largeMapPt, legendHeightPt), view, sheet_.map.legend,
                     sheet_.map.scene);
        return paintDefinitions(foot + legendHeightPt + 2);
    }

    double paintDefinitions(double top) {
        const TextBlocks& blocks = sheet_.definitions;
        const double height =
            heightOf(canvas_, blocks, largeMapPt * canvas_.point, definitionPt) / canvas_.point;
        paintBlocks(canvas_, blocks, area(sidePt, top, largeMapPt, height), definitionPt);
        return top + height;
    }

    /// The answer in a sentence, across the page.
    double paintFinding(double top) {
        if (sheet_.finding.isEmpty()) return top;
        const TextBlocks blocks{heading(sheet_.finding)};
        const double height = heightOf(canvas_, blocks, contentPt * canvas_.point, findingPt) / canvas_.point;
        paintBlocks(canvas_, blocks, area(sidePt, top, contentPt, height + 1), findingPt);
        return top + height + 4;
    }

    double paintSideColumn(double top) {
        const double left = sidePt + largeMapPt + gutterPt;
        const double y = sheet_.smallMap ? paintSmallMap(*sheet_.smallMap, left, top) + 4 : top;
        return paintFigures(canvas_, area(left, y, sideColumnPt, 0), sheet_.figures, figurePt) /
               canvas_.point;
    }

    double paintSmallMap(const SheetMap& map, double left, double top) {
        const double height = sideColumnPt / mapAspect();
        const MapView view = makeMapView(map.scene, area(left, top, sideColumnPt, height));
        paintMap(canvas_, view, map.scene);
        paintLegend(canvas_, area(left, top + height + 8, sideColumnPt, legendHeightPt), map.legend);
        return top + height + 8 + legendHeightPt;
    }

    /// Paints at the bottom, at most a quarter of the remaining height; returns its top.
    double paintRepeat(double highest, double bottom) {
        const TextBlocks& blocks = sheet_.repeat;
        if (blocks.empty()) return bottom;
        const double width = contentPt * canvas_.point;
        const double room = (bottom - highest) / 4;
        const double points =
            fittingPoints(canvas_, blocks, {width, room * canvas_.point}, maxTextPt, minTextPt);
        const double height = std::min(room, heightOf(canvas_, blocks, width, points) / canvas_.point);
        paintBlocks(canvas_, blocks, area(sidePt, bottom - height, contentPt, height), points);
        rule(bottom - height - 4);
        return bottom - height - 4;
    }

    /// Two columns with the same font size; sections are not split.
    void paintText(double top, double bottom) {
        const double width = (contentPt - gutterPt) / 2;
        const QRectF left = area(sidePt, top, width, bottom - top);
        const QRectF right = area(sidePt + width + gutterPt, top, width, bottom - top);
        const auto [first, second] = columnsOf(left.width());
        const double points = std::min(fittingPoints(canvas_, first, left.size(), maxTextPt, minTextPt),
                                       fittingPoints(canvas_, second, right.size(), maxTextPt, minTextPt));
        paintBlocks(canvas_, first, left, points);
        paintBlocks(canvas_, second, right, points);
    }

    /// Keeps the sections in order and splits them where the columns are most even.
    [[nodiscard]] std::pair<TextBlocks, TextBlocks> columnsOf(double width) const {
        const std::vector<TextBlocks>& sections = sheet_.sections;
        std::pair<TextBlocks, TextBlocks> best;
        double bestHeight = std::numeric_limits<double>::max();
        for (std::size_t split = 1; split < sections.size(); ++split) {
            auto columns = splitSections(sections, split);
            const double height = std::max(heightOf(canvas_, columns.first, width, maxTextPt),
                                           heightOf(canvas_, columns.second, width, maxTextPt));
            if (height >= bestHeight) continue;
            bestHeight = height;
            best = std::move(columns);
        }
        return best;
    }

    void rule(double y) {
        canvas_.painter.setPen(linePen(canvas_, ink::line, 0.5));
        canvas_.painter.drawLine(area(sidePt, y, contentPt, 0).topLeft(),
                                 area(sidePt, y, contentPt, 0).topRight());
    }

    Canvas canvas_;
    const Sheet& sheet_;
};

}  // namespace

bool writePdf(const Sheet& sheet, QIODevice& device) {
    const SheetScope words;
    QPdfWriter writer(&device);
    beginPdf(writer, sheet.headline.what + QStringLiteral(", ") + sheet.headline.when);
    attachRecord(sheet.record, writer);
    QPainter painter;
    if (!painter.begin(&writer)) return false;
    SheetPage(painter, sheet).paint();
    return painter.end();
}

namespace {

constexpr double widthPt = 640;
constexpr double sheetMarginPt = 22;
constexpr double gapPt = 10;
constexpr double smallPrintPt = 12;

/// The areas of the picture from top to bottom, in pixels.
struct Places {
    QSize size;
    QRectF headline, map, foot, smallPrint;
};

Places placesOf(const MapScene& scene, int widthPx) {
    const double point = widthPx / widthPt;
    const double width = widthPt - 2 * sheetMarginPt;
    double y = sheetMarginPt;
    const auto next = [&](double height, double gap) {
        const QRectF area(sheetMarginPt * point, y * point, width * point, height * point);
        y += height + gap;
        return area;
    };
    Places places;
    places.headline = next(headlineHeightPt, 2);
    places.map = next(width / aspectOf(shownGround(scene)), gapPt);
    places.foot = next(legendHeightPt, 4);
    places.smallPrint = next(smallPrintPt, sheetMarginPt * 0.6);
    places.size = {widthPx, int(y * point)};
    return places;
}

}  // namespace

QImage makePicture(const Sheet& sheet, int width) {
    const SheetScope words;
    width = std::clamp(width, minPictureWidth, maxPictureWidth);
    const Places places = placesOf(sheet.map.scene, width);
    QImage image(places.size, QImage::Format_RGB32);
    image.fill(ink::paper);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    const Canvas canvas{painter, width / widthPt};
    const MapView view = makeMapView(sheet.map.scene, places.map);
    paintHeadline(canvas, places.headline, sheet.headline);
    paintMap(canvas, view, sheet.map.scene);
    paintMapFoot(canvas, places.foot, view, sheet.map.legend, sheet.map.scene);
    paintSmallPrint(canvas, places.smallPrint, sheet.credit);
    return image;
}

namespace {

/// Paints a line of text. If it is too long, the font shrinks by up to a quarter; then the text is cut.
void paintLine(const Canvas& canvas, const QRectF& area, double baselinePt, const QString& text,
               double points, QFont::Weight weight = QFont::Normal) {
    const double width = QFontMetricsF(textFont(canvas, points, weight)).horizontalAdvance(text);
    const double shrunk = width > area.width() ? std::max(0.75, 0.99 * area.width() / width) : 1;
    canvas.painter.setFont(textFont(canvas, points * shrunk, weight));
    const QString fitting =
        QFontMetricsF(canvas.painter.font()).elidedText(text, Qt::ElideRight, area.width());
    canvas.painter.drawText(QPointF(area.left(), area.top() + baselinePt * canvas.point), fitting);
}

}  // namespace

Headline makeHeadline(const Study& study, const QString& subject) {
    Headline headline = makeHeadline(study.settings, study.city.frame, subject, describeSunlit(study));
    if (const auto& project = study.provenance.project)
        headline.what += sheetText(", scenario ") + scenarioText(project->scenario.name);
    return headline;
}

Headline makeHeadline(const StudySettings& settings, const Frame& frame, const QString& subject,
                      const QString& sunlit) {
    const Region& region = settings.region;
    const QString named = regionText(nameOf(region));
    const QString name = named.isEmpty() ? named : QStringLiteral(": ") + named;
    const QString where =
        describePlace(region, frame) + (sunlit.isEmpty() ? QString() : QStringLiteral("; ") + sunlit);
    return {subject + name, describePeriod(settings.period), where};
}

void paintHeadline(const Canvas& canvas, const QRectF& area, const Headline& headline) {
    canvas.painter.setPen(ink::text);
    paintLine(canvas, area, 15, headline.what, 17, QFont::Bold);
    paintLine(canvas, area, 30, headline.when, 9.5);
    canvas.painter.setPen(ink::quiet);
    paintLine(canvas, area, 42, headline.where, 8.5);
}

void paintSmallPrint(const Canvas& canvas, const QRectF& area, const QString& credit) {
    canvas.painter.setFont(textFont(canvas, 7));
    canvas.painter.setPen(ink::quiet);
    const QFontMetricsF metrics(canvas.painter.font());
    const QString program = describeProgram();
    const double room = area.width() - metrics.horizontalAdvance(program) - 10 * canvas.point;
    canvas.painter.drawText(area, Qt::AlignLeft | Qt::AlignVCenter,
                            metrics.elidedText(credit, Qt::ElideRight, room));
    canvas.painter.drawText(area, Qt::AlignRight | Qt::AlignVCenter, program);
}

}  // namespace noonmark
