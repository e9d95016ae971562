#include "app/report/sheets/headline.h"

#include <QFontMetricsF>
#include <algorithm>

#include "app/report/sheets/period_words.h"
#include "app/report/sheets/study_words.h"
#include "core/study/text/region_text.h"

namespace noonmark {

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
        headline.what += QStringLiteral(", scenario ") + QString::fromStdString(project->scenario.name);
    return headline;
}

Headline makeHeadline(const StudySettings& settings, const Frame& frame, const QString& subject,
                      const QString& sunlit) {
    const Region& region = settings.region;
    const QString named = QString::fromStdString(nameOf(region));
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
