#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/report/book/book.h"
#include "app/report/scenarios/scenario_study.h"
#include "core/io/files/check_output.h"

namespace noonmark {

/// The legend of the scenario with most shadow at any receiver, which the maps of all of them share.
Legend commonLegend(const ScenarioStudies& scenarios, const LegendChoice& choice);

/// The book of several scenarios: their maps side by side with what each builds, their figures in one table,
/// a page of charts for each figure of months (scenario_months.h), then a page for each scenario with its map
/// of gross shadow, all on the scale of the largest value, and what they were made from. `scenarios`, at
/// least one, must outlive the book. `failed`: named in the record.
Book makeScenarioBook(const ScenarioStudies& scenarios, const BookSettings& settings,
                      const FailedScenarios& failed = {});

/// scenarios.csv, scenario_uses.csv, scenario_months.csv, scenarios.json, scenarios.pdf, scenarios.tif,
/// scenarios.qml, region.geojson.
/// Those of months are written only where they were computed, the region only where the command that repeats
/// the measurement names it.
std::vector<std::string> scenarioFileNames();

/// Writes the same study of several scenarios into a folder, which is created if missing: the table, the
/// floor areas by use, the months, the record, from which `noonmark-cli verify` measures them again, the
/// sheets, and a GeoTIFF with a band of gross shadow for each scenario, with its style for QGIS.
/// `failed`: named in the record. Returns the paths written; all files or
/// none. Error: there is no
/// scenario, their grids differ, or a file cannot be written. Needs a QGuiApplication (the `offscreen`
/// platform suffices).
Result<std::vector<std::filesystem::path>> writeScenarioFiles(const ScenarioStudies& scenarios,
                                                              const BookSettings& sheets,
                                                              const std::filesystem::path& folder,
                                                              const OutputRules& rules = {},
                                                              const FailedScenarios& failed = {});

}  // namespace noonmark
