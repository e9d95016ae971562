#include "app/report/scenarios/scenario_files.h"

#include <QGuiApplication>
#include <algorithm>

#include "app/report/book/print_book.h"
#include "app/report/files/output_folder.h"
#include "app/report/scenarios/scenario_book.h"
#include "app/report/scenarios/scenario_months.h"
#include "app/report/scenarios/scenario_text.h"
#include "core/io/styles/raster_style.h"
#include "core/io/write_raster.h"
#include "core/study/provenance/provenance_tags.h"

namespace noonmark {

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
            "scenarios.pdf", "scenarios.tif",     "scenarios.qml"};
}

Result<std::vector<std::filesystem::path>> writeScenarioFiles(const ScenarioStudies& scenarios,
                                                              const BookSettings& sheets,
                                                              const std::filesystem::path& folder,
                                                              const OutputRules& rules,
                                                              const FailedScenarios& failed) {
    if (qGuiApp == nullptr) return failure("Reports need a QGuiApplication", folder.string());
    if (scenarios.empty())
        return failure("No scenario has been measured", {}, "Press Measure all in the dock Scenarios");
    const Grid& grid = scenarios.front().study->field.grid;
    if (!std::ranges::all_of(scenarios, [&](const auto& one) { return one.study->field.grid == grid; }))
        return failure("The scenarios were measured on different cells", scenarios.front().name,
                       "Press Measure all in the dock Scenarios");
    if (auto may = checkOutputs(folder, scenarioFileNames(), rules); !may)
        return tl::make_unexpected(may.error());
    const auto pdf = printBook(makeScenarioBook(scenarios, sheets));
    if (!pdf) return tl::make_unexpected(pdf.error());
    OutputFolder files(folder, rules);
    files.add("scenarios.csv", textContent(scenariosCsv(scenarios)));
    files.add("scenario_uses.csv", textContent(scenarioUsesCsv(scenarios)));
    if (const auto months = makeMonthCharts(listMonths(scenarios)); !months.empty())
        files.add("scenario_months.csv", textContent(monthsCsv(months)));
    files.add("scenarios.json", textContent(scenariosJson(scenarios, failed)));
    files.add("scenarios.pdf", textContent(pdf->toStdString()));
    files.add("scenarios.tif",
              [&](const std::filesystem::path& file) { return writeGrossBands(scenarios, file); });
    files.add("scenarios.qml", textContent(rasterStyle(coloursOf(commonLegend(scenarios, sheets.legend)))));
    return std::move(files).result();
}

}  // namespace noonmark
