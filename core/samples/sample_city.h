#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "core/city/city.h"
#include "core/receivers/region.h"
#include "core/result.h"

namespace noonmark {

/// A Manhattan-like grid made from a seed.
struct GridSampleSettings {
    int buildings = 2000;        ///< 100 to 50,000
    std::uint32_t seed = 1;
    LonLat origin{-73.985, 40.755};
    int roundness = 0;           ///< extra points on curved facades, 0 to 64: raises the triangle count
};
Result<City> gridSample(const GridSampleSettings& settings);

/// Central Park's southern edge, its streets and blocks, the seven towers of the paper's case study (section 8.1) at their public
/// positions, footprint sizes and roof heights with `status` "built" or "to be built" as of the paper, and Time Warner Center.
City centralParkSouthSample();

/// The park itself, for regions and pictures.
Region centralParkRegion(const City& city);

}  // namespace noonmark
