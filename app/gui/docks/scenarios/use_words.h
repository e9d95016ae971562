#pragma once

#include <QString>

#include "scenarios/massing/tower_design.h"

namespace noonmark {

/// "Homes 12,300 m², Offices 4,000 m²": the gross floor area of each use that has any. Empty without towers.
QString describeUses(const ScenarioUses& uses);

/// A line for each use, "Homes: 20 storeys, 12,300 m²", and one about towers that are not counted.
QString describeUseLines(const ScenarioUses& uses);

}  // namespace noonmark
