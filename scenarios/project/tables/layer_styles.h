#pragma once

#include <string>

#include "scenarios/project/tables/database.h"
#include "scenarios/project/tables/value_bands.h"

namespace noonmark {

/// Adds QGIS's table `layer_styles` with a default style for every polygon layer: buildings by height,
/// proposals by a strong colour, lots and regions as outlines.
void addLayerStyles(Database& database);

/// The style of a layer of bands, which its column `label` tells apart.
void addBandStyle(Database& database, const std::string& table, const std::vector<ValueBand>& bands);
void removeStyle(Database& database, const std::string& table);

}  // namespace noonmark
