#pragma once

#include <vector>

#include "core/engines/api/tree_shade.h"
#include "core/io/write_raster.h"
#include "core/measures/has_runs.h"

namespace noonmark {

/// The bands of a study's map: gross and, if `runs`, continuous shadow; then the same with trees. They hold
/// pointers to the field's arrays, which must outlive them.
inline std::vector<RasterBand> makeMapBands(const ShadowField& field, bool runs) {
    std::vector<RasterBand> bands{{"gross shadow", "min/day", &field.grossMin}};
    if (runs) bands.push_back({"continuous shadow", "min", &field.continuousMin});
    for (const ShadeColumn& column : listShadeColumns(field)) {
        const std::string with =
            column.column == TreeColumns::evergreen ? "trees as evergreens" : "trees with seasons";
        bands.push_back({"gross shadow, " + with, "min/day", &column.field->grossMin});
        if (runs && hasRuns(*column.field))
            bands.push_back({"continuous shadow, " + with, "min", &column.field->continuousMin});
    }
    return bands;
}

}  // namespace noonmark
