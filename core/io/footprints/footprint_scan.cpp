#include "core/io/footprints/footprint_scan.h"

#include <algorithm>
#include <cmath>

namespace noonmark {

void FootprintScan::add(const UnplacedFeature& feature) {
    LonLatBox own = emptyLonLatBox;
    for (const LonLatPolygon& polygon : feature.polygons)
        for (const LonLat place : polygon.front()) own.add(place);
    box.add({own.westDeg, own.southDeg});
    box.add({own.eastDeg, own.northDeg});
    ++features;
    const auto cellOf = [](double degrees) { return int(std::floor(degrees / cellDeg)); };
    for (int row = cellOf(own.southDeg); row <= cellOf(own.northDeg); ++row)
        for (int column = cellOf(own.westDeg); column <= cellOf(own.eastDeg); ++column) {
            double& tallest = tallestM[{column, row}];
            tallest = std::max(tallest, feature.facts.heights.topM);
        }
}

}  // namespace noonmark
