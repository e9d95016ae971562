#include "app/report/sheets/text_column.h"

#include <QRegularExpression>
#include <QTextLayout>
#include <algorithm>
#include <memory>
#include "app/report/maps/sheet_text.h"

namespace noonmark {

namespace {

constexpr double lineSpacing = 1.24;  // times the font size
constexpr double gapAbove = 0.3;      // between paragraphs, times the size of body text
constexpr double gapAboveHeading = 0.9;
constexpr double sizeStepPt = 0.2;

struct Type {
    QFont font;
    QColor colour;
    double line;  // from baseline to baseline, painter units
    double gap;   // above the paragraph
};

Type typeOf(const Canvas& canvas, TextKind kind, double points) {
    const double unit = canvas.point * points;
    switch (kind) {
        case TextKind::heading:
            return {textFont(canvas, points * 1.1, QFont::Bold), ink::heading, unit * 1.1 * lineSpacing,
                    unit * gapAboveHeading};
        case TextKind::code:
            return {codeFont(canvas, points * 0.75), ink::text, unit * 0.85 * lineSpacing, unit * gapAbove};
        case TextKind::body:
            break;
    }
    return {textFont(canvas, points), ink::text, unit * lineSpacing, unit * gapAbove};
}

/// One paragraph, broken into lines of a width; `top` is its offset from the top of the column.
class Paragraph {
public:
    Paragraph(const Canvas& canvas, const QString& text, const Type& type, double width, double top)
        : layout_(std::make_unique<QTextLayout>(text, type.font, canvas.painter.device())),
          colour_(type.colour),
          line_(type.line),
          top_(top) {
        QTextOption option;
        option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
        layout_->setTextOption(option);
        layout_->beginLayout();
        for (QTextLine line = layout_->createLine(); line.isValid(); line = layout_->createLine()) {
            line.setLineWidth(width);
            line.setPosition({0, line_ * line.lineNumber() + (line_ - line.height()) / 2});
        }
        layout_->endLayout();
    }

    [[nodiscard]] double bottom() const { return top_ + line_ * layout_->lineCount(); }

    /// Paints the lines that end at or above `limit`. Returns the bottom of the last one, or `top` if there
    /// is none.
    double paint(QPainter& painter, const QPointF& column, double limit) const {
        double bottom = 0;
        painter.setPen(colour_);
        for (int i = 0; i < layout_->lineCount() && top_ + line_ * (i + 1) <= limit; ++i) {
            layout_->lineAt(i).draw(&painter, column + QPointF(0, top_));
            bottom = top_ + line_ * (i + 1);
        }
        return bottom;
    }

private:
    std::unique_ptr<QTextLayout> layout_;
    QColor colour_;
    double line_;
    double top_;
};

std::vector<Paragraph> broken(const Canvas& canvas, const TextBlocks& blocks, double width, double points) {
    std::vector<Paragraph> paragraphs;
    for (const TextBlock& block : blocks) {
        const Type type = typeOf(canvas, block.kind, points);
        const double top = paragraphs.empty() ? 0 : paragraphs.back().bottom() + type.gap;
        paragraphs.emplace_back(canvas, block.text, type, width, top);
    }
    return paragraphs;
}

double heightOf(const std::vector<Paragraph>& paragraphs) {
    return paragraphs.empty() ? 0 : paragraphs.back().bottom();
}

double paintUpTo(QPainter& painter, const std::vector<Paragraph>& paragraphs, const QPointF& column,
                 double limit) {
    double bottom = 0;
    for (const Paragraph& paragraph : paragraphs)
        bottom = std::max(bottom, paragraph.paint(painter, column, limit));
    return bottom;
}

}  // namespace

TextBlock heading(const QString& text) { return {TextKind::heading, text}; }

TextBlock body(QString text) {
    static const QRegularExpression unit(
        QStringLiteral("(?<=\\d) (?=(min|m|m²|h|s|hPa|°C|%|N|S|E|W)\\b|°C|%)"));
    return {TextKind::body, text.replace(unit, QString(QChar::Nbsp))};
}

double heightOf(const Canvas& canvas, const TextBlocks& blocks, double width, double points) {
    return heightOf(broken(canvas, blocks, width, points));
}

double fittingPoints(const Canvas& canvas, const TextBlocks& blocks, const QSizeF& size, double maximum,
                     double minimum) {
    for (double points = maximum; points > minimum; points -= sizeStepPt)
        if (heightOf(canvas, blocks, size.width(), points) <= size.height()) return points;
    return minimum;
}

double paintBlocks(const Canvas& canvas, const TextBlocks& blocks, const QRectF& area, double points) {
    const auto paragraphs = broken(canvas, blocks, area.width(), points);
    const double slack = 1e-6 * area.height();
    if (heightOf(paragraphs) <= area.height() + slack)
        return area.top() + paintUpTo(canvas.painter, paragraphs, area.topLeft(), area.height() + slack);
    const Type type = typeOf(canvas, TextKind::body, points);
    const double bottom = paintUpTo(canvas.painter, paragraphs, area.topLeft(), area.height() - type.line);
    const Paragraph rest(canvas, sheetText("... the rest is in the JSON file"), type, area.width(), bottom);
    return area.top() + rest.paint(canvas.painter, area.topLeft(), area.height() + slack);
}

}  // namespace noonmark
