#include "core/io/footprints/place_features.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <iterator>
#include <map>
#include <numeric>
#include <string_view>
#include <unordered_map>

#include "core/base/stop_scope.h"
#include "core/city/footprints/plan_overlay.h"
#include "core/city/footprints/repair_footprint.h"
#include "core/city/meshes/mesh_outline.h"
#include "core/describe/text.h"
#include "core/geo/lon_lat.h"

namespace noonmark {

namespace {

using Features = std::vector<PlacedFeature>;
using Indices = std::vector<std::size_t>;
constexpr std::size_t none = ~std::size_t(0);

std::vector<Box2> boxesOf(const Features& features, const Indices& indices) {
    std::vector<Box2> boxes(indices.size());
    for (std::size_t i = 0; i < indices.size(); ++i)
        for (const Footprint& piece : features[indices[i]].pieces) boxes[i].add(bounds(piece));
    return boxes;
}

double computeSharedArea(const Box2& a, const Box2& b) {
    const glm::dvec2 size = glm::dvec2(glm::min(a.high, b.high)) - glm::dvec2(glm::max(a.low, b.low));
    return std::max(0.0, size.x) * std::max(0.0, size.y);
}

// The best outline so far for a part.
struct Owner {
    std::size_t outline = none;
    double share = 0.5;
    double outlineArea = 0;

    void offer(std::size_t other, double otherShare, double otherArea) {
        constexpr double sameShare = 0.01;
        const bool smaller = otherShare > share - sameShare && otherArea < outlineArea;
        if (otherShare <= share + sameShare && !(outline != none && smaller)) return;
        *this = {other, otherShare, otherArea};
    }
};

// A part and an outline, as places in the lists of them, and the share of the part that the outline covers.
struct Cover {
    std::size_t part, outline;
    double share = 0;
};

// Of pairs whose boxes meet: those that may share more than half of the part.
std::vector<Cover> coversOf(const Features& features, const Indices& parts, const Indices& outlines) {
    const auto partBoxes = boxesOf(features, parts);
    const auto outlineBoxes = boxesOf(features, outlines);
    std::vector<Cover> covers;
    for (const auto& [p, o] : findMeetingBoxes(partBoxes, outlineBoxes))
        if (2 * computeSharedArea(partBoxes[p], outlineBoxes[o]) >= area(features[parts[p]].pieces))
            covers.push_back({p, o});
    tbb::parallel_for(std::size_t{0}, covers.size(), [&](std::size_t i) {
        const auto& part = features[parts[covers[i].part]].pieces;
        const auto& outline = features[outlines[covers[i].outline]].pieces;
        covers[i].share = computeSharedArea(part, outline) / area(part);
    });
    return covers;
}

std::vector<Owner> ownersOf(const Features& features, const Indices& parts, const Indices& outlines) {
    std::vector<Owner> owners(parts.size());
    for (const Cover& cover : coversOf(features, parts, outlines)) {
        const std::size_t outline = outlines[cover.outline];
        owners[cover.part].offer(outline, cover.share, area(features[outline].pieces));
    }
    return owners;
}

class Grouping {
public:
    explicit Grouping(const Features& features) : features_(features) {}

    std::vector<BuildingGroup> groups() {
        sortByKind();
        for (const std::size_t outline : outlines_) addOutline(outline);
        addParts();
        std::ranges::sort(groups_, {}, firstFeature);
        return std::move(groups_);
    }

private:
    static std::size_t firstFeature(const BuildingGroup& group) {
        std::size_t first = group.outline.value_or(none);
        for (const std::size_t part : group.parts) first = std::min(first, part);
        return first;
    }

    void sortByKind() {
        std::unordered_map<std::string_view, std::size_t> groupOfId;
        for (std::size_t i = 0; i < features_.size(); ++i) {
            const FeatureFacts& facts = features_[i].facts;
            if (!facts.buildingId.empty()) {
                const auto [place, isNew] = groupOfId.try_emplace(facts.buildingId, groups_.size());
                if (isNew) groups_.emplace_back();
                groups_[place->second].parts.push_back(i);
            } else {
                (facts.outline ? outlines_ : parts_).push_back(i);
            }
        }
    }

    void addOutline(std::size_t outline) {
        groupOfOutline_[outline] = groups_.size();
        BuildingGroup group{outline, {}};
        if (features_[outline].facts.part) group.parts.push_back(outline);
        groups_.push_back(std::move(group));
    }

