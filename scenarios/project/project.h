#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/city/city.h"
#include "core/geo/grid.h"
#include "core/io/heights/height_facts.h"
#include "core/receivers/region.h"
#include "core/study/provenance/provenance.h"
#include "core/sun/period.h"
#include "scenarios/scenario.h"
#include "scenarios/weights/time_weights.h"

namespace noonmark {

/// Ground that is built on.
struct NamedLot {
    std::string name;
    Footprint outline;
    bool operator==(const NamedLot&) const = default;
};

/// How the city was read from its files, and what was noted then. It belongs to the city: every answer about
/// the city, or about a scenario of it, states these warnings.
struct CityReading {
    /// Nothing: not known, as of a project file of version 1.
    std::optional<ReadSettings> settings = ReadSettings{};
    Warnings warnings;
    HeightFacts heights;  ///< the fields that heights were read from
};

struct NamedPeriod {
    std::string name;
    Period period;
    bool operator==(const NamedPeriod&) const = default;
};

/// One map of a kept result.
struct SavedLayer {
    std::string name;           ///< "gross shadow"
    std::string unit;           ///< "min/day"
    std::vector<float> values;  ///< grid order, NaN where there is no receiver
};

/// A result that the user keeps, with all that it rests on.
struct SavedResult {
    std::string name;      ///< unique in a project
    std::string kind;      ///< "study", "impact" or "score"
    std::string scenario;  ///< the city that it is of
    std::string baseline;  ///< impact: the city that it is compared with; else empty
    std::string settings;  ///< JSON: engine, period, region, figures, as study.json has them
    std::string inputs;    ///< JSON: path, bytes and sha256 of every file that the city was read from
    Grid grid;
    std::vector<SavedLayer> layers;
};

/// All that one project file holds. A value: cheap to copy for undo, since the city and the results are
/// shared. Equality of those, and of the reading, is that of the pointer.
struct Project {
    std::shared_ptr<const City> city =
        std::make_shared<const City>();  ///< as it stands; ids unique, never null
    std::string attribution;
    std::vector<InputFile> inputs;  ///< the city's files
    /// Of those files; shared like the city, never null.
    std::shared_ptr<const CityReading> reading = std::make_shared<const CityReading>();
    std::vector<NamedLot> lots;
    std::vector<Region> regions;
    std::vector<Scenario> scenarios;
    std::vector<TimeWeights> weights{makeMonthlyWeights()};
    std::vector<NamedPeriod> periods;
    std::vector<std::shared_ptr<const SavedResult>> results;
    std::map<std::string, std::string> view;  ///< camera, layout, switches: keys are the window's own
};

/// What a name means, or an Error that lists the names there are.
Result<NamedLot> findLot(const Project& project, const std::string& name);
Result<Region> findRegion(const Project& project, const std::string& name);
Result<TimeWeights> findWeights(const Project& project, const std::string& name);
Result<NamedPeriod> findPeriod(const Project& project, const std::string& name);
Result<std::shared_ptr<const SavedResult>> findResult(const Project& project, const std::string& name);
Result<Scenario> findScenarioByName(const Project& project, const std::string& name);

/// What a scenario, or existingCity, makes of the project's city.
Result<EditedCity> cityOf(const Project& project, const std::string& scenario);

/// Error: names that are missing or double, scenarios or tables that are not sound.
Result<void> checked(const Project& project);

}  // namespace noonmark
