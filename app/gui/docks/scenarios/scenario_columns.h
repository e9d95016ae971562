#pragma once

#include "app/gui/docks/scenarios/scenario_table.h"

namespace noonmark {

/// What the heading of a column states: its title with the unit in use, its tip, its key. Empty for other
/// roles.
QVariant headingOf(ScenarioTable::Column column, int role);

/// A figure as its column shows it, in the units in use.
QString numberText(double value, ScenarioTable::Column column);

}  // namespace noonmark
