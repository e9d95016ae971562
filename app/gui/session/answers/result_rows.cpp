#include "app/gui/session/answers/result_rows.h"

#include <QObject>
#include <cmath>

#include "app/gui/base/looks/units.h"
#include "app/gui/base/widgets/error_text.h"
#include "app/gui/base/widgets/name_text.h"
#include "app/gui/base/widgets/number_text.h"
#include "app/gui/session/study/region_text.h"
#include "scenarios/scenario.h"

namespace noonmark {

namespace {

QString labelText(const FigureLine& line) {
    const QString label = translated(line.figure->label);
    if (line.measure.empty()) return label;
    const QString measure = translated(line.measure);
    return line.thresholdMin ? QObject::tr("%1 > %2 min: %3").arg(measure).arg(*line.thresholdMin).arg(label)
                             : QObject::tr("%1: %2").arg(measure, label);
}

// `value`: as core writes it.
QString localised(const std::string& value, double number, FigureUnit of) {
    if (std::isnan(number)) return translated(value);
    QString text = QString::fromStdString(value);
    const std::string unit(unitText(of));
    if (!unit.empty()) text.replace(QString::fromStdString(unit), translated(unit));
    return localiseNumbers(text);
}

QString valueText(const FigureLine& line) {
    return localised(valueOf(line, unitsInUse()), line.value, line.figure->unit);
}

// The user's stay as they are; a rule of the program has its name in every language.
QString argumentName(const std::string& name) {
    if (name == existingCity) return scenarioName(name);
    const QString place = placeName(name);
    return place == QString::fromStdString(name) ? ruleName(name) : place;
}

std::string argumentText(const Sentence::Argument& argument) {
    const auto* amount = std::get_if<Amount>(&argument);
    if (!amount) return argumentName(std::get<std::string>(argument)).toStdString();
    return localised(valueOf(*amount, unitsInUse()), amount->value, amount->unit).toStdString();
}

}  // namespace

std::vector<ResultRow> figureRows(const std::vector<FigureLine>& lines) {
    std::vector<ResultRow> rows;
    for (const FigureLine& line : lines)
        rows.push_back({labelText(line), valueText(line), translatedSentence(line.figure->definition),
                        line.figure->use == FigureUse::basis});
    return rows;
}

QString joinFigures(const std::vector<FigureLine>& lines) {
    QStringList words;
    for (const FigureLine& line : lines) words << labelText(line) + QLatin1Char(' ') + valueText(line);
    return words.join(QStringLiteral(", "));
}

QString sentenceText(const Sentence& sentence) {
    std::vector<std::string> values;
    for (const Sentence::Argument& argument : sentence.arguments) values.push_back(argumentText(argument));
    QString text = QString::fromStdString(fillIn(translated(sentence.source).toStdString(), values));
    if (!text.isEmpty()) text[0] = text[0].toUpper();
    return text;
}

void addErrors(std::vector<ResultRow>& rows, std::span<const ShownError> errors) {
    for (const ShownError& error : errors) {
        const QString label = translated(error.facts.label);
        const QString name =
            error.of.empty() ? label : QStringLiteral("%1, %2").arg(label, QString::fromStdString(error.of));
        rows.push_back(methodRow(QObject::tr("Error: %1").arg(name), sentenceText(describe(error)),
                                 QObject::tr("Against the ray reference, of a sample of %1 value(s)", "",
                                             pluralNumber(error.count))
                                     .arg(formatCount(error.count))));
    }
}

ResultRow methodRow(const QString& name, const QString& value, const QString& meaning) {
    return {name, value, meaning, true};
}

QString headingOf(const Figure& figure) {
    const std::string_view unit = unitText(figure.unit);
    const QString label = translated(figure.label);
    return unit.empty() ? label : label + QLatin1Char(',') + translated(unit);
}

}  // namespace noonmark
