#include "app/report/maps/legend_painter.h"

#include <QFontMetricsF>
#include <QLinearGradient>
#include <algorithm>
#include <cmath>

#include "app/report/maps/sheet_text.h"
#include "core/describe/text.h"
#include "core/engines/shade_trees.h"
#include "core/measures/shadow_figures.h"

namespace noonmark {

namespace {

constexpr double legendTitlePt = 8.5;
constexpr double legendLabelPt = 7.5;
constexpr double minTitleScale = 0.6;  // of a title that has little room
constexpr double barTopPt = 13;
constexpr double barHeightPt = 9;
constexpr double legendTickPt = 2.5;

// The leading parts of "min a day, scale locked: ±60 min" that fit; the page's text states the others.
QString fittingParts(QString unit, const QFontMetricsF& metrics, double room) {
    while (metrics.horizontalAdvance(unit) > room && unit.contains(QStringLiteral(", ")))
        unit.truncate(unit.lastIndexOf(QStringLiteral(", ")));
    return metrics.elidedText(unit, Qt::ElideRight, room);
}

// Of title and unit. Measured, since small letters are not as much narrower as they are lower.
double titleWidth(const Canvas& canvas, const Legend& legend, double scale) {
    const QString firstPart = describeUnit(legend).section(QStringLiteral(", "), 0, 0);
    return QFontMetricsF(textFont(canvas, legendTitlePt * scale, QFont::Bold))
               .horizontalAdvance(sheetWord(legend.title) + QStringLiteral("  ")) +
           QFontMetricsF(textFont(canvas, legendTitlePt * scale)).horizontalAdvance(firstPart);
}

void paintTitle(const Canvas& canvas, const QRectF& area, const Legend& legend) {
    QPainter& painter = canvas.painter;
    // A patch stands to the right of the title: what is too wide with its unit shrinks, and is cut at the
    // end.
    const QString unit = describeUnit(legend);
    double shrunk = 1;
    while (shrunk > minTitleScale && titleWidth(canvas, legend, shrunk) > area.width())
        shrunk = std::max(minTitleScale, shrunk - 0.05);
    const QFont bold = textFont(canvas, legendTitlePt * shrunk, QFont::Bold);
    const QString title =
        QFontMetricsF(bold).elidedText(sheetWord(legend.title), Qt::ElideRight, area.width());
    const double baseline = area.top() + legendTitlePt * canvas.point;
    painter.setFont(bold);
    painter.setPen(canvas.inks.text);
    painter.drawText(QPointF(area.left(), baseline), title);
    const double used = QFontMetricsF(bold).horizontalAdvance(title + QStringLiteral("  "));
    painter.setFont(textFont(canvas, legendTitlePt * shrunk));
    painter.setPen(canvas.inks.quiet);
    painter.drawText(QPointF(area.left() + used, baseline),
                     fittingParts(unit, QFontMetricsF(painter.font()), std::max(0.0, area.width() - used)));
}

QRectF barOf(const Canvas& canvas, const QRectF& area) {
    return {area.left(), area.top() + barTopPt * canvas.point, area.width(), barHeightPt * canvas.point};
}

QColor colourAt(const Legend& legend, double share) {
    const ColourScale colours = coloursOf(legend);
    return toColour(colours.colourOf(std::lerp(colours.low, colours.high, share)));
}

void paintBar(const Canvas& canvas, const QRectF& bar, const Legend& legend) {
    QLinearGradient gradient(bar.topLeft(), bar.topRight());
    constexpr int stops = 64;
    for (int i = 0; i <= stops; ++i) {
        const double share = double(i) / stops;
        gradient.setColorAt(share, colourAt(legend, share));
    }
    canvas.painter.setBrush(gradient);
    canvas.painter.setPen(linePen(canvas, canvas.inks.quiet, 0.4));
    canvas.painter.drawRect(bar);
}

// Ticks of a signed scale are counted from 0.
double lowOf(const Legend& legend) { return legend.colours && !legend.change ? legend.colours->low : 0; }

int ticksOf(const Legend& legend) {
    return std::max(1, int(std::lround((legend.scale.top - lowOf(legend)) / legend.scale.tick)));
}

QString numberText(const Legend& legend, double value, bool isSigned) {
    return (isSigned && value > 0 ? QStringLiteral("+") : QString()) +
           sheetNumbers(legend.numbers.toString(value, 'g', 6).toStdString());
}

// Labels along the bar, from left to right.
QStringList labelsOf(const Legend& legend) {
    const int ticks = ticksOf(legend);
    QStringList labels;
    for (int i = legend.change ? -ticks : 0; i <= ticks; ++i)
        labels << numberText(legend, lowOf(legend) + i * legend.scale.tick, legend.change);
    return labels;
}

/// Every how many ticks there is room for a label; the labels at the ends are the widest.
int labelStride(const Canvas& canvas, const QRectF& bar, const QStringList& labels) {
    const QFontMetricsF metrics(textFont(canvas, legendLabelPt));
    const double widest =
        std::max(metrics.horizontalAdvance(labels.front()), metrics.horizontalAdvance(labels.back()));
    const double needed =
        widest * 1.5 + 4 * canvas.point;  // the labels at the ends are moved inwards by half
    const double between = bar.width() / double(labels.size() - 1);
    return std::max(1, int(std::ceil(needed / between)));
}

void paintLabel(const Canvas& canvas, const QRectF& bar, double x, const QString& label) {
    const QFontMetricsF metrics(canvas.painter.font());
    const double width = metrics.horizontalAdvance(label);
    const double left = std::clamp(x - width / 2, bar.left(), bar.right() - width);
    canvas.painter.drawText(QPointF(left, bar.bottom() + (legendTickPt + legendLabelPt) * canvas.point),
                            label);
}

// On a signed scale labels are counted from the middle, so that 0 always has one.
void paintTicks(const Canvas& canvas, const QRectF& bar, const Legend& legend) {
    const QStringList labels = labelsOf(legend);
    const int ticks = int(labels.size()) - 1;
    const int stride = labelStride(canvas, bar, labels);
    const int first = legend.change ? ticks / 2 : 0;
    canvas.painter.setFont(textFont(canvas, legendLabelPt));
    for (int i = 0; i <= ticks; ++i) {
        const double x = bar.left() + bar.width() * i / ticks;
        canvas.painter.setPen(linePen(canvas, canvas.inks.quiet, 0.4));
        canvas.painter.drawLine(QPointF(x, bar.bottom()),
                                QPointF(x, bar.bottom() + legendTickPt * canvas.point));
        canvas.painter.setPen(canvas.inks.text);
        if ((i - first) % stride == 0) paintLabel(canvas, bar, x, labels[i]);
    }
}

void paintPatch(const Canvas& canvas, const QRectF& patch, const QColor& colour, const QString& label,
                double labelPt = legendLabelPt) {
    canvas.painter.setBrush(colour);
    canvas.painter.setPen(linePen(canvas, canvas.inks.quiet, 0.4));
    canvas.painter.drawRect(patch);
    canvas.painter.setFont(textFont(canvas, labelPt));
    canvas.painter.setPen(canvas.inks.text);
    canvas.painter.drawText(QPointF(patch.right() + 4 * canvas.point, patch.bottom() - 1.5 * canvas.point),
                            label);
}

void paintMoment(const Canvas& canvas, const QRectF& bar, const Legend& legend) {
    const bool change = legend.change;
    const QSizeF size(bar.height() * 2, bar.height());
    paintPatch(canvas, {bar.topLeft(), size}, colourAt(legend, 0),
               change ? sheetText("less shadow") : sheetText("in the sun"));
    paintPatch(canvas, {{bar.left() + bar.width() / 2, bar.top()}, size}, colourAt(legend, 1),
               change ? sheetText("more shadow") : sheetText("in shadow"));
}

// Patches from left to right, in a second row where the first has no room.
void paintClasses(const Canvas& canvas, const QRectF& bar, const std::vector<LegendPatch>& classes) {
    const QFontMetricsF metrics(textFont(canvas, legendLabelPt));
    const double gap = 10 * canvas.point;
    QPointF at = bar.topLeft();
    for (const LegendPatch& one : classes) {
        const double width =
            bar.height() * 1.6 + 4 * canvas.point + metrics.horizontalAdvance(sheetWord(one.label));
        if (at.x() > bar.left() && at.x() + width > bar.right())
            at = {bar.left(), at.y() + bar.height() + 3 * canvas.point};
        paintPatch(canvas, {at, QSizeF(bar.height() * 1.6, bar.height())}, one.colour, sheetWord(one.label));
        at.rx() += width + gap;
    }
}

// Equally wide fields, however unequal the classes are, with the numbers between them.
void paintColourClasses(const Canvas& canvas, const QRectF& bar, const Legend& legend) {
    const std::vector<ColourClass> classes = legend.colours->classes();
    const bool isSigned = legend.colours->of != ColourScale::Of::minutes;
    const double width = bar.width() / double(classes.size());
    canvas.painter.setFont(textFont(canvas, legendLabelPt));
    for (std::size_t i = 0; i < classes.size(); ++i) {
        const double left = bar.left() + double(i) * width;
        canvas.painter.setBrush(toColour(classes[i].colour));
        canvas.painter.setPen(linePen(canvas, canvas.inks.quiet, 0.4));
        canvas.painter.drawRect(QRectF(left, bar.top(), width, bar.height()));
        canvas.painter.setPen(canvas.inks.text);
        if (i > 0) paintLabel(canvas, bar, left, numberText(legend, classes[i].low, isSigned));
    }
}

// Paints the patches at the right end of the title line, smaller where the unit needs the room; returns their
// width.
double paintOwnColours(const Canvas& canvas, const QRectF& area, const Legend& legend) {
    const std::vector<LegendPatch>& patches = legend.patches;
    const double size = legendTitlePt * 0.9 * canvas.point;
    const auto widthAt = [&](double points) {
        const QFontMetricsF metrics(textFont(canvas, points));
        double width = 0;
        for (const LegendPatch& patch : patches)
            width += metrics.horizontalAdvance(sheetWord(patch.label)) + size * 1.6 + 12 * canvas.point;
        return width;
    };
    const double room = area.width() - titleWidth(canvas, legend, minTitleScale);
    const double labelPt = widthAt(legendLabelPt) > room ? legendLabelPt * minTitleScale : legendLabelPt;
    const QFontMetricsF metrics(textFont(canvas, labelPt));
    double x = area.right();
    for (auto patch = patches.rbegin(); patch != patches.rend(); ++patch) {
        x -= metrics.horizontalAdvance(sheetWord(patch->label)) + size * 1.6 + 12 * canvas.point;
        paintPatch(canvas, {x + 8 * canvas.point, area.top() + canvas.point, size * 1.6, size}, patch->colour,
                   sheetWord(patch->label), labelPt);
    }
    return area.right() - x;
}

}  // namespace

QString describeUnit(const Legend& legend) {
    QStringList parts{sheetWord(legend.unit)};
    for (const LegendNote& note : legend.notes)
        parts << (note.number.isEmpty() ? sheetWord(note.text)
                                        : sheetWord(note.text).arg(sheetNumbers(note.number.toStdString())));
    return parts.join(QStringLiteral(", "));
}

ShownQuantity quantityOf(ShadowMeasure measure, ShownAs show, double sunlitMin) {
    return {measure == ShadowMeasure::gross ? show : ShownAs::shadow, sunlitMin};
}

Legend makeLegend(ShadowMeasure measure, const LegendChoice& choice, double sunlitMin, double topMin,
                  std::span<const float> minutes) {
    const ShownQuantity quantity = quantityOf(measure, choice.show, sunlitMin);
    LegendChoice own = choice;
    if (choice.show != quantity.as) own = {quantity.as, choice.ramp, choice.reversed};
    Legend legend{nameOf(measure), describeMeasure(measure)};
    if (quantity.isSun()) {
        legend.title = QString::fromUtf8(quantity.title().data(), qsizetype(quantity.title().size()));
        legend.unit = QString::fromUtf8(quantity.unit().data(), qsizetype(quantity.unit().size()));
    }
    legend.colours = makeColourScale(own, quantity, topMin, minutes);
    legend.scale = {legend.colours->high, legend.colours->tick};
    return legend;
}

Legend momentLegend() {
    return {QStringLiteral(NM_TEXT("Shadow")), QStringLiteral(NM_TEXT("at this moment")), {1, 1}, true};
}

Legend makeLegend(const ShadowField& field, ShadowMeasure measure, const LegendChoice& choice) {
    if (isInstant(field)) return momentLegend();
    return makeLegend(measure, choice, field.sunlitMinutesPerDay, topOf(field, measure),
                      getValues(field, measure));
}

void nameTrees(Legend& legend, TreeColumns trees) {
    const std::string_view words = describeTrees(trees);
    legend.notes.insert(legend.notes.begin(), {QString::fromUtf8(words.data(), qsizetype(words.size()))});
}

Legend makeColumnLegend(const ShadowField& field, ShadowMeasure measure, const LegendChoice& choice) {
    const ShadowField& shown = fieldOfColumn(field, choice.trees);
    Legend legend = makeLegend(shown, measure, choice);
    if (field.trees) nameTrees(legend, &shown == &field ? TreeColumns::without : choice.trees);
    return legend;
}

ColourScale coloursOf(const Legend& legend) { return legend.colours.value_or(plainScale(legend.scale.top)); }

std::optional<QColor> pickColour(const ColourScale& scale, double minutes) {
    const auto colour = scale.pick(minutes);
    return colour ? std::optional(toColour(*colour)) : std::nullopt;
}

void paintLegend(const Canvas& canvas, const QRectF& area, const Legend& legend) {
    canvas.painter.save();
    canvas.painter.setRenderHint(QPainter::Antialiasing);
    const QRectF bar = barOf(canvas, area);
    const double patches = paintOwnColours(canvas, area, legend);
    paintTitle(canvas, area.adjusted(0, 0, -patches, 0), legend);
    if (!legend.classes.empty()) {
        paintClasses(canvas, bar, legend.classes);
    } else if (legend.instant) {
        paintMoment(canvas, bar, legend);
    } else if (legend.colours && !legend.colours->breaks.empty()) {
        paintColourClasses(canvas, bar, legend);
    } else {
        paintBar(canvas, bar, legend);
        paintTicks(canvas, bar, legend);
    }
    canvas.painter.restore();
}

}  // namespace noonmark
