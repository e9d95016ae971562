#pragma once

#include "scenarios/project/database.h"

namespace noonmark {

/// Adds QGIS's table `layer_styles` with a default style for every polygon layer: buildings by height,
/// proposals by a strong colour, lots and regions as outlines.
void addLayerStyles(Database& database);

}  // namespace noonmark
