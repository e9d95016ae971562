#include "app/report/scenarios/scenario_book.h"

#include <QGuiApplication>
#include <QStringList>
#include <algorithm>
#include <cmath>
#include <iterator>

#include "app/report/book/flow.h"
#include "app/report/book/print_book.h"
#include "app/report/files/output_folder.h"
#include "app/report/maps/sheet_text.h"
#include "app/report/maps/style.h"
#include "app/report/scenarios/scenario_months.h"
#include "app/report/scenarios/scenario_study.h"
#include "app/report/sheets/report_sections.h"
#include "app/report/sheets/study_text.h"
#include "core/describe/command_options.h"
#include "core/io/styles/qgis_style.h"
#include "core/io/write_raster.h"
#include "core/measures/shadow_figures.h"
#include "core/receivers/rasterize.h"
#include "core/study/provenance/command_text.h"
#include "core/study/provenance/provenance_texts.h"
#include "core/study/review_study.h"
#include "core/study/text/region_text.h"
#include "scenarios/project/title_fields.h"
#include "scenarios/settings_json.h"

namespace noonmark {

namespace {

constexpr double figuresPt = 8;

QString describeWhere(const Study& study) {
    return plainText(regionText(study.settings.region.name)) + QStringLiteral(", ") +
           describePlace(study.settings.region, study.city.frame);
}

std::vector<QString> rowOf(const ScenarioStudies& scenarios, const ScenarioStudy& scenario,
                           UnitSystem units) {
    const bool isFirst = &scenario == &scenarios.front();
    const double change = computeShadowAreaChange(scenarios, scenario);
    std::vector<QString> row{
        plainText(scenarioText(scenario.name)), describeCount(countChanges(scenario)),
        isFirst ? QString()
                : (change > 0 ? QStringLiteral("+") : QString()) + plainText(formatSmallArea(change, units))};
    const DescribedFigures figures = shadowFigures().of(scenario.study->statistics);
    for (const Figure& figure : figures.figures)
        if (figure.inTable) row.push_back(plainText(valueOf({&figure, figures.get(figure)}, units)));
    return row;
}

std::vector<BookPage> tablePages(const ScenarioStudies& scenarios, const BookSettings& settings) {
    PageTable table{{sheetText("Scenario"), sheetText("Changes"), sheetText("Change of the shadow area")},
                    {},
                    {},
                    {},
                    figuresPt * textScale(settings.setup)};
    for (const Figure& figure : shadowFigures().rows())
        if (figure.inTable) table.titles.push_back(sheetText(figure.label));
    for (const ScenarioStudy& scenario : scenarios)
        table.rows.push_back(rowOf(scenarios, scenario, settings.units));
    const Study& first = *scenarios.front().study;
    const QString title = sheetText("Scenarios"),
                  note = sheetText("%1 Change: from %2, on the receivers of both. Engine: %3.")
                             .arg(defineFigures(listLines(shadowFigures().of(first.statistics))),
                                  plainText(scenarioText(scenarios.front().name)),
                                  describeEngineUsed(first.field.engine));
    return makeTablePages(
        settings.setup,
        {title,
         describePeriod(first.settings.period) + QStringLiteral(". ") + describeWhere(first),
         title,
         0,
         {}},
        {{sheetText("The same study of each scenario"), note, std::move(table)}});
}

}  // namespace

Legend commonLegend(const ScenarioStudies& scenarios, const LegendChoice& choice) {
    const auto maximum = std::ranges::max_element(
        scenarios, {}, [](const ScenarioStudy& scenario) { return scenario.study->statistics.maxGrossMin; });
    return makeLegend(maximum->study->field, ShadowMeasure::gross, choice);
}

namespace {

/// Of a scenario, with what it demolishes of the first one.
SheetMap makeScenarioMap(const ScenarioStudies& scenarios, const ScenarioStudy& scenario,
                         const Legend& legend) {
    const Study& study = *scenario.study;
    SheetMap map{makeGrossScene(study.city, study.settings.region, study.field, coloursOf(legend)), legend};
    map.scene.removed = findAbsent(keepOwnBuildings(scenarios.front().study->city, study.city), study.city);
    return map;
}

BookPage mapPage(const ScenarioStudies& scenarios, const ScenarioStudy& scenario, const Legend& legend,
                 const PageSetup& setup) {
    const Study& study = *scenario.study;
    const QString name = plainText(scenarioText(scenario.name));
    const SheetMap map = makeScenarioMap(scenarios, scenario, legend);
    return {name,
            describePeriod(study.settings.period) + QStringLiteral(". ") + describeWhere(study),
            name,
            0,
            {{contentArea(setup), PageMap{std::make_shared<const SheetMap>(map)}}}};
}

/// "120 m high, floor area 27,058 m²": what a scenario builds.
QString describeBuilt(const ScenarioStudy& scenario, UnitSystem units) {
    QStringList parts;
    if (scenario.heightM)
        parts << sheetText("%1 high").arg(QString::fromStdString(formatLength(*scenario.heightM, units, 1)));
    if (const auto floorM2 = sumFloorAreaM2(scenario.uses))
        parts << sheetText("floor area %1").arg(QString::fromStdString(formatSmallArea(*floorM2, units)));
    return parts.empty() ? sheetText("no new building with known floors") : parts.join(QStringLiteral(", "));
}

double largestDifferenceMin(const std::vector<float>& a, const std::vector<float>& b) {
    double largest = 0;
    for (std::size_t cell = 0; cell < std::min(a.size(), b.size()); ++cell)
        if (const double change = std::abs(double(a[cell]) - double(b[cell])); !std::isnan(change))
            largest = std::max(largest, change);
    return largest;
}

/// The ground where any scenario's shadow differs from the first one's by a tenth of the largest difference,
/// or only one of them has a building.
Box2 findDifference(const ScenarioStudies& scenarios) {
    const ShadowField& first = scenarios.front().study->field;
    Box2 box;
    for (const ScenarioStudy& scenario : scenarios) {
        const ShadowField& field = scenario.study->field;
        if (field.grossMin.size() != first.grossMin.size()) continue;
        const double minMin = largestDifferenceMin(first.grossMin, field.grossMin) / 10;
        for (std::size_t cell = 0; cell < field.grossMin.size(); ++cell) {
            const float a = first.grossMin[cell], b = field.grossMin[cell];
            if (std::isnan(a) != std::isnan(b) || std::abs(double(a) - double(b)) > minMin)
                box.add(cellBox(field.grid, cell));
        }
    }
    return box;
}

/// The maps of all scenarios in a grid, with what each builds: closely where they differ in a small part.
std::vector<BookPage> sideBySidePages(const ScenarioStudies& scenarios, const Legend& legend,
                                      const BookSettings& settings) {
    const PageSetup& setup = settings.setup;
    const QRectF all = contentArea(setup);
    const double gap = 12 * textScale(setup);
    const bool isPair = scenarios.size() <= 2;
    const int columns = setup.landscape ? (isPair ? 2 : 3) : (isPair ? 1 : 2);
    const int rows = setup.landscape ? (isPair ? 1 : 2) : (isPair ? 2 : 3);
    const QSizeF size((all.width() - gap * (columns - 1)) / columns,
                      (all.height() - gap * (rows - 1)) / rows);
    const QString title = sheetText("Scenarios side by side");
    const Box2 difference = findDifference(scenarios);
    std::vector<BookPage> pages;
    for (std::size_t i = 0; i < scenarios.size(); ++i) {
        const int at = int(i) % (columns * rows);
        if (at == 0)
            pages.push_back({title,
                             sheetWord(legend.title) + sheetText(", on one scale"),
                             i == 0 ? title : QString(),
                             0,
                             {}});
        SheetMap map = makeScenarioMap(scenarios, scenarios[i], legend);
        map.scene.shown = zoomOn(difference, map.scene);
        const QPointF corner(all.left() + (at % columns) * (size.width() + gap),
                             all.top() + (at / columns) * (size.height() + gap));
        pages.back().items.push_back({{corner, size},
                                      PageMap{std::make_shared<const SheetMap>(map),
                                              {plainText(scenarioText(scenarios[i].name)),
                                               describeBuilt(scenarios[i], settings.units)}}});
    }
    return pages;
}

PageChart chartOf(const MonthChart& chart, const Bars& bars, const BookSettings& settings) {
    const bool isArea = chart.unit == FigureUnit::squareMetres || chart.unit == FigureUnit::squareMetreHours;
    const Bars shown = firstSeries(bars, bars.isChange ? maxSeries - 1 : maxSeries);
    const QString more = shown.series.size() == bars.series.size()
                             ? QString()
                             : sheetText("The first %1 of %2 scenarios; scenario_months.csv has all")
                                   .arg(shown.series.size())
                                   .arg(bars.series.size());
    return {makeBarChart(shown, chart.unit, settings.units, isArea ? QString() : QStringLiteral("h")),
            {sheetText(bars.title), more}};
}

/// A figure by month, above its changes.
BookPage monthPage(const MonthChart& chart, const BookSettings& settings) {
    BookPage page{sheetText(chart.values.title), {}, sheetText(chart.values.title), 0, {}};
    const QRectF all = contentArea(settings.setup);
    const double gap = 14 * textScale(settings.setup), height = (all.height() - gap) / 2;
    page.items.push_back(
        {{all.left(), all.top(), all.width(), height}, chartOf(chart, chart.values, settings)});
    if (!chart.changes.groups.empty())
        page.items.push_back({{all.left(), all.top() + height + gap, all.width(), height},
                              chartOf(chart, chart.changes, settings)});
    return page;
}

}  // namespace

namespace {

// What the sheets state and how they look, on the command line.
std::vector<CommandOption> listSheetOptions(const BookSettings& settings) {
    std::vector<CommandOption> options = listOptions(pageFields().of(settings.setup));
    for (CommandOption& option : listOptions(titleFields().of(settings.titleBlock)))
        options.push_back(std::move(option));
    for (CommandOption& option : listLegendOptions(settings.legend, false))
        options.push_back(std::move(option));
    return options;
}

std::string makeRecord(const ScenarioStudies& scenarios, const BookSettings& settings,
                       const FailedScenarios& failed) {
    return inEnglish(
        [&] { return extendRepeat(scenariosJson(scenarios, failed), listSheetOptions(settings)); });
}

// The edits of each scenario, and what all of them were measured from.
TextBlocks describeOrigin(const ScenarioStudies& scenarios, const BookSettings& settings) {
    const Study& first = *scenarios.front().study;
    TextBlocks blocks{heading(sheetText("How this was made"))};
    for (const ScenarioStudy& one : scenarios) {
        const auto& project = one.study->provenance.project;
        if (!project) continue;
        QStringList edits;
        for (const std::string& edit : project->scenario.edits) edits << plainText(edit);
        blocks.push_back(
            body(sheetText("%1: %2. Buildings and ground: SHA-256 %3.")
                     .arg(plainText(scenarioText(one.name)),
                          edits.empty() ? sheetText("no changes") : edits.join(QStringLiteral("; ")),
                          QString::fromStdString(project->scenario.citySha256))));
    }
    const TextBlocks repeat =
        repeatBlocks(makeRepeatCommand(scenarios, bookCharacters), needsRegionFile(first.provenance),
                     listSheetOptions(settings), bookCharacters);
    blocks.insert(blocks.end(), repeat.begin(), repeat.end());
    Study sources;
    sources.city = first.city;
    sources.warnings = first.warnings;
    sources.provenance = first.provenance;
    const TextBlocks more = sourceBlocks(sources);
    blocks.insert(blocks.end(), more.begin(), more.end());
    return blocks;
}

// Each scenario has a small map in any case.
std::size_t countLargeMaps(const ScenarioStudies& scenarios, const BookSettings& settings) {
    constexpr std::size_t maximum = 10;
    return settings.allPages ? scenarios.size() : std::min(maximum, scenarios.size());
}

}  // namespace

Book makeScenarioBook(const ScenarioStudies& scenarios, const BookSettings& settings,
                      const FailedScenarios& failed) {
    const SheetScope words(settings.language);
    Book book = beginBook(settings, sheetText("Scenarios side by side"),
                          scenarios.front().study->provenance.attribution);
    BookSettings stated = settings;
    if (stated.titleBlock.date.empty()) stated.titleBlock.date = book.date.toStdString();
    stated.language = statedLanguage(settings.language);
    book.record = {QStringLiteral("scenarios.json"), makeRecord(scenarios, stated, failed)};
    book.pages = tablePages(scenarios, settings);
    for (const MonthChart& chart : makeMonthCharts(listMonths(scenarios)))
        book.pages.push_back(monthPage(chart, settings));
    const Legend legend = commonLegend(scenarios, settings.legend);
    std::vector<BookPage> maps = sideBySidePages(scenarios, legend, settings);
    book.pages.insert(book.pages.begin(), std::make_move_iterator(maps.begin()),
                      std::make_move_iterator(maps.end()));
    for (const ScenarioStudy& scenario : std::span(scenarios).first(countLargeMaps(scenarios, settings)))
        book.pages.push_back(mapPage(scenarios, scenario, legend, settings.setup));
    const QString origin = sheetText("How this was made");
    for (BookPage& page :
         makeTextPages(settings.setup, {origin, {}, origin, 0, {}}, describeOrigin(scenarios, stated)))
        book.pages.push_back(std::move(page));
    return book;
}

namespace {

Result<void> writeGrossBands(const ScenarioStudies& scenarios, const std::filesystem::path& file) {
    const Study& first = *scenarios.front().study;
    std::vector<RasterBand> bands;
    for (const ScenarioStudy& scenario : scenarios)
        bands.push_back({"gross shadow: " + scenario.name, "min/day", &scenario.study->field.grossMin});
    return writeGeoTiff(file, first.city.frame, first.field.grid, bands,
                        makeProvenanceTags(first.provenance));
}

}  // namespace

std::vector<std::string> scenarioFileNames() {
    return {"scenarios.csv", "scenario_uses.csv", "scenario_months.csv", "scenarios.json",
            "scenarios.pdf", "scenarios.tif",     "scenarios.qml",       regionFileName};
}

Result<std::vector<std::filesystem::path>> writeScenarioFiles(const ScenarioStudies& scenarios,
                                                              const BookSettings& sheets,
                                                              const std::filesystem::path& folder,
                                                              const OutputRules& rules,
                                                              const FailedScenarios& failed) {
    if (qGuiApp == nullptr) return failure("Reports need a QGuiApplication", folder.string());
    if (scenarios.empty())
        return failure("No scenario has been measured", {}, "Press Measure all in the panel Scenarios");
    const Grid& grid = scenarios.front().study->field.grid;
    if (!std::ranges::all_of(scenarios, [&](const auto& one) { return one.study->field.grid == grid; }))
        return failure("The scenarios were measured on different cells", scenarios.front().name,
                       "Press Measure all in the panel Scenarios");
    if (auto may = checkOutputs(folder, scenarioFileNames(), rules); !may)
        return tl::make_unexpected(may.error());
    const Book book = makeScenarioBook(scenarios, sheets, failed);
    const auto pdf = printBook(book);
    if (!pdf) return tl::make_unexpected(pdf.error());
    OutputFolder files(folder, rules);
    files.add("scenarios.csv", textContent(scenariosCsv(scenarios)));
    files.add("scenario_uses.csv", textContent(scenarioUsesCsv(scenarios)));
    if (const auto months = makeMonthCharts(listMonths(scenarios)); !months.empty())
        files.add("scenario_months.csv", textContent(monthsCsv(months)));
    files.add("scenarios.json", textContent(book.record.json));
    files.add("scenarios.pdf", textContent(pdf->toStdString()));
    files.add("scenarios.tif",
              [&](const std::filesystem::path& file) { return writeGrossBands(scenarios, file); });
    files.add("scenarios.qml", textContent(rasterStyle(coloursOf(commonLegend(scenarios, sheets.legend)))));
    const Study& first = *scenarios.front().study;
    if (needsRegionFile(first.provenance))
        files.add(regionFileName, textContent(regionGeoJson(first.settings.region, first.city.frame)));
    return std::move(files).result();
}

}  // namespace noonmark
