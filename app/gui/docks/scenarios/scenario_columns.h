#pragma once

#include <QString>
#include <QVariant>
#include <functional>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "app/report/scenarios/scenario_study.h"
#include "core/describe/figure.h"
#include "scenarios/edits/edit.h"
#include "scenarios/massing/tower_design.h"

namespace noonmark {

/// "Homes 12,300 m², Offices 4,000 m²": the gross floor area of each use that has any. Empty without towers.
QString describeUses(const ScenarioUses& uses);

/// A line for each use, "Homes: 20 storeys, 12,300 m²", and one about towers that are not counted.
QString describeUseLines(const ScenarioUses& uses);

/// A scenario of the table, without what is measured.
struct ScenarioRow {
    std::string scenario;
    std::shared_ptr<const City> city;
    std::optional<std::vector<Edit>> edits;  ///< with those of its bases; none: a base is missing
    ScenarioUses uses;
    std::optional<double> heightM;
};

/// What fills a column.
enum class ScenarioWork { none, measuring, comparing, scoring, reviewing };

/// A column of the table of scenarios. One that shows a figure has its label, definition and unit from there.
struct ScenarioColumn {
    std::string_view key;  ///< of settings and CSV, the same in all languages
    const Figure* figure = nullptr;
    const char* title = nullptr;  ///< %1: the unit; null: the figure's label
    const char* tip = nullptr;    ///< null: the figure's definition
    ScenarioWork work = ScenarioWork::none;
    Better better = Better::none;  ///< where it shows no figure
    bool isCompared = false;       ///< also as a difference to the baseline
    bool isNumber = true;
    /// What it is sorted by; invalid: the scenario has no such value.
    std::function<QVariant(const ScenarioRow&, const ScenarioAnswers&)> value{};
};

/// In their order from the left; the first is the name.
const std::vector<ScenarioColumn>& scenarioColumns();

/// The position of the column with this key, which must exist.
int scenarioColumn(std::string_view key);

/// Which of its values is the best one.
Better betterOf(const ScenarioColumn& column);

/// The title with the unit in use.
QString titleOf(const ScenarioColumn& column);
QString tipOf(const ScenarioColumn& column);

/// A number as its column shows it, in the units in use. `isDifference`: always with its sign.
QString numberText(double value, const ScenarioColumn& column, bool isDifference = false);

}  // namespace noonmark
