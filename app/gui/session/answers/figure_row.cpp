#include "app/gui/session/answers/result_rows.h"

#include <QObject>
#include <cmath>

#include "app/gui/base/looks/units.h"
#include "app/gui/base/widgets/number_words.h"
#include "app/gui/base/widgets/translated.h"

namespace noonmark {

namespace {

QString labelText(const FigureLine& line) {
    const QString label = translated(line.figure->label);
    if (line.measure.empty()) return label;
    const QString measure = translated(line.measure);
    return line.thresholdMin ? QObject::tr("%1 > %2 min: %3").arg(measure).arg(*line.thresholdMin).arg(label)
                             : QObject::tr("%1: %2").arg(measure, label);
}

QString valueText(const FigureLine& line) {
    QString text = QString::fromStdString(valueOf(line, unitsInUse()));
    if (std::isnan(line.value)) return translated(text.toStdString());
    const std::string unit(unitText(line.figure->unit));
    if (!unit.empty()) text.replace(QString::fromStdString(unit), translated(unit));
    return localiseNumbers(text);
}

}  // namespace

std::vector<ResultRow> figureRows(const std::vector<FigureLine>& lines) {
    std::vector<ResultRow> rows;
    for (const FigureLine& line : lines)
        rows.push_back({labelText(line), valueText(line), translatedSentence(line.figure->definition)});
    return rows;
}

QString joinFigures(const std::vector<FigureLine>& lines) {
    QStringList words;
    for (const FigureLine& line : lines) words << labelText(line) + QLatin1Char(' ') + valueText(line);
    return words.join(QStringLiteral(", "));
}

QString headingOf(const Figure& figure) {
    const std::string_view unit = unitText(figure.unit);
    const QString label = translated(figure.label);
    return unit.empty() ? label : label + QLatin1Char(',') + translated(unit);
}

}  // namespace noonmark
