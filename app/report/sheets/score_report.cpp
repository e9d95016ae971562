#include "app/report/sheets/score_report.h"

#include <QStringList>

#include "app/report/maps/score_legend.h"
#include "app/report/sheets/report_sections.h"
#include "core/receivers/roof_receivers.h"
#include "core/study/provenance/command_words.h"
#include "scenarios/settings_json.h"
#include "scenarios/weights/score_figures.h"

namespace noonmark {

namespace {

QString monthName(std::chrono::year_month month) {
    return QStringLiteral("%1-%2").arg(int(month.year())).arg(unsigned(month.month()), 2, 10, QChar(u'0'));
}

// The month's part of what the lines above it state of the region, in their order.
QString describePart(const MonthFigures& month) {
    QStringList parts;
    for (const Figure& total : scoreFigures().rows())
        if (total.use == FigureUse::result && total.inFiles) {
            const Figure& part = findFigure(scoreMonthFigures().rows(), total.key);
            parts << QString::fromStdString(valueOf({&part, part.get(&month)}));
        }
    return parts.join(QStringLiteral(", "));
}

TextBlocks definitionsOf(const Score& score) {
    return {body(defineFigures(listLines(scoreFigures().of(score))) +
                 QStringLiteral(" Positive means that wanted shade outweighs unwanted shadow. The figures of "
                                "the months add up to the total."))};
}

TextBlocks methodOf(const ScoreAnswer& answer) {
    return {heading(QStringLiteral("Method")),
            body(QStringLiteral("Engine: %1.").arg(describeEngineUsed(answer.score.engine))),
            body(QStringLiteral("Receivers: centres of square cells of %1 m on %2, inside the region.")
                     .arg(describeAmount(answer.score.grid.cellM, 2),
                          QString::fromUtf8(describe(answer.settings.receivers.places))))};
}

// Intervals without a sun step have neither area nor score and are skipped.
TextBlocks weightsOf(const ScoreAnswer& answer) {
    TextBlocks blocks{
        heading(QStringLiteral("Weights: %1").arg(QString::fromStdString(answer.weights.name)))};
    for (const IntervalFigures& interval : answer.score.intervals)
        if (interval.shadowAreaM2 > 0)
            blocks.push_back(body(QStringLiteral("%1: %2").arg(
                QString::fromStdString(interval.name),
                QString::fromStdString(joinLines(listLines(scoreIntervalFigures().of(interval)))))));
    return blocks;
}

// The sections of a study's report that do not depend on its field.
std::vector<TextBlocks> sourcesOf(const ScoreAnswer& answer, const AnswerSource& source,
                                  const std::vector<CommandOption>& drawn) {
    Study study;
    study.city = source.city;
    study.settings = answer.settings;
    study.warnings = answer.score.warnings;
    study.provenance = answer.provenance;
    std::vector<TextBlocks> sections = sourceSections(study);
    sections.pop_back();  // cost and skipped work belong to a field
    sections.push_back(
        repeatBlocks(makeRepeatCommand(answer, columnLetters), needsRegionFile(answer.provenance), drawn));
    return sections;
}

}  // namespace

SheetMap makeScoreMap(const Score& score, const City& city, const Region& region,
                      const LegendChoice& choice) {
    const Legend legend = makeLegend(score, choice);
    return {{city, region, score.grid,
             [&score, colours = coloursOf(legend)](int wantedPixels) {
                 const auto colour = [&](std::size_t cell) {
                     return pickColour(colours, double(score.score[cell]));
                 };
                 return makeColourImage(score.grid, colour, wantedPixels);
             }},
            legend};
}

std::vector<FigureText> makeScoreFigures(const Score& score) {
    std::vector<FigureText> figures = figureTexts(listLines(scoreFigures().of(score)));
    for (const MonthFigures& month : score.months)
        figures.push_back({monthName(month.month), describePart(month)});
    return figures;
}

Sheet makeSheet(const ScoreAnswer& answer, const AnswerSource& source, const LegendChoice& legend) {
    const QString subject = QStringLiteral("Shadow score of %1").arg(QString::fromStdString(answer.scenario));
    std::vector<TextBlocks> sections{methodOf(answer), errorBlocks(answer.score.errors), weightsOf(answer)};
    for (TextBlocks& section : sourcesOf(answer, source, listLegendOptions(legend, true)))
        sections.push_back(std::move(section));
    return {.headline = makeHeadline(answer.settings, source.city.frame, subject, {}),
            .map = makeScoreMap(answer.score, source.city, answer.settings.region, legend),
            .definitions = definitionsOf(answer.score),
            .figures = makeScoreFigures(answer.score),
            .sections = std::move(sections),
            .credit = describeData(answer.provenance.attribution),
            .record = {QStringLiteral("score.json"),
                       extendRepeat(scoreJson(answer), listLegendOptions(legend, true))}};
}

}  // namespace noonmark
