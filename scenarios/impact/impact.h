#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/engines/api/shadow_field.h"
#include "core/study/study.h"

namespace noonmark {

/// What became of a cell between two cities.
enum class CellChange : std::uint8_t {
    none,            ///< a receiver in both, or in neither
    becameBuilding,  ///< ground before, under a building after
    becameGround,    ///< under a building before, ground after
};

/// The difference that a scenario makes: after less before, on the cells that are receivers in both.
struct Impact {
    Grid grid;
    std::vector<float> grossMin;       ///< minutes a day; NaN where it is no receiver in both; grid order
    std::vector<float> continuousMin;  ///< minutes; likewise; NaN everywhere where runs were not counted
    std::vector<CellChange> change;    ///< one a cell
    double sunlitMinutesPerDay = 0;
    double stepMinutes = 1;
    std::string engine;  ///< of both fields: name and settings in words
    Warnings warnings;
};

/// What one building that is new does by itself: the scenario less the scenario without it.
struct BuildingImpact {
    std::string id;
    std::string name;
    Impact impact;
};

/// The cells that are receivers in both cities, and what became of the others; `after` first.
struct CommonReceivers {
    Receivers receivers;
    std::vector<CellChange> change;
};
Result<CommonReceivers> findCommonReceivers(const City& before, const City& after, const Region& region,
                                            const ReceiverSettings& settings,
                                            const std::stop_token& stop = {});

/// Difference of two fields on the same receivers.
Impact differenceOf(const ShadowField& before, const ShadowField& after, std::vector<CellChange> change);

struct ImpactSettings {
    StudySettings study;      ///< region, cells, period, engine: the same for both cities
    bool byBuilding = false;  ///< one more field for each building that is new
};

struct ImpactStudy {
    Impact total;
    std::vector<BuildingImpact> byBuilding;  ///< in the order of the scenario's city
    ShadowField before;
    ShadowField after;
    SunSteps sun;
    Frame frame{{0, 0}};  ///< of the cities
    /// Of total: see measureChangeError(). None: by the ray reference itself, not asked for, or a warning
    /// says why.
    std::optional<SampledError> error;
};

/// All fields with the same engine, receivers and steps; the engine auto is asked once, and what it chose is
/// said in `engine`. A building is new when `before` does not share it (its pointer): both cities come from
/// one project. Error: as of runStudy, receivers on roofs, or no cell is open ground in both. Costs two
/// fields, their error on a sample, and for each new building one where its shadow can fall (with the ray
/// reference, projected shadows and the horizon sweep; with the others one more everywhere).
Result<ImpactStudy> runImpact(const City& before, const City& after, const ImpactSettings& settings,
                              Progress& progress, std::stop_token stop,
                              const EngineList& engines = coreEngines());

}  // namespace noonmark
