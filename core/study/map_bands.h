#pragma once

#include <vector>

#include "core/accumulate/shadow_field.h"
#include "core/io/write_raster.h"

namespace noonmark {

/// The bands of a study's map. They hold pointers to the field's arrays: it outlives them.
inline std::vector<RasterBand> mapBands(const ShadowField& field) {
    return {{"gross shadow", "min/day", &field.grossMin}, {"continuous shadow", "min", &field.continuousMin}};
}

}  // namespace noonmark
