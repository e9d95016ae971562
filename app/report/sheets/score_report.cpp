#include "app/report/sheets/score_report.h"

#include <algorithm>
#include <cmath>

#include "app/report/maps/score_legend.h"
#include "app/report/sheets/report_sections.h"
#include "core/receivers/roof_receivers.h"
#include "scenarios/settings_json.h"
#include "scenarios/weights/score_figures.h"

namespace noonmark {

namespace {

QString signedArea(double areaM2) {
    return (areaM2 > 0 ? QStringLiteral("+") : QString()) + describeAmount(areaM2, 0) + QStringLiteral(" m²");
}

QString signedShade(double shadeM2h) {
    if (std::isnan(shadeM2h)) return QStringLiteral("not counted");
    return (shadeM2h > 0 ? QStringLiteral("+") : QString()) + describeAmount(shadeM2h, 0) +
           QStringLiteral(" m² h");
}

QString monthName(std::chrono::year_month month) {
    return QStringLiteral("%1-%2").arg(int(month.year())).arg(unsigned(month.month()), 2, 10, QChar(u'0'));
}

QString definitionOf(std::string_view key) {
    const std::string_view text = findFigure(scoreFigures().rows(), key).definition;
    return QString::fromUtf8(text.data(), qsizetype(text.size()));
}

TextBlocks definitions() {
    return {body(
        QStringLiteral("Weighted shade: %1. Score: %2. Positive means that wanted shade outweighs unwanted "
                       "shadow. The figures of the months add up to the total.")
            .arg(definitionOf("weighted_shade_m2h"), definitionOf("score_m2")))};
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
            blocks.push_back(
                body(QStringLiteral("%1 × %2: %3 weighted, %4 m² shadow, score %5")
                         .arg(QString::fromStdString(interval.name), describeAmount(interval.weight, 3),
                              signedShade(interval.weightedShadeM2h),
                              describeAmount(interval.shadowAreaM2, 0), signedArea(interval.scoreM2))));
    return blocks;
}

// The sections of a study's report that do not depend on its field.
std::vector<TextBlocks> sourcesOf(const ScoreAnswer& answer, const AnswerSource& source) {
    Study study;
    study.city = source.city;
    study.settings = answer.settings;
    study.warnings = answer.score.warnings;
    study.provenance = answer.provenance;
    std::vector<TextBlocks> sections = sourceSections(study);
    sections.pop_back();  // cost and skipped work belong to a field
    sections.push_back(
        repeatBlocks(makeRepeatCommand(answer, columnLetters), needsRegionFile(answer.provenance)));
    return sections;
}

}  // namespace

SheetMap makeScoreMap(const Score& score, const City& city, const Region& region) {
    const Legend legend = makeLegend(score);
    const double top = legend.scale.top;
    return {{city, region, score.grid,
             [&score, top](int wantedPixels) {
                 const auto colour = [&](std::size_t cell) { return pickColour(score, cell, top); };
                 return makeColourImage(score.grid, colour, wantedPixels);
             }},
            legend};
}

std::vector<FigureText> makeScoreFigures(const Score& score) {
    const double perArea = score.scoreM2 / std::max(1.0, score.receiverAreaM2);
    std::vector<FigureText> figures{
        {QStringLiteral("Weighted shade"), signedShade(score.weightedShadeM2h)},
        {QStringLiteral("Shadow score"), signedArea(score.scoreM2)},
        {QStringLiteral("per m² of ground"), QString::number(perArea, 'f', 3)},
        {QStringLiteral("Receivers"), describeAmount(score.receiverAreaM2, 0) + QStringLiteral(" m²")}};
    if (score.waterM2 > 0)
        figures.push_back(
            {QStringLiteral("Water left out"), describeAmount(score.waterM2, 0) + QStringLiteral(" m²")});
    for (const MonthFigures& month : score.months)
        figures.push_back(
            {monthName(month.month),
             signedShade(month.weightedShadeM2h) + QStringLiteral(", score ") + signedArea(month.scoreM2)});
    return figures;
}

Sheet makeSheet(const ScoreAnswer& answer, const AnswerSource& source) {
    const QString subject = QStringLiteral("Shadow score of %1").arg(QString::fromStdString(answer.scenario));
    std::vector<TextBlocks> sections{methodOf(answer), weightsOf(answer)};
    for (TextBlocks& section : sourcesOf(answer, source)) sections.push_back(std::move(section));
    return {.headline = makeHeadline(answer.settings, source.city.frame, subject, {}),
            .map = makeScoreMap(answer.score, source.city, answer.settings.region),
            .definitions = definitions(),
            .figures = makeScoreFigures(answer.score),
            .sections = std::move(sections),
            .credit = describeData(answer.provenance.attribution),
            .record = {QStringLiteral("score.json"), scoreJson(answer)}};
}

}  // namespace noonmark
