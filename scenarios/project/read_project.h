#pragma once

#include "scenarios/project/project.h"
#include "scenarios/project/tables/database.h"

namespace noonmark {

/// The project that the tables of schemaVersion hold. Throws DatabaseTrouble, also for contents that make no
/// sense.
Project readProject(Database& database);

/// Parts of it.
std::shared_ptr<const City> readCityTables(Database& database);
std::shared_ptr<const CityReading> readReading(Database& database);
std::vector<std::shared_ptr<const SavedResult>> readResults(Database& database);

}  // namespace noonmark
