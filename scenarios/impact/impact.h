#pragma once

// The folder scenarios/impact/ compares two cities. This file computes the two fields, their difference and
// the contribution of each new building, and measures the error against the ray reference; impact_figures.h
// sums the difference up; impact_text.h writes JSON and CSV; tile_subjects.h compares cities tile by tile.

#include <array>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/describe/field.h"
#include "core/engines/api/shadow_field.h"
#include "core/engines/api/tree_shade.h"
#include "core/study/study.h"

namespace noonmark {

/// How a cell changed between two cities.
enum class CellChange : std::uint8_t {
    none,            ///< a receiver in both cities, or in neither
    becameBuilding,  ///< open ground before, under a building after
    becameGround,    ///< under a building before, open ground after
};

/// The change from one city to the other where receivers are on the ground; a roof counts as building. `none`
/// also where the cell is outside the region of either.
CellChange compareKinds(CellKind before, CellKind after);

/// Changes of no more minutes are float32 rounding, and count as none.
inline constexpr double noChangeMin = 1e-3;
/// Minutes of more or less shadow above which area counts, where no others are asked for: that of the paper's
/// case study, and that of Boston's rules.
inline constexpr std::array defaultThresholdsMin{30.0, 60.0};

/// The change that a scenario causes: after minus before, on cells that are receivers in both cities.
struct Impact {
    Grid grid;
    std::vector<float> grossMin;       ///< minutes a day, grid order; NaN unless a receiver in both cities
    std::vector<float> continuousMin;  ///< minutes; likewise; all NaN if not computed
    std::vector<CellChange> change;    ///< one per cell, grid order
    double sunlitMinutesPerDay = 0;
    double stepMinutes = 1;
    double waterM2 = 0;  ///< of the region's cells on water, which are no receivers
    std::string engine;  ///< of both fields: name and settings, as text
    Warnings warnings;
};

/// The change of the shadow with trees, which are planted and felled as buildings are built and demolished.
struct ShadeImpact {
    TreeColumns column = TreeColumns::seasonal;  ///< or evergreen
    Impact impact;
};

/// The sole contribution of one new building: the scenario minus the scenario without it.
struct BuildingImpact {
    std::string id;
    std::string name;
    Impact impact;
};

/// The cells that are receivers in both cities, with the heights of `after`, and how the other cells changed.
struct CommonReceivers {
    Receivers receivers;
    std::vector<CellChange> change;
};
Result<CommonReceivers> findCommonReceivers(const City& before, const City& after, const Region& region,
                                            const ReceiverSettings& settings,
                                            const std::stop_token& stop = {});
/// The same in any part of their grid, with identical cells.
Result<CommonReceivers> findCommonReceiversInPart(const City& before, const City& after, const Region& region,
                                                  const Grid& part, const std::stop_token& stop = {});

/// The difference of two fields on the same receivers.
Impact computeDifference(const ShadowField& before, const ShadowField& after, std::vector<CellChange> change);

struct ImpactSettings {
    static constexpr double maxThresholdMin = 1440;

    StudySettings study{};    ///< region, cells, period and engine: the same for both cities
    bool byBuilding = false;  ///< also compute one field per new building
    /// Minutes of more or less shadow a day above which area counts; at least one, each 0 to 1440.
    std::vector<double> thresholdsMin{defaultThresholdsMin.begin(), defaultThresholdsMin.end()};

    bool operator==(const ImpactSettings&) const = default;
};

/// All but those of the study.
const Fields<ImpactSettings>& impactFields();

struct ImpactStudy {
    Impact total;                            ///< without trees
    std::vector<ShadeImpact> withTrees;      ///< evergreens first; none where no tree reaches a receiver
    std::vector<BuildingImpact> byBuilding;  ///< in the order of the buildings in the scenario's city
    ShadowField before;
    ShadowField after;
    SunSteps sun;
    Frame frame{{0, 0}};  ///< of the cities
    /// Error of `total` against the ray reference, see measureChangeError(). Empty where the ray reference
    /// itself was the engine, where no error was requested, or where a warning states why it is missing.
    std::optional<SampledError> error;
};

/// Computes all fields with the same engine, receivers and steps. The engine "auto" chooses once for all
/// fields, and again for all where the sampled error of the change is more than its choice aims at; `engine`
/// states its choice. A building is new if `before` does not share its pointer, so both
/// cities must come from one project. Error: as of runStudy(), receivers on roofs, or no cell is open ground
/// in both cities. Cost: two fields, their error on a sample, and per new building one more field. The ray
/// reference, projected shadows and the horizon sweep on flat ground compute that field only where the
/// building's shadow can fall; other engines compute it everywhere.
Result<ImpactStudy> runImpact(const City& before, const City& after, const ImpactSettings& settings,
                              Progress& progress, std::stop_token stop,
                              const EngineList& engines = coreEngines());

}  // namespace noonmark
