#pragma once

#include <stop_token>
#include <vector>

#include "core/geo/frame.h"
#include "core/io/footprints/part_grouping.h"
#include "core/io/read_city.h"

namespace noonmark {

/// A polygon on the earth: the outer ring, then holes; closed or not.
using LonLatPolygon = std::vector<std::vector<LonLat>>;

/// A feature as it was read, not yet in a frame.
struct UnplacedFeature {
    FeatureFacts facts;
    std::vector<LonLatPolygon> polygons;  ///< none empty
};

/// The frame at the middle of features: the median of their centres, which a few far away do not move; its
/// elevation is the median of the stated ground elevations, or 0. `features` is not empty.
Frame frameOf(const std::vector<UnplacedFeature>& features);

/// Features in local metres, their outlines repaired. Left out with a warning: what has a point more than
/// `farAwayM` from the frame's origin, and what nothing is left of. Ends early when stopped.
std::vector<PlacedFeature> placeFeatures(std::vector<UnplacedFeature> features, const Frame& frame,
                                         double farAwayM, Warnings& warnings,
                                         const std::stop_token& stop = {});

}  // namespace noonmark
