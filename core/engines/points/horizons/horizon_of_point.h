#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "core/city/city.h"
#include "core/engines/common/open_below.h"
#include "core/engines/points/horizons/bin_horizon.h"
#include "core/engines/points/horizons/obstacle_blocks.h"
#include "core/engines/points/horizons/sun_track.h"

namespace noonmark {

/// Sunlit steps by month: the suns above the horizon of their bin that no gap hides. Gaps must lie above the
/// horizon. Some 5 us for a year of minutes.
SunBins::Months countSunlit(const SunBins& suns, const BinHorizon& horizon);

/// Altitudes that an overhang hides at the middle of one bin, as tangents.
struct BinGap {
    int bin;
    float lowTan, highTan;  ///< 0 <= low; high may be infinite: up to the zenith
};

/// Appends what the faces of overhangs hide above a point's horizon (`eye`, local metres), in no order. Faces
/// that share an edge leave nothing between them: where the edge is cut, both get the same number.
void findFaceGaps(const FaceTree& faces, const BinDirections& bins, glm::vec3 eye, const BinTangents& horizon,
                  std::vector<BinGap>& gaps);

/// Raises a point's horizon (`eye`, local metres) by every edge that rises above it, from near to far: what
/// lies behind higher obstacles is left out by its box. Boxes and edges are chosen by azimuths that are a
/// 500th of a bin uncertain, with more to spare; whether an edge covers a bin's middle is decided in double
/// precision, so that edges which share a corner leave no bin between them.
void raiseHorizon(const EdgeTree& edges, const BinDirections& bins, glm::vec3 eye, BinTangents& horizon);

/// The same, and raises bounds: `touch` by what an edge reaches anywhere in a bin, `cover` by what one edge
/// hides at every azimuth of a bin. Of farther edges, `cover` misses those that lie behind the horizon.
void raiseHorizonAndBounds(const EdgeTree& edges, const BinDirections& bins, glm::vec3 eye,
                           BinTangents& horizon, BinTangents& touch, BinTangents& cover);

/// What the horizons of all points of a city share. O(n log n) in edges and steps to make.
struct HorizonScene {
    EdgeTree edges;
    FaceTree faces;
    SunBins suns;
    BinDirections bins;
    std::optional<SunTrack> track;  ///< where steps are asked for one by one

    HorizonScene(const City& city, const SunSteps& sun, bool withTrack);

private:
    HorizonScene(const SkyObstacles& obstacles, const SunSteps& sun, bool withTrack);
};

/// The horizon of one point after the other, at the middle of each bin. The scene must outlive it; one object
/// for each thread.
class HorizonOfPoint {
public:
    explicit HorizonOfPoint(const HorizonScene& scene);

    /// Finds the horizon of a point on a surface.
    void sweep(glm::vec3 position, glm::vec3 normal);
    /// The same with its bounds(), which costs about a half more. `open`: what parts with open air below
    /// hide, no bound counts as covered, unless something hides it that stands higher. Below such a part
    /// nothing is known to be lit.
    void sweepWithBounds(glm::vec3 position, glm::vec3 normal, std::span<const OpenBelow> open);

    // Of the point that was swept last; the last two need the scene's track.
    [[nodiscard]] SunBins::Months countSunlit() const {  ///< sunlit steps by month
        return noonmark::countSunlit(scene_.suns, horizon_);
    }
    [[nodiscard]] PointRuns countRuns() const { return scene_.track->countRuns(horizon_); }
    [[nodiscard]] const BinHorizon& horizon() const { return horizon_; }
    [[nodiscard]] HorizonBounds& bounds() { return bounds_; }
    /// 1 in shadow, 0 lit; one entry a step.
    void findShadedSteps(std::vector<std::uint8_t>& shaded) const {
        scene_.track->findShadedSteps(horizon_, shaded);
    }

private:
    void faceTowards(glm::vec3 normal);
    void boundFacing(glm::vec3 normal);
    void uncover(const OpenBelow& open, glm::vec3 eye);
    void touchGaps();
    void coverGaps();
    void coverGapsOf(std::size_t bin);
    void coverBy(std::size_t bin, const HiddenAltitudes& gap);
    [[nodiscard]] std::span<const HiddenAltitudes> joinedOf(std::size_t bin) const {
        return std::span(joined_).subspan(firstJoined_[bin], firstJoined_[bin + 1] - firstJoined_[bin]);
    }
    void joinGaps();
    void sortGaps();
    void joinGapsOf(std::size_t bin);

    const HorizonScene& scene_;
    BinHorizon horizon_;
    HorizonBounds bounds_;
    std::vector<BinGap> gaps_;
    // Sorted by bin: those of bin k are sorted_[firstOf_[k]] to sorted_[firstOf_[k + 1]].
    std::vector<HiddenAltitudes> sorted_;
    std::vector<std::uint32_t> firstOf_;
    // The same, joined where they overlap.
    std::vector<HiddenAltitudes> joined_;
    std::vector<std::uint32_t> firstJoined_;
    std::vector<HiddenAltitudes> ofBin_;
};

}  // namespace noonmark
