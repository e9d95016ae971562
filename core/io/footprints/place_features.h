#pragma once

#include <cstddef>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/city/footprints/footprint.h"
#include "core/geo/frame.h"
#include "core/io/footprints/feature_facts.h"
#include "core/io/settings/read_settings.h"

namespace noonmark {

/// A feature with its shape in local metres.
struct PlacedFeature {
    FeatureFacts facts;
    std::vector<Footprint> pieces;  ///< at least one; disjoint
};

/// The features that make up one building, as indices.
struct BuildingGroup {
    std::optional<std::size_t> outline;
    std::vector<std::size_t> parts;  ///< may include the outline, if it is tagged as a part too
};

/// Groups features into buildings: features with the same stated building id; otherwise an outline with the
/// parts that it covers by more than half (if several outlines do, the one that covers most, then the smaller
/// one). Parts without an outline form one building if they overlap in plan. Every feature is in exactly one
/// group. Groups are in the order of their first feature.
std::vector<BuildingGroup> groupIntoBuildings(const std::vector<PlacedFeature>& features);

/// A polygon on the earth: the outer ring, then holes; closed or not.
using LonLatPolygon = std::vector<std::vector<LonLat>>;

/// A feature as read, not yet in a frame.
struct UnplacedFeature {
    FeatureFacts facts;
    std::vector<LonLatPolygon> polygons;  ///< none of them empty
};

/// The middle of features that are not all in memory at once: 16 to 24 bytes a feature.
class FeatureCentres {
public:
    void add(const UnplacedFeature& feature);
    /// The frame at the middle of the features: the median of their centres, which a few distant features do
    /// not move. Where less than half of them lie within `farAwayM` of that (several places in one file), the
    /// median of the place with most features. Its elevation is the median of the stated ground elevations,
    /// or 0. At least one feature was added.
    [[nodiscard]] Frame frame(double farAwayM) const;

private:
    [[nodiscard]] LonLat middle(double farAwayM) const;
    double nearLonDeg_ = 0;
    std::vector<double> lons_, lats_, elevations_;
};

/// The frame at the middle of the features (FeatureCentres); `features` is not empty.
Frame frameOf(const std::vector<UnplacedFeature>& features, double farAwayM);

/// Transforms features to local metres and repairs their outlines. Left out with a warning: features with a
/// point more than `farAwayM` from the frame's origin, and features without a usable outline. Ends early when
/// stopped.
std::vector<PlacedFeature> placeFeatures(std::vector<UnplacedFeature> features, const Frame& frame,
                                         double farAwayM, Warnings& warnings,
                                         const std::stop_token& stop = {});

}  // namespace noonmark
