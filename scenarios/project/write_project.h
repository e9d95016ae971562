#pragma once

#include "scenarios/project/project.h"
#include "scenarios/project/tables/database.h"

namespace noonmark {

/// Writes what differs between `before`, which the tables hold, and `after`; all of it without `before`. The
/// city costs nothing where its pointer is the same, else as many rows as buildings differ, place by place.
/// Inside the caller's transaction; throws DatabaseTrouble.
void writeChanges(Database& database, const Project* before, const Project& after);

/// The rows of write_project.cpp's parts.
void writeCity(Database& database, const City* before, const City& after);
void writeReading(Database& database, const CityReading& reading);
void writeScenarios(Database& database, const std::vector<Scenario>& before,
                    const std::vector<Scenario>& after);
void writeResult(Database& database, const SavedResult& result);
void removeResult(Database& database, const std::string& name);

/// Sets a row of the table `noonmark`.
void setFact(Database& database, const std::string& key, const std::string& value);
void removeFact(Database& database, const std::string& key);
std::string readFact(Database& database, const std::string& key);  ///< empty where it is not there

}  // namespace noonmark
