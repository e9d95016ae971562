#pragma once

// The folder core/samples makes the sample cities (this file): a grid from a seed (grid_sample.cpp) and
// Central Park's southern end (central_park_south_sample.cpp, central_park.h). Both place buildings the same
// way: street_axes.h describes streets and blocks, lot_building.h divides blocks into lots, makes buildings
// on them, and gives the same random numbers on every machine.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/city/city.h"
#include "core/city/map_context.h"
#include "core/receivers/place.h"
#include "core/receivers/receivers.h"

namespace noonmark {

/// A Manhattan-like grid made from a seed: blocks of 80 x 274 m between avenues of 30 m and streets of 18 m,
/// turned by 29 degrees; lots of 7.5 to 30 m with party walls, yards, courtyards, setbacks and towers; one
/// skewed avenue; log-normal heights around two taller quarters.
struct GridSampleSettings {
    int buildings = 2000;  ///< exactly this number, 100 to 50,000
    std::uint32_t seed = 1;
    LonLat origin{-73.985, 40.755};
    /// Extra points on each curved facade, 0 to 64: raises the triangle count. 43,000 buildings have 0.82 M
    /// triangles at 0, 1.01 M at 7 and 1.52 M at 25.
    int roundness = 0;
};

/// Identical to the last bit for the same settings on every machine. Error for a setting out of range. About
/// 6 us per building.
Result<City> makeGridSample(const GridSampleSettings& settings);

/// Central Park's southern end: its streets and blocks with made-up buildings of 20 to 200 m, the seven
/// towers of the paper's case study (section 8.1) at their published positions, with their floor sizes, roof
/// heights and `status` "built" or "to be built" as of the paper, and Time Warner Center. Some 3,100
/// buildings; the named ones come first and stand alone on their lots. The streets are an ideal grid,
/// accurate to some 15 m; a tower stands within 30 m of its published position.
City makeCentralParkSouthSample();

/// The park from 59th to 72nd Street, for regions and pictures, in the city's frame.
Region centralParkRegion(const City& city);

/// Its ground as maps draw it: the park, the streets, avenues and Broadway of the ideal grid.
MapContext makeCentralParkContext(const Frame& frame);

/// Its places: Central Park, and streets and avenues cut at their junctions ("West 58th Street, Seventh
/// Avenue to Sixth Avenue"), with their sidewalks; some 340.
std::vector<Place> listCentralParkPlaces(const Frame& frame);

/// The lot of one of the seven towers of Central Park South.
struct CaseStudyLot {
    std::string tower;  ///< the tower's name, which is also its id in the sample
    Footprint ground;
};

/// The empty lots under the seven towers, those of one tower joined: each holds its tower and no other
/// building. In the city's frame, in the order of the towers.
std::vector<CaseStudyLot> listCaseStudyLots(const City& city);

}  // namespace noonmark