    void addParts() {
        const std::vector<Owner> owners = ownersOf(features_, parts_, outlines_);
        Indices alone;
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            if (owners[i].outline == none)
                alone.push_back(parts_[i]);
            else
                groups_[groupOfOutline_[owners[i].outline]].parts.push_back(parts_[i]);
        }
        addPartsWithoutOutline(alone);
    }

    void addPartsWithoutOutline(const Indices& parts) {
        std::vector<std::vector<Footprint>> shapes;
        for (const std::size_t part : parts) shapes.push_back(features_[part].pieces);
        const Indices numbers = groupOverlapping(shapes);
        const std::size_t first = groups_.size();
        for (std::size_t i = 0; i < parts.size(); ++i) {
            groups_.resize(std::max(groups_.size(), first + numbers[i] + 1));
            groups_[first + numbers[i]].parts.push_back(parts[i]);
        }
    }

    const Features& features_;
    Indices outlines_, parts_;
    std::unordered_map<std::size_t, std::size_t> groupOfOutline_;
    std::vector<BuildingGroup> groups_;
};

}  // namespace

std::vector<BuildingGroup> groupIntoBuildings(const std::vector<PlacedFeature>& features) {
    return Grouping(features).groups();
}

namespace {

double medianOf(std::vector<double> values) {
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

// Centre of the outer ring's box. Longitudes are taken near `nearLonDeg`, so that data on both sides of 180
// degrees stays together.
LonLat centreOf(const UnplacedFeature& feature, double nearLonDeg) {
    LonLat low{1e9, 1e9};
    LonLat high{-1e9, -1e9};
    for (const LonLat place : feature.polygons.front().front()) {
        const double lon = nearLonDeg + std::remainder(place.lonDeg - nearLonDeg, 360.0);
        low = {std::min(low.lonDeg, lon), std::min(low.latDeg, place.latDeg)};
        high = {std::max(high.lonDeg, lon), std::max(high.latDeg, place.latDeg)};
    }
    return {(low.lonDeg + high.lonDeg) / 2, (low.latDeg + high.latDeg) / 2};
}

// Along a meridian and then along a parallel is never shorter than the great circle, and quickly computed.
bool isWithin(LonLat place, LonLat middle, double farAwayM) {
    constexpr double metresPerDegree = 111200;  // no less than on computeGreatCircleM()'s sphere
    const double detourDeg = std::abs(place.latDeg - middle.latDeg) + std::abs(place.lonDeg - middle.lonDeg);
    return metresPerDegree * detourDeg <= farAwayM || computeGreatCircleM(place, middle) <= farAwayM;
}

// The points of the square of that width, on a grid in degrees, that holds most of them; of equal ones the
// first.
std::vector<std::size_t> findFullestPlace(const std::vector<double>& lons, const std::vector<double>& lats,
                                          double widthM) {
    constexpr double metresPerDegree = 111200;
    const double side = widthM / metresPerDegree;
    std::map<std::pair<long, long>, std::vector<std::size_t>> squares;
    const std::vector<std::size_t>* fullest = nullptr;
    for (std::size_t i = 0; i < lons.size(); ++i)
        squares[{std::lround(lons[i] / side), std::lround(lats[i] / side)}].push_back(i);
    for (const auto& [square, points] : squares)
        if (fullest == nullptr || points.size() > fullest->size() ||
            (points.size() == fullest->size() && points.front() < fullest->front()))
            fullest = &points;
    return *fullest;
}

bool isNear(const UnplacedFeature& feature, LonLat middle, double farAwayM) {
    for (const LonLatPolygon& polygon : feature.polygons)
        for (const auto& ring : polygon)
            for (const LonLat place : ring)
                if (!isWithin(place, middle, farAwayM)) return false;
    return true;
}

std::vector<RawRing> localRings(const LonLatPolygon& polygon, const Frame& frame) {
    std::vector<RawRing> rings;
    for (const auto& ring : polygon) {
        RawRing& local = rings.emplace_back();
        for (const LonLat place : ring) local.push_back(frame.localFromLonLat(place));
    }
    return rings;
}

// Joins polygons of one feature that overlap or share a wall.
std::vector<Footprint> disjoint(std::vector<Footprint> pieces, const std::string& id, Warnings& warnings) {
    constexpr double sameAreaM2 = 0.01;
    auto joined = computeUnion(pieces);
    const bool same = joined.size() == pieces.size() && area(pieces) - area(joined) < sameAreaM2;
    if (same || joined.empty()) return pieces;
    warnings.push_back(
        {WarningKind::repaired, NM_TEXT("its polygons overlapped or shared a wall and were joined"), id});
    return joined;
}

std::vector<Footprint> repair(const UnplacedFeature& feature, const Frame& frame, Warnings& warnings) {
    std::vector<Footprint> pieces;
    for (const LonLatPolygon& polygon : feature.polygons) {
        RepairedFootprint result = repairFootprint(localRings(polygon, frame));
        if (!result.what.empty()) warnings.push_back({result.kind, result.what, feature.facts.id});
        std::ranges::move(result.pieces, std::back_inserter(pieces));
    }
    return pieces.size() > 1 ? disjoint(std::move(pieces), feature.facts.id, warnings) : pieces;
}

bool isTooLarge(const UnplacedFeature& feature) {
    std::size_t points = 0;
    for (const LonLatPolygon& polygon : feature.polygons)
        for (const auto& ring : polygon) points += ring.size();
    return points > maxOutlinePoints;
}

// Without pieces if it cannot be used.
PlacedFeature place(UnplacedFeature& feature, const Frame& frame, double farAwayM, Warnings& warnings) {
    if (isTooLarge(feature)) {
        warnings.push_back({WarningKind::dropped, fmt::format("has more than {} points", maxOutlinePoints),
                            feature.facts.id});
        return {};
    }
    if (isNear(feature, frame.origin(), farAwayM)) {
        auto pieces = repair(feature, frame, warnings);
        feature.polygons = {};  // here, on all threads: freeing them together takes as long as reading them
        return {std::move(feature.facts), std::move(pieces)};
    }
    warnings.push_back({WarningKind::leftOut,
                        fmt::format("lies more than {:g} km from the middle of the city", farAwayM / 1000),
                        feature.facts.id});
    return {};
}

}  // namespace

void FeatureCentres::add(const UnplacedFeature& feature) {
    if (lons_.empty()) nearLonDeg_ = feature.polygons.front().front().front().lonDeg;
    const LonLat centre = centreOf(feature, nearLonDeg_);
    lons_.push_back(centre.lonDeg);
    lats_.push_back(centre.latDeg);
    if (const auto ground = feature.facts.heights.groundElevationM) elevations_.push_back(*ground);
}

LonLat FeatureCentres::middle(double farAwayM) const {
    const LonLat all{medianOf(lons_), medianOf(lats_)};
    std::size_t near = 0;
    for (std::size_t i = 0; i < lons_.size(); ++i)
        near += isWithin({lons_[i], lats_[i]}, all, farAwayM) ? 1 : 0;
    if (2 * near >= lons_.size()) return all;
    const std::vector<std::size_t> maximum = findFullestPlace(lons_, lats_, farAwayM);
    std::vector<double> lons, lats;
    for (const std::size_t i : maximum) lons.push_back(lons_[i]), lats.push_back(lats_[i]);
    return {medianOf(lons), medianOf(lats)};
}

Frame FeatureCentres::frame(double farAwayM) const {
    const LonLat place = middle(farAwayM);
    return Frame({std::remainder(place.lonDeg, 360.0), place.latDeg},
                 elevations_.empty() ? 0 : medianOf(elevations_));
}

Frame frameOf(const std::vector<UnplacedFeature>& features, double farAwayM) {
    FeatureCentres centres;
    for (const UnplacedFeature& feature : features) centres.add(feature);
    return centres.frame(farAwayM);
}

std::vector<PlacedFeature> placeFeatures(std::vector<UnplacedFeature> features, const Frame& frame,
                                         double farAwayM, Warnings& warnings, const std::stop_token& stop) {
    std::vector<PlacedFeature> placed(features.size());
    std::vector<Warnings> remarks(features.size());
    tbb::parallel_for(std::size_t{0}, features.size(), [&](std::size_t i) {
        const StopScope scope(stop);
        if (!stop.stop_requested()) placed[i] = place(features[i], frame, farAwayM, remarks[i]);
    });
    for (Warnings& some : remarks) std::ranges::move(some, std::back_inserter(warnings));
    std::erase_if(placed, [](const PlacedFeature& feature) { return feature.pieces.empty(); });
    return placed;
}

}  // namespace noonmark
