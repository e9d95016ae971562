#pragma once

#include <QString>
#include <glm/vec3.hpp>

namespace noonmark {

struct City;

// Heights of buildings in the units (app/gui/base/looks/units.h) and from the reference
// (app/gui/base/looks/height_reference.h) in use.

/// Elevation of a point, metres above the vertical datum of the project's data. Without terrain and ground
/// elevations in the data, local z.
double computeElevation(const City& city, glm::dvec3 local);

/// What is added to a height above ground to show it: `groundElevationM` above the datum, else 0.
double heightZeroM(double groundElevationM);

/// "35.0 m above ground", or "47.5 m above datum".
QString describeHeight(double aboveGroundM, double groundElevationM);

}  // namespace noonmark
