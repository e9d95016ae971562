#pragma once

#include "scenarios/project/project.h"
#include "scenarios/project/tables/database.h"

namespace noonmark {

inline constexpr const char* groundPictureKey = "ground_picture";  ///< in the table noonmark, as JSON

/// Writes the differences between `before`, which the tables hold, and `after`; without `before` it writes
/// everything. An unchanged city (same pointer) costs nothing; otherwise the rows of the buildings that
/// differ are written, compared index by index. Runs inside the caller's transaction; throws DatabaseError.
void writeChanges(Database& database, const Project* before, const Project& after);

/// The parts of writeChanges().
void writeCity(Database& database, const City* before, const City& after);
void writeReading(Database& database, const CityReading& reading);
void writeScenarios(Database& database, const std::vector<Scenario>& before,
                    const std::vector<Scenario>& after);
void writeResult(Database& database, const SavedResult& result);
/// The points of a saved result; `result`: its row in the table `results`.
void writeElements(Database& database, std::int64_t result, const std::vector<MeasuredElement>& elements);
void removeResult(Database& database, const std::string& name);
void writeContext(Database& database, const MapContext* context);  ///< null: removes it
void writeTrees(Database& database, const Trees* trees);           ///< null: removes them
void writePeriods(Database& database, const std::vector<NamedPeriod>& periods);
void writeSavedViews(Database& database, const std::vector<SavedView>& views);
void writeSheetSettings(Database& database, const SheetSettings& settings);

/// Inserts or updates a row of the table `noonmark`.
void setFact(Database& database, const std::string& key, const std::string& value);
void removeFact(Database& database, const std::string& key);
std::string readFact(Database& database, const std::string& key);  ///< empty where there is no such row

}  // namespace noonmark
