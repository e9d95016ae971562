#include "app/report/sheets/study_report.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/report/maps/sheet_text.h"
#include "app/report/maps/style.h"
#include "app/report/sheets/answer_reports.h"
#include "app/report/sheets/report_sections.h"
#include "core/engines/shade_trees.h"
#include "core/measures/shadow_figures.h"
#include "core/study/provenance/command_text.h"
#include "core/study/text/region_text.h"
#include "scenarios/impact/impact_figures.h"
#include "scenarios/weights/score_text.h"

namespace noonmark {

namespace {

SheetMap mapOf(const Study& study, ShadowMeasure measure, const LegendChoice& legend) {
    return {makeMapScene(study, measure, legend), makeColumnLegend(study.field, measure, legend)};
}

std::vector<TextBlocks> sectionsOf(const Study& study) {
    std::vector<TextBlocks> sections = methodSections(study);
    for (TextBlocks& section : sourceSections(study)) sections.push_back(std::move(section));
    return sections;
}

}  // namespace

Sheet makeSheet(const Study& study, const LegendChoice& legend) {
    const SheetScope words;
    Sheet sheet{.headline = makeHeadline(study, sheetText("Shadow study")),
                .map = mapOf(study, ShadowMeasure::gross, legend),
                .definitions = definitionBlocks(study, legend.show),
                .figures = computeFigures(study, legend.show),
                .sections = sectionsOf(study),
                .repeat = repeatBlocks(study, listLegendOptions(legend, false)),
                .credit = describeData(study),
                .record = {QStringLiteral("study.json"), inEnglish([&] {
                               return extendRepeat(studyJson(study), listLegendOptions(legend, false));
                           })}};
    const AnswerPage page = makePage(study.field, study.statistics, nameOf(study.settings.region), legend);
    if (!page.headline.source.empty())
        sheet.finding = QString::fromStdString(formatText(asOnSheets(page.headline))) + u'.';
    if (!isInstant(study.field) && hasRuns(fieldOfColumn(study.field, legend.trees)))
        sheet.smallMap.emplace(mapOf(study, ShadowMeasure::continuous, legend));
    return sheet;
}

bool writeReport(const Study& study, QIODevice& device, const LegendChoice& legend) {
    const SheetScope words;
    return writePdf(makeSheet(study, legend), device);
}

QImage mapPicture(const Study& study, ShadowMeasure measure, int width, const LegendChoice& legend) {
    const SheetScope words;
    const SheetMap map = mapOf(study, measure, legend);
    const QString subject = isInstant(study.field) ? sheetText("Shadow") : sheetWord(map.legend.title);
    return makePicture(
        Sheet{.headline = makeHeadline(study, subject), .map = map, .credit = describeData(study)}, width);
}

namespace {

using SavedJson = nlohmann::json;

QString plainText(const std::string& text) { return QString::fromStdString(text); }

SheetMap makeStudyMap(const ShadowField& saved, ShadowMeasure measure, const SavedMaps& from) {
    const ShadowField& field = fieldOfColumn(saved, from.legend.trees);
    const Legend legend = makeColumnLegend(saved, measure, from.legend);
    const auto image = [&field, measure, scale = coloursOf(legend)](int wantedPixels) {
        const auto colour = [&](std::size_t cell) {
            return pickColour(scale, double(getValues(field, measure)[cell]));
        };
        return makeColourImage(field.grid, colour, wantedPixels);
    };
    return {{from.city, from.region, field.grid, image}, legend};
}

QString describeTime(const SavedOrigin& origin) {
    if (origin.at.empty()) return sheetText("at an unknown time");
    QString at = plainText(origin.at);
    at.replace(QLatin1Char('T'), QLatin1Char(' ')).replace(QLatin1Char('Z'), QStringLiteral(" UTC"));
    return sheetText("on ") + at;
}

TextBlocks originSection(const SavedResult& result, const SavedOrigin& origin, const SavedSource& source) {
    TextBlocks blocks{
        heading(sheetText("A result saved in the project")),
        body(sheetText("'%1', saved %2 by %3. Maps and figures are those that were saved.")
                 .arg(plainText(result.name), describeTime(origin), plainText(origin.program)))};
    for (const std::string& change : source.changes) blocks.push_back(body(plainText(change)));
    blocks.push_back(body(source.changes.empty()
                              ? sheetText("Its inputs have not changed since.")
                              : sheetText("The buildings drawn are those of the scenario as it is now.")));
    return blocks;
}

TextBlocks methodSection(const SavedResult& result, const SavedOrigin& origin, const std::string& error) {
    TextBlocks blocks{
        heading(sheetText("Method")), body(sheetText("Engine: %1.").arg(describeEngineUsed(origin.engine))),
        body(sheetText("Square cells of %1 m; those that were not measured are white on the map.")
                 .arg(describeAmount(result.grid.cellM, 2)))};
    if (!error.empty()) blocks.push_back(body(sheetText("Error: %1.").arg(plainText(error))));
    if (const auto& weights = origin.weights)
        blocks.push_back(body(sheetText("Weight table: %1.").arg(plainText(weights->name))));
    return blocks;
}

std::string textIn(const SavedJson& object, const char* member) {
    const auto found = object.find(member);
    return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

// Files without a hash are samples, which are generated.
TextBlocks inputsSection(const SavedResult& result) {
    constexpr std::size_t maximum = 8;
    TextBlocks blocks{heading(sheetText("Inputs"))};
    const SavedJson inputs = SavedJson::parse(result.inputs, nullptr, false);
    const std::size_t count = inputs.is_array() ? inputs.size() : 0;
    for (std::size_t i = 0; i < std::min(maximum, count); ++i) {
        if (!inputs[i].is_object()) continue;
        blocks.push_back(body(plainText(textIn(inputs[i], "path"))));
        if (const std::string hash = textIn(inputs[i], "sha256"); !hash.empty())
            blocks.push_back({TextKind::code, plainText(hash)});
    }
    if (count > maximum) blocks.push_back(body(sheetText("and %1 more").arg(count - maximum)));
    if (count == 0) blocks.push_back(body(sheetText("No file: the city was not read from a file.")));
    return blocks;
}

Box2 boxOf(const Grid& grid) {
    return {glm::vec2(grid.westM, grid.southM), glm::vec2(grid.eastM(), grid.northM())};
}

// The cells of a region extend beyond it by less than two cells.
bool haveSameExtent(const Box2& region, const Box2& cells, double cellM) {
    const auto off = [](glm::vec2 a, glm::vec2 b) {
        return double(std::max(std::abs(a.x - b.x), std::abs(a.y - b.y)));
    };
    return !region.empty() && std::max(off(region.low, cells.low), off(region.high, cells.high)) < 2 * cellM;
}

Headline headlineOf(const QString& subject, const SavedOrigin& origin, const Region& region,
                    const Frame& frame) {
    const QString name = origin.region.empty() || origin.region == "box"
                             ? QString()
                             : QStringLiteral(": ") + regionText(origin.region);
    return {subject + name, plainText(origin.period.words), describePlace(region, frame)};
}

}  // namespace

Region makeSavedRegion(const SavedResult& result, const SavedOrigin& origin,
                       const std::vector<Region>& known) {
    const Box2 cells = boxOf(result.grid);
    for (const Region& region : known)
        if (region.name == origin.region && haveSameExtent(bounds(region), cells, result.grid.cellM))
            return region;
    Region region = makeRegionFromLocalBox(cells);
    region.name = origin.region;
    return region;
}

SavedSheet makeSavedSheet(const SavedResult& result, const SavedStudy& study, const SavedMaps& with) {
    const SheetScope words;
    const bool isOfMoment = isInstant(study.field);
    SavedSheet sheet{
        .subject = sheetText("Shadow study of %1").arg(scenarioText(result.scenario)),
        .map = makeStudyMap(study.field, ShadowMeasure::gross, with),
        .definitions = {body(defineFigures(listLines(shadowFigures().of(study.statistics),
                                                     {.isInstant = isOfMoment, .show = with.legend.show})))},
        .figures = makeStudyFigures(study.statistics, study.field, study.steps, with.legend.show),
        .error = study.error};
    if (!isOfMoment && hasRuns(fieldOfColumn(study.field, with.legend.trees)))
        sheet.smallMap.emplace(makeStudyMap(study.field, ShadowMeasure::continuous, with));
    return sheet;
}

SavedSheet makeSavedSheet(const SavedResult& result, const SavedImpact& saved, const SavedMaps& with) {
    const SheetScope words;
    const Impact& impact = saved.impact;
    const QString scenario = scenarioText(result.scenario), baseline = scenarioText(result.baseline);
    const auto map = [&](ShadowMeasure measure) {
        return makeImpactMap(impact, with.city, with.region, measure, with.scale, with.legend);
    };
    const ShownAs show = with.legend.show;
    const auto lines = listLines(saved.figures, show);
    SavedSheet sheet{
        .subject = sheetText("%1 compared with %2").arg(scenario, baseline),
        .map = map(ShadowMeasure::gross),
        .definitions = {body(
            sheetText("Change: minutes in %1 minus minutes in %2; positive means more %3. %4")
                .arg(scenario, baseline, show == ShownAs::shadow ? sheetText("shadow") : sheetText("sun"),
                     defineFigures(lines)))},
        .figures = figureTexts(lines)};
    if (!isInstant(impact) && hasRuns(impact)) sheet.smallMap.emplace(map(ShadowMeasure::continuous));
    return sheet;
}

SavedSheet makeSavedSheet(const SavedResult& result, const SavedScore& saved, const SavedMaps& with) {
    const SheetScope words;
    return {.subject = sheetText("Shadow score of %1").arg(scenarioText(result.scenario)),
            .map = makeScoreMap(saved.score, with.city, with.region, with.legend),
            .definitions = {body(defineFigures(listScoreLines(saved.score)))},
            .figures = makeScoreFigures(saved.score)};
}

std::string attributionOf(const SavedResult& result) {
    const SavedJson settings = SavedJson::parse(result.settings, nullptr, false);
    return settings.is_object() ? textIn(settings, "attribution") : std::string();
}

std::vector<TextBlocks> makeSavedSections(const SavedResult& result, const SavedOrigin& origin,
                                          const SavedSource& source, const std::string& error) {
    const SheetScope words;
    return {originSection(result, origin, source), methodSection(result, origin, error),
            inputsSection(result)};
}

Sheet makeSheet(const SavedResult& result, const SavedOrigin& origin, SavedSheet saved, const Region& region,
                const SavedSource& source) {
    auto sections = makeSavedSections(result, origin, source, saved.error);
    return {.headline = headlineOf(saved.subject, origin, region, source.city.frame),
            .map = std::move(saved.map),
            .definitions = std::move(saved.definitions),
            .smallMap = std::move(saved.smallMap),
            .figures = std::move(saved.figures),
            .sections = std::move(sections),
            .credit = describeData(attributionOf(result)),
            .record = {QStringLiteral("result.json"), result.settings}};
}

}  // namespace noonmark
