#pragma once

#include <QString>

#include "scenarios/massing/copy_massing.h"
#include "scenarios/massing/fit_floor_area.h"

namespace noonmark {

/// "10 storeys"
QString describeStoreys(int storeys);
/// The same where the storeys follow from the height and a usual storey: "about 12 storeys".
QString describeAssumedStoreys(int storeys);

/// Two lines, "35.0 m above ground, 10 storeys / 12,345 m² floor area, FAR 8.21", shown beside the cursor
/// while a tower is extruded.
QString describeFigures(const MassingFigures& figures, double groundElevationM);

/// "14°", "8 storeys", "62 %": the number with which the tower fits.
QString describeNearest(const NearestFit& fit);

/// What a copy of a tower had to change to fit its lot; empty: nothing.
QString describeCopy(const CopiedMassing& copy);

/// "12.0 m east, 3.5 m south"
QString describeMove(glm::dvec2 byM);

}  // namespace noonmark
