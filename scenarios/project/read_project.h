#pragma once

#include "scenarios/project/project.h"
#include "scenarios/project/tables/database.h"

namespace noonmark {

/// Reads the project from tables of schemaVersion. Throws DatabaseError, also for invalid content.
Project readProject(Database& database);

/// The parts of readProject(). `warnings`: what was found wrong in layers that GIS programs may edit.
std::shared_ptr<const City> readCityTables(Database& database, Warnings& warnings);
std::shared_ptr<const CityReading> readReading(Database& database);
std::vector<std::shared_ptr<const SavedResult>> readResults(Database& database);
std::vector<MeasuredElement> readElements(Database& database, std::int64_t result);
std::vector<NamedPeriod> readPeriods(Database& database);
std::vector<SavedView> readSavedViews(Database& database);
SheetSettings readSheetSettings(Database& database);
std::shared_ptr<const MapContext> readContext(Database& database);  ///< null where there is none
/// On the ground of `city`; null where there are none. What a row leaves empty is completed (completeTree());
/// so are words that are unknown and a crown's base above the top, counted in warnings.
std::shared_ptr<const Trees> readTreeTable(Database& database, const City& city, Warnings& warnings);

}  // namespace noonmark
