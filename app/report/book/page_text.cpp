#include "app/report/book/page_text.h"

#include <QTextLayout>
#include <algorithm>

#include "app/report/maps/sheet_text.h"
#include "scenarios/scenario.h"

namespace noonmark {

namespace {

constexpr double lineSpacing = 1.22;
constexpr double rowPaddingPt = 2.2;
constexpr double columnGapPt = 8;

double lineOf(const QFont& font) { return font.pixelSize() * lineSpacing; }

void breakLines(QTextLayout& layout, double width, double line, Qt::Alignment alignment) {
    QTextOption option(alignment);
    option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
    layout.setTextOption(option);
    layout.beginLayout();
    for (QTextLine one = layout.createLine(); one.isValid(); one = layout.createLine()) {
        one.setLineWidth(width);
        one.setPosition({0, line * one.lineNumber() + (line - one.height()) / 2});
    }
    layout.endLayout();
}

bool turnsDirection(QChar c) {
    const char16_t code = c.unicode();
    return (code >= 0x202a && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069);
}

/// As many letters of the text as fit, and an ellipsis.
QString cutToFit(const Canvas& canvas, const QString& text, const QFont& font, const QSizeF& size) {
    qsizetype low = 0, high = text.size();
    const QString dots = QStringLiteral("…");
    while (low < high) {
        const qsizetype middle = (low + high + 1) / 2;
        if (textHeight(canvas, text.left(middle) + dots, font, size.width()) <= size.height())
            low = middle;
        else
            high = middle - 1;
    }
    return text.left(low) + dots;
}

QFont cellFont(const Canvas& canvas, const PageTable& table, bool isTitle) {
    return textFont(canvas, table.points, isTitle ? QFont::Bold : QFont::Normal);
}

double cellWidth(const Canvas& canvas, const PageTable& table, std::size_t column) {
    const double mark = column == 0 && !table.marks.empty() ? table.points : 0;
    return (table.widthsPt[column] - columnGapPt - mark) * canvas.point;
}

/// Paints one row and the line below it; returns its lower edge.
double paintRow(const Canvas& canvas, const PageTable& table, const std::vector<QString>& texts, QPointF at,
                const QColor& mark, bool isTitle) {
    const double height = rowHeight(canvas, table, texts, isTitle), padding = rowPaddingPt * canvas.point;
    const QFont font = cellFont(canvas, table, isTitle);
    double x = at.x();
    for (std::size_t i = 0; i < texts.size(); ++i) {
        const double shift = i == 0 && !table.marks.empty() ? table.points * canvas.point : 0;
        paintLines(canvas, {x + shift, at.y() + padding, cellWidth(canvas, table, i), height}, texts[i], font,
                   isTitle ? ink::heading : ink::text);
        x += table.widthsPt[i] * canvas.point;
    }
    if (mark.isValid())
        canvas.painter.fillRect(QRectF(at.x(), at.y() + padding + 0.3 * font.pixelSize(),
                                       0.6 * font.pixelSize(), 0.6 * font.pixelSize()),
                                mark);
    canvas.painter.setPen(linePen(canvas, isTitle ? ink::heading : ink::line, isTitle ? 0.8 : 0.4));
    canvas.painter.drawLine(QPointF(at.x(), at.y() + height), QPointF(x, at.y() + height));
    return at.y() + height;
}

}  // namespace

QString plainLines(QString text) {
    text.removeIf(turnsDirection);
    for (QChar& c : text)
        if (c.category() == QChar::Other_Control && c != u'\n') c = u' ';
    return text;
}

QString plainText(QString text) {
    text = plainLines(std::move(text));
    text.replace(QChar::LineSeparator, u' ').replace(QChar::ParagraphSeparator, u' ');
    return text.simplified();
}

QString plainText(std::string_view text) {
    return plainText(QString::fromUtf8(text.data(), qsizetype(text.size())));
}

QString scenarioText(std::string_view name) {
    return name == existingCity ? sheetText(name) : plainText(name);
}

double textHeight(const Canvas& canvas, const QString& text, const QFont& font, double width) {
    QTextLayout layout(text, font, canvas.painter.device());
    breakLines(layout, width, lineOf(font), Qt::AlignLeft);
    return layout.lineCount() * lineOf(font);
}

double paintLines(const Canvas& canvas, const QRectF& area, const QString& text, const QFont& font,
                  const QColor& colour, Qt::Alignment alignment) {
    QTextLayout layout(text, font, canvas.painter.device());
    breakLines(layout, area.width(), lineOf(font), alignment);
    canvas.painter.setPen(colour);
    layout.draw(&canvas.painter, area.topLeft());
    return area.top() + layout.lineCount() * lineOf(font);
}

void paintFitted(const Canvas& canvas, const QRectF& area, const QString& text, double maximum,
                 double minimum, QFont::Weight weight, const QColor& colour, Qt::Alignment alignment) {
    if (text.isEmpty()) return;
    double points = maximum;
    const auto height = [&] {
        return textHeight(canvas, text, textFont(canvas, points, weight), area.width());
    };
    while (points > minimum && height() > area.height()) points = std::max(minimum, points - 0.2);
    const QFont font = textFont(canvas, points, weight);
    const double used = height();
    if (used > area.height()) {
        const QString cut = cutToFit(canvas, text, font, area.size());
        paintLines(canvas, area, cut, font, colour, alignment);
        return;
    }
    const double top = area.top() + (area.height() - used) / 2;
    paintLines(canvas, {area.left(), top, area.width(), used}, text, font, colour, alignment);
}

void paintCaption(const Canvas& canvas, const QRectF& area, const Caption& caption, double scale) {
    const double line = 11 * scale * canvas.point;
    const QRectF first(area.left(), area.top() + 1.5 * scale * canvas.point, area.width(), line);
    paintFitted(canvas, first, caption.first, 8 * scale, 4.5, QFont::Bold);
    paintFitted(canvas, first.translated(0, line), caption.second, 7 * scale, 4.2, QFont::Normal, ink::quiet);
}

double rowHeight(const Canvas& canvas, const PageTable& table, const std::vector<QString>& texts,
                 bool isTitle) {
    double height = 0;
    const QFont font = cellFont(canvas, table, isTitle);
    for (std::size_t i = 0; i < texts.size(); ++i)
        height = std::max(height, textHeight(canvas, texts[i], font, cellWidth(canvas, table, i)));
    return height + 2 * rowPaddingPt * canvas.point;
}

void paintTable(const Canvas& canvas, const QRectF& area, const PageTable& table) {
    double y = paintRow(canvas, table, table.titles, area.topLeft(), {}, true);
    for (std::size_t i = 0; i < table.rows.size(); ++i)
        y = paintRow(canvas, table, table.rows[i], {area.left(), y},
                     i < table.marks.size() ? table.marks[i] : QColor(), false);
}

}  // namespace noonmark
