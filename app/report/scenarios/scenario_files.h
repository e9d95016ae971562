#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/report/book/book.h"
#include "app/report/scenarios/scenario_study.h"
#include "core/io/files/check_output.h"

namespace noonmark {

/// scenarios.csv, scenario_uses.csv, scenario_months.csv, scenarios.json, scenarios.pdf, scenarios.tif,
/// scenarios.qml.
/// Those of months are written only where they were computed.
std::vector<std::string> scenarioFileNames();

/// Writes the same study of several scenarios into a folder, which is created if missing: the table, the
/// floor areas by use, the months, the record, the sheets, and a GeoTIFF with a band of gross shadow for each
/// scenario, with its style for QGIS. `failed`: named in the record. Returns the paths written; all files or
/// none. Error: there is no
/// scenario, their grids differ, or a file cannot be written. Needs a QGuiApplication (the `offscreen`
/// platform suffices).
Result<std::vector<std::filesystem::path>> writeScenarioFiles(const ScenarioStudies& scenarios,
                                                              const BookSettings& sheets,
                                                              const std::filesystem::path& folder,
                                                              const OutputRules& rules = {},
                                                              const FailedScenarios& failed = {});

}  // namespace noonmark
