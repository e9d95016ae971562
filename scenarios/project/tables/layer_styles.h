#pragma once

#include <string>

#include "scenarios/project/tables/database.h"
#include "scenarios/project/tables/value_bands.h"

namespace noonmark {

/// Creates QGIS's table `layer_styles` with a default style per polygon layer: buildings coloured by height,
/// proposals in a strong colour, lots and regions as outlines, places in green.
void addLayerStyles(Database& database);

/// Adds the style of the layer of places alone, for older files.
void addPlaceStyle(Database& database);

/// Adds the style of a layer of bands; the column `label` selects the colour.
void addBandStyle(Database& database, const std::string& table, const std::vector<ColourClass>& bands);
void removeStyle(Database& database, const std::string& table);

}  // namespace noonmark
