#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/city/city.h"
#include "core/receivers/region.h"

namespace noonmark {

/// A Manhattan-like grid made from a seed: blocks of 80 x 274 m between avenues of 30 m and streets of 18 m,
/// turned by 29 degrees; lots of 7.5 to 30 m with party walls, yards, courtyards, setbacks and towers; one
/// skewed avenue; log-normal heights around two taller quarters.
struct GridSampleSettings {
    int buildings = 2000;  ///< exactly so many, 100 to 50,000
    std::uint32_t seed = 1;
    LonLat origin{-73.985, 40.755};
    /// Extra points on each curved facade, 0 to 64: raises the triangle count. 43,000 buildings have 0.82 M
    /// triangles at 0, 1.01 M at 7 and 1.52 M at 25.
    int roundness = 0;
};

/// The same city, to the last bit, for the same settings on every machine. Error for a setting out of range.
/// About 6 us a building.
Result<City> makeGridSample(const GridSampleSettings& settings);

/// Central Park's southern end, its streets and blocks with made-up buildings of 20 to 200 m, the seven
/// towers of the paper's case study (section 8.1) at their public positions, floor sizes and roof heights
/// with `status` "built" or "to be built" as of the paper, and Time Warner Center. Some 3,100 buildings; the
/// named ones come first and stand alone on their lots. The streets are an ideal grid, true to some 15 m; a
/// tower stands within 30 m of its public place.
City makeCentralParkSouthSample();

/// The park itself from 59th to 72nd Street, for regions and pictures, in the city's frame.
Region centralParkRegion(const City& city);

/// The ground around one of the seven towers of Central Park South.
struct CaseStudyLot {
    std::string tower;  ///< its name, and its id in the sample
    Footprint ground;
};

/// The lots that stay empty for the seven towers, those of one tower joined: each holds its tower and no
/// other building. In the city's frame, in the order of the towers.
std::vector<CaseStudyLot> listCaseStudyLots(const City& city);

}  // namespace noonmark
