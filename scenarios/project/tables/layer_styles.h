#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/measures/colour_scale.h"
#include "scenarios/project/project.h"
#include "scenarios/project/tables/database.h"

namespace noonmark {

/// Bands between round values that cover all values of a result, in ascending order, in the colours of their
/// middles: "60 to 120 min/day". The bound farther from zero is exclusive, except in the outermost band.
class ValueBands {
public:
    /// `change`: values may be negative, and zero is in no band. Otherwise all values must be 0 or more.
    ValueBands(std::span<const float> values, const std::string& unit, bool change);

    [[nodiscard]] const std::vector<ColourClass>& bands() const { return bands_; }
    [[nodiscard]] int bandOf(float value) const;  ///< index into bands(); -1: in no band, as for NaN

private:
    LegendScale scale_;
    bool change_;
    int each_;  // number of bands on one side of zero
    std::vector<ColourClass> bands_;
};

/// Creates QGIS's table `layer_styles` with a default style per polygon layer: buildings coloured by height,
/// proposals in a strong colour, lots and regions as outlines, places in green.
void addLayerStyles(Database& database);

/// Adds the style of the layer of places alone, for older files.
void addPlaceStyle(Database& database);

/// Adds the style of a layer of bands; the column `label` selects the colour.
void addBandStyle(Database& database, const std::string& table, const std::vector<ColourClass>& bands);
void removeStyle(Database& database, const std::string& table);

/// GIS programs show the cells of a saved layer in grey. This adds the bands of the layer as polygons in the
/// program's colours, in the layer `tiles`_bands. The program never reads them back. Throws DatabaseError.
void writeBands(Database& database, const SavedResult& result, const SavedLayer& layer,
                const std::string& tiles);
void removeBands(Database& database, const std::string& tiles);  ///< no effect where there are none

}  // namespace noonmark
