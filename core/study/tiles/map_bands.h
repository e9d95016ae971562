#pragma once

#include <vector>

#include "core/engines/api/shadow_field.h"
#include "core/io/write_raster.h"

namespace noonmark {

/// The bands of a study's map: gross and, if `runs`, continuous shadow. They hold pointers to the field's
/// arrays, which must outlive them.
inline std::vector<RasterBand> makeMapBands(const ShadowField& field, bool runs) {
    std::vector<RasterBand> bands{{"gross shadow", "min/day", &field.grossMin}};
    if (runs) bands.push_back({"continuous shadow", "min", &field.continuousMin});
    return bands;
}

}  // namespace noonmark
