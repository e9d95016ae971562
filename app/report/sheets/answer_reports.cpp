#include "app/report/sheets/answer_reports.h"

#include <QStringList>
#include <algorithm>
#include <cmath>

#include "app/report/maps/sheet_text.h"
#include "app/report/sheets/report_sections.h"
#include "core/base/safe_text.h"
#include "core/receivers/rasterize.h"
#include "core/receivers/roof_receivers.h"
#include "core/study/provenance/command_text.h"
#include "scenarios/impact/impact_figures.h"
#include "scenarios/impact/proposal_region.h"
#include "scenarios/settings_json.h"

namespace noonmark {

namespace {

QString describeArea(double areaM2) { return describeAmount(areaM2, 0) + QStringLiteral(" m²"); }

TextBlocks definitionsOf(const ImpactAnswer& answer, const ChangeScale& scale, const LegendChoice& legend) {
    const auto unitOf = [&](ShadowMeasure measure) {
        return describeUnit(makeLegend(answer.study.total, measure, scale, legend));
    };
    const bool isSun = legend.show != ShownAs::shadow;
    return {body(sheetText("Colours: %1 in %2; continuous shadow in %3.")
                     .arg(isSun ? sheetText("sun") : sheetText("gross shadow"), unitOf(ShadowMeasure::gross),
                          unitOf(ShadowMeasure::continuous))),
            body(sheetText("Change: minutes in %1 minus minutes in %2, with the same engine, steps and "
                           "cells; positive means more %3. %4")
                     .arg(scenarioText(answer.to), scenarioText(answer.from),
                          isSun ? sheetText("sun") : sheetText("shadow"),
                          defineFigures(listLines(computeFigures(answer), legend.show))))};
}

// The city after the change as a study, for the sections of a study's report. Their statements hold for both
// fields.
Study afterAsStudy(const ImpactAnswer& answer, const AnswerSource& source) {
    Study study;
    study.city = source.city;
    study.settings = answer.settings.study;
    study.sun = answer.study.sun;
    study.field = answer.study.after;
    study.field.engine = answer.study.total.engine;
    study.warnings = answer.study.total.warnings;
    study.error = answer.study.error;
    study.provenance = answer.provenance;
    return study;
}

// One line per new building, if the comparison measured them.
void addBuildings(std::vector<TextBlocks>& sections, const ComparisonFigures& figures) {
    if (figures.byBuilding.empty()) return;
    TextBlocks blocks{
        heading(sheetText("Sole contribution of each new building: against the scenario without it"))};
    for (const auto& building : figures.byBuilding)
        blocks.push_back(body(sheetText("%1: %2 with more than %3 min a day of additional gross shadow")
                                  .arg(QString::fromStdString(building.name),
                                       describeArea(building.figures.gross.moreShadowM2),
                                       describeAmount(building.figures.thresholdMin, 2))));
    sections.push_back(std::move(blocks));
}

std::vector<TextBlocks> sectionsOf(const ImpactAnswer& answer, const AnswerSource& source,
                                   const std::vector<CommandOption>& drawn) {
    const Study after = afterAsStudy(answer, source);
    std::vector<TextBlocks> sections = methodSections(
        after, sheetText("This is the error of the change, compared with the change by the ray reference."));
    addBuildings(sections, computeFigures(answer));
    for (TextBlocks& section : sourceSections(after)) sections.push_back(std::move(section));
    sections.push_back(
        repeatBlocks(makeRepeatCommand(answer, columnCharacters), needsRegionFile(answer.provenance), drawn));
    return sections;
}

/// Cells whose shadow changes by more than the threshold, and what is built.
Box2 changedGround(const ImpactAnswer& answer, double thresholdMin) {
    const Impact& impact = answer.study.total;
    Box2 box = bounds(answer.proposal);
    box.add(bounds(answer.removed));
    const Grid& grid = impact.grid;
    for (std::size_t cell = 0; cell < grid.size(); ++cell) {
        if (std::abs(double(impact.grossMin[cell])) > thresholdMin)  // NaN: no receiver
            box.add(cellBox(grid, cell));
    }
    return box;
}

/// A change that belongs on the map: one that can be seen there. The question's threshold may be higher.
double mappedChangeMin(const ImpactAnswer& answer) {
    constexpr double seenMin = 5;
    double largest = 0;
    for (const float change : answer.study.total.grossMin)
        if (!std::isnan(change)) largest = std::max(largest, std::abs(double(change)));
    const double threshold =
        answer.settings.thresholdsMin.empty() ? 0 : answer.settings.thresholdsMin.front();
    return std::min({threshold, largest / 10, seenMin});
}

void zoomOnChange(const ImpactAnswer& answer, SheetMap& map) {
    map.scene.shown = zoomOn(changedGround(answer, mappedChangeMin(answer)), map.scene);
    if (!answer.proposal.buildings.empty()) map.scene.proposal = &answer.proposal;
    map.scene.removed = findAbsent(answer.removed, answer.proposal);
}

/// Rows for the new buildings: "New building", "Mill Tower, 62 m high".
void addNewBuildings(std::vector<FigureText>& figures, const City& proposal) {
    constexpr std::size_t maximum = 3;
    for (std::size_t i = 0; i < std::min(maximum, proposal.buildings.size()); ++i) {
        const Building& building = *proposal.buildings[i];
        const Box2 box = bounds(building);
        const double height =
            double(topM(building)) - double(groundAt(proposal, glm::dvec2(box.low + box.high) / 2.0));
        const std::string& name = building.name.empty() ? building.sourceId : building.name;
        figures.push_back({sheetText("New building"),
                           sheetText("%1, %2 m high")
                               .arg(QString::fromStdString(cleanText(name)), describeAmount(height, 1))});
    }
    if (proposal.buildings.size() > maximum)
        figures.push_back(
            {sheetText("Further new buildings"), describeCount(proposal.buildings.size() - maximum)});
}

}  // namespace

std::vector<CommandOption> drawnOptions(const ChangeScale& scale, const LegendChoice& legend) {
    std::vector<CommandOption> options = listLegendOptions(legend, true);
    if (scale != ChangeScale()) options.push_back({changeScaleFlag, {formatText(scale)}});
    return options;
}

SheetMap makeImpactMap(const Impact& impact, const City& city, const Region& region, ShadowMeasure measure,
                       const ChangeScale& scale, const LegendChoice& choice) {
    const Legend legend = makeLegend(impact, measure, scale, choice);
    return {{city, region, impact.grid,
             [&impact, measure, colours = coloursOf(legend)](int wantedPixels) {
                 const auto colour = [&](std::size_t cell) {
                     return pickColour(impact, measure, cell, colours);
                 };
                 return makeColourImage(impact.grid, colour, wantedPixels);
             }},
            legend};
}

Sheet makeSheet(const ImpactAnswer& answer, const AnswerSource& source, const ChangeScale& scale,
                const LegendChoice& legend) {
    const SheetScope words;
    const Impact& impact = impactOfColumn(answer.study, legend.trees);
    const Region& region = answer.settings.study.region;
    const auto mapOf = [&](ShadowMeasure measure) {
        SheetMap map = makeImpactMap(impact, source.city, region, measure, scale, legend);
        if (!answer.study.withTrees.empty())
            nameTrees(map.legend, &impact == &answer.study.total ? TreeColumns::without : legend.trees);
        zoomOnChange(answer, map);
        return map;
    };
    const QString subject =
        sheetText("%1 compared with %2").arg(scenarioText(answer.to), scenarioText(answer.from));
    const QString sunlit =
        sheetText("sun above the horizon for %1 min a day").arg(describeAmount(impact.sunlitMinutesPerDay));
    Sheet sheet{.headline = makeHeadline(answer.settings.study, source.city.frame, subject,
                                         isInstant(impact) ? QString() : sunlit),
                .map = mapOf(ShadowMeasure::gross),
                .definitions = definitionsOf(answer, scale, legend),
                .figures = figureTexts(listLines(computeFigures(answer), legend.show)),
                .sections = sectionsOf(answer, source, drawnOptions(scale, legend)),
                .credit = describeData(answer.provenance.attribution),
                .record = {QStringLiteral("impact.json"), inEnglish([&] {
                               return extendRepeat(impactJson(answer), drawnOptions(scale, legend));
                           })}};
    addNewBuildings(sheet.figures, answer.proposal);
    sheet.finding = QString::fromStdString(formatText(makePage(answer, legend).headline)) + u'.';
    if (const auto beyond = describeBeyond(answer))
        sheet.finding += u' ' + QString::fromStdString(formatText(*beyond));
    if (!isInstant(impact) && hasRuns(impact)) sheet.smallMap.emplace(mapOf(ShadowMeasure::continuous));
    return sheet;
}

namespace {

QString monthName(std::chrono::year_month month) {
    if (!isEnglishInUse())
        return QString::fromStdString(wordingInUse().month(month.month(), true)) +
               QStringLiteral(" %1").arg(int(month.year()));
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
    return {body(defineFigures(listScoreLines(score)) +
                 sheetText(" Positive means that wanted shade outweighs unwanted shadow. The figures of "
                           "the months add up to the total."))};
}

TextBlocks methodOf(const ScoreAnswer& answer) {
    return {heading(sheetText("Method")),
            body(sheetText("Engine: %1.").arg(describeEngineUsed(answer.score.engine))),
            body(sheetText("Receivers: centres of square cells of %1 m on %2, inside the region.")
                     .arg(describeAmount(answer.score.grid.cellM, 2),
                          sheetText(describe(answer.settings.receivers.places))))};
}

// Intervals without a sun step have neither area nor score and are skipped.
TextBlocks weightsOf(const ScoreAnswer& answer) {
    TextBlocks blocks{heading(sheetText("Weights: %1").arg(weightText(answer.weights.name)))};
    for (const IntervalFigures& interval : answer.score.intervals)
        if (interval.shadowAreaM2 > 0)
            blocks.push_back(body(QStringLiteral("%1: %2").arg(
                weightText(interval.name),
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
        repeatBlocks(makeRepeatCommand(answer, columnCharacters), needsRegionFile(answer.provenance), drawn));
    return sections;
}

}  // namespace

SheetMap makeScoreMap(const Score& score, const City& city, const Region& region,
                      const LegendChoice& choice) {
    const std::shared_ptr<const Score> all(std::shared_ptr<void>(), &score);
    const std::shared_ptr<const Score> shown = showColumn(all, choice.trees);
    Legend legend = makeLegend(*shown, choice);
    if (!score.withTrees.empty()) nameTrees(legend, columnOf(score, choice.trees));
    return {{city, region, shown->grid,
             [shown, colours = coloursOf(legend)](int wantedPixels) {
                 const auto colour = [&](std::size_t cell) {
                     return pickColour(colours, double(shown->score[cell]));
                 };
                 return makeColourImage(shown->grid, colour, wantedPixels);
             }},
            legend};
}

std::vector<FigureText> makeScoreFigures(const Score& score) {
    std::vector<FigureText> figures = figureTexts(listScoreLines(score));
    for (const MonthFigures& month : score.months)
        figures.push_back({monthName(month.month), describePart(month)});
    return figures;
}

Sheet makeSheet(const ScoreAnswer& answer, const AnswerSource& source, const LegendChoice& legend) {
    const SheetScope words;
    const QString subject = sheetText("Shadow score of %1").arg(scenarioText(answer.scenario));
    std::vector<TextBlocks> sections{methodOf(answer), errorBlocks(answer.score.errors), weightsOf(answer)};
    for (TextBlocks& section : sourcesOf(answer, source, listLegendOptions(legend, true)))
        sections.push_back(std::move(section));
    return {.headline = makeHeadline(answer.settings, source.city.frame, subject, {}),
            .map = makeScoreMap(answer.score, source.city, answer.settings.region, legend),
            .definitions = definitionsOf(answer.score),
            .figures = makeScoreFigures(answer.score),
            .sections = std::move(sections),
            .credit = describeData(answer.provenance.attribution),
            .record = {QStringLiteral("score.json"), inEnglish([&] {
                           return extendRepeat(scoreJson(answer), listLegendOptions(legend, true));
                       })}};
}

}  // namespace noonmark
