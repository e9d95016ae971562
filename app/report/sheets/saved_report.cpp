#include "app/report/sheets/saved_report.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/report/maps/palette.h"
#include "app/report/sheets/impact_report.h"
#include "app/report/sheets/score_report.h"
#include "core/measures/has_runs.h"
#include "core/measures/shadow_figures.h"
#include "scenarios/impact/impact_runs.h"
#include "scenarios/weights/score_figures.h"

namespace noonmark {

namespace {

using SavedJson = nlohmann::json;

QString plainText(const std::string& text) { return QString::fromStdString(text); }

/// What the maps of each kind of result are made from.
struct SavedMaps {
    const City& city;
    const Region& region;
    const ChangeScale& scale;
    const LegendChoice& legend;
};

SheetMap makeStudyMap(const ShadowField& field, ShadowMeasure measure, const SavedMaps& from) {
    const Legend legend = makeLegend(field, measure, from.legend);
    const auto image = [&field, measure, scale = coloursOf(legend)](int wantedPixels) {
        const auto colour = [&](std::size_t cell) {
            return pickColour(scale, double(getValues(field, measure)[cell]));
        };
        return makeColourImage(field.grid, colour, wantedPixels);
    };
    return {{from.city, from.region, field.grid, image}, legend};
}

void addMaps(Sheet& sheet, const SavedStudy& study, const SavedMaps& from) {
    if (!isInstant(study.field) && hasRuns(study.statistics))
        sheet.smallMap.emplace(makeStudyMap(study.field, ShadowMeasure::continuous, from));
}

void addMaps(Sheet& sheet, const SavedImpact& saved, const SavedMaps& from) {
    const Impact& impact = saved.impact;
    if (!isInstant(impact) && hasRuns(impact))
        sheet.smallMap.emplace(makeImpactMap(impact, from.city, from.region, ShadowMeasure::continuous,
                                             from.scale, from.legend));
}

void addMaps(Sheet&, const SavedScore&, const SavedMaps&) {}

// Points have no sheet of their own yet: writeSavedFiles() writes their tables.
void addMaps(Sheet&, const SavedElements&, const SavedMaps&) {}
SheetMap makeMainMap(const SavedElements&, const SavedMaps& from) { return {{from.city, from.region}, {}}; }
std::vector<FigureText> figuresOf(const SavedElements&, ShownAs) { return {}; }

// Nor has sun by place.
void addMaps(Sheet&, const SavedSunByPlace&, const SavedMaps&) {}
SheetMap makeMainMap(const SavedSunByPlace&, const SavedMaps& from) { return {{from.city, from.region}, {}}; }
std::vector<FigureText> figuresOf(const SavedSunByPlace&, ShownAs) { return {}; }

SheetMap makeMainMap(const SavedStudy& study, const SavedMaps& from) {
    return makeStudyMap(study.field, ShadowMeasure::gross, from);
}

SheetMap makeMainMap(const SavedImpact& saved, const SavedMaps& from) {
    return makeImpactMap(saved.impact, from.city, from.region, ShadowMeasure::gross, from.scale, from.legend);
}

SheetMap makeMainMap(const SavedScore& saved, const SavedMaps& from) {
    return makeScoreMap(saved.score, from.city, from.region, from.legend);
}

std::vector<FigureText> figuresOf(const SavedStudy& study, ShownAs show) {
    return makeStudyFigures(study.statistics, study.field, study.steps, show);
}

std::vector<FigureText> figuresOf(const SavedImpact& saved, ShownAs show) {
    return figureTexts(listLines(saved.figures, show));
}

std::vector<FigureText> figuresOf(const SavedScore& saved, ShownAs) { return makeScoreFigures(saved.score); }

QString describeSubject(const SavedResult& result) {
    const QString scenario = plainText(result.scenario);
    if (result.kind == "score") return QStringLiteral("Shadow score of %1").arg(scenario);
    if (result.kind == "impact")
        return QStringLiteral("%1 compared with %2").arg(scenario, plainText(result.baseline));
    return QStringLiteral("Shadow study of %1").arg(scenario);
}

QString describeTime(const SavedOrigin& origin) {
    if (origin.at.empty()) return QStringLiteral("at an unknown time");
    QString at = plainText(origin.at);
    at.replace(QLatin1Char('T'), QLatin1Char(' ')).replace(QLatin1Char('Z'), QStringLiteral(" UTC"));
    return QStringLiteral("on ") + at;
}

TextBlocks definitionsOf(const SavedResult&, const SavedStudy& study, ShownAs show) {
    return {body(defineFigures(listLines(shadowFigures().of(study.statistics),
                                         {.isInstant = isInstant(study.field), .show = show})))};
}

TextBlocks definitionsOf(const SavedResult& result, const SavedImpact& saved, ShownAs show) {
    return {body(QStringLiteral("Change: minutes in %1 minus minutes in %2; positive means more %3. %4")
                     .arg(plainText(result.scenario), plainText(result.baseline),
                          show == ShownAs::shadow ? QStringLiteral("shadow") : QStringLiteral("sun"),
                          defineFigures(listLines(saved.figures, show))))};
}

TextBlocks definitionsOf(const SavedResult&, const SavedScore& saved, ShownAs) {
    const ScoreTotals totals = totalsOf(saved.score);
    return {body(defineFigures(listLines(scoreFigures().of(totals))))};
}

TextBlocks definitionsOf(const SavedResult&, const SavedElements&, ShownAs) { return {}; }
TextBlocks definitionsOf(const SavedResult&, const SavedSunByPlace&, ShownAs) { return {}; }

TextBlocks originSection(const SavedResult& result, const SavedOrigin& origin, const SavedSource& source) {
    TextBlocks blocks{
        heading(QStringLiteral("A result saved in the project")),
        body(QStringLiteral("'%1', saved %2 by %3. Maps and figures are those that were saved.")
                 .arg(plainText(result.name), describeTime(origin), plainText(origin.program)))};
    for (const std::string& change : source.changes) blocks.push_back(body(plainText(change)));
    blocks.push_back(
        body(source.changes.empty()
                 ? QStringLiteral("Its inputs have not changed since.")
                 : QStringLiteral("The buildings drawn are those of the scenario as it is now.")));
    return blocks;
}

TextBlocks methodSection(const SavedResult& result, const SavedAnswer& answer) {
    TextBlocks blocks{
        heading(QStringLiteral("Method")),
        body(QStringLiteral("Engine: %1.").arg(describeEngineUsed(answer.origin.engine))),
        body(QStringLiteral("Square cells of %1 m; those that were not measured are white on the map.")
                 .arg(describeAmount(result.grid.cellM, 2)))};
    if (const auto* study = std::get_if<SavedStudy>(&answer.answer); study && !study->error.empty())
        blocks.push_back(body(QStringLiteral("Error: %1.").arg(plainText(study->error))));
    if (const auto& weights = answer.origin.weights)
        blocks.push_back(body(QStringLiteral("Weight table: %1.").arg(plainText(weights->name))));
    return blocks;
}

std::string textIn(const SavedJson& object, const char* member) {
    const auto found = object.find(member);
    return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

// Files without a hash are samples, which are generated.
TextBlocks inputsSection(const SavedResult& result) {
    constexpr std::size_t most = 8;
    TextBlocks blocks{heading(QStringLiteral("Inputs"))};
    const SavedJson inputs = SavedJson::parse(result.inputs, nullptr, false);
    const std::size_t count = inputs.is_array() ? inputs.size() : 0;
    for (std::size_t i = 0; i < std::min(most, count); ++i) {
        if (!inputs[i].is_object()) continue;
        blocks.push_back(body(plainText(textIn(inputs[i], "path"))));
        if (const std::string hash = textIn(inputs[i], "sha256"); !hash.empty())
            blocks.push_back({TextKind::code, plainText(hash)});
    }
    if (count > most) blocks.push_back(body(QStringLiteral("and %1 more").arg(count - most)));
    if (count == 0) blocks.push_back(body(QStringLiteral("No file: the city was not read from a file.")));
    return blocks;
}

std::string attributionOf(const SavedResult& result) {
    const SavedJson settings = SavedJson::parse(result.settings, nullptr, false);
    return settings.is_object() ? textIn(settings, "attribution") : std::string();
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

Headline headlineOf(const SavedResult& result, const SavedOrigin& origin, const Region& region,
                    const Frame& frame) {
    const QString name = origin.region.empty() || origin.region == "box"
                             ? QString()
                             : QStringLiteral(": ") + plainText(origin.region);
    return {describeSubject(result) + name, plainText(origin.period), describePlace(region, frame)};
}

}  // namespace

Region makeSavedRegion(const SavedResult& result, const SavedAnswer& answer,
                       const std::vector<Region>& known) {
    const Box2 cells = boxOf(result.grid);
    for (const Region& region : known)
        if (region.name == answer.origin.region && haveSameExtent(bounds(region), cells, result.grid.cellM))
            return region;
    Region region = makeRegionFromLocalBox(cells);
    region.name = answer.origin.region;
    return region;
}

Sheet makeSheet(const SavedResult& result, const SavedAnswer& answer, const Region& region,
                const SavedSource& source, const ChangeScale& scale, const LegendChoice& legend) {
    const SavedMaps from{source.city, region, scale, legend};
    return std::visit(
        [&](const auto& saved) {
            Sheet sheet{.headline = headlineOf(result, answer.origin, region, source.city.frame),
                        .map = makeMainMap(saved, from),
                        .definitions = definitionsOf(result, saved, legend.show),
                        .figures = figuresOf(saved, legend.show),
                        .sections = {originSection(result, answer.origin, source),
                                     methodSection(result, answer), inputsSection(result)},
                        .credit = describeData(attributionOf(result)),
                        .record = {QStringLiteral("result.json"), result.settings}};
            addMaps(sheet, saved, from);
            return sheet;
        },
        answer.answer);
}

}  // namespace noonmark
