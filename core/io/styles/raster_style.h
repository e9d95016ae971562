#pragma once

#include <string>

#include "core/measures/colour_scale.h"

namespace noonmark {

/// The colours of a map as a style of QGIS (QML) for the first band of a raster, which QGIS takes by itself
/// if the file lies beside the raster under its name. The values are those of the file, minutes of shadow (of
/// a score, the score); the labels are in the unit shown. What the scale leaves free is transparent.
std::string rasterStyle(const ColourScale& scale);

}  // namespace noonmark
