#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "core/engines/points/hidden_altitudes.h"
#include "core/engines/points/obstacle_tree.h"
#include "core/engines/points/seen_edge.h"
#include "core/engines/points/sun_bins.h"
#include "core/engines/points/sun_track.h"

namespace noonmark {

/// What the horizons of all points of a city share. O(n log n) in edges and steps to make.
struct HorizonScene {
    SkyObstacles obstacles;
    ObstacleTree edges, faces;
    SunBins suns;
    std::optional<SunTrack> track;                       ///< where steps are asked for one by one
    std::array<float, SunBins::count> sine{}, cosine{};  ///< of the bins' middles

    HorizonScene(const City& city, const SunSteps& sun, bool withTrack);
};

/// The horizon of one point after the other, at the middle of each bin. The scene must outlive it; one object
/// for each thread.
class HorizonOfPoint {
public:
    explicit HorizonOfPoint(const HorizonScene& scene) : scene_(scene) {}

    /// Finds the horizon of a point on a surface.
    void sweep(glm::vec3 position, glm::vec3 normal);

    // Of the point that was swept last; the last two need the scene's track.
    [[nodiscard]] SunBins::Months countSunlit() const;  ///< sunlit steps by month
    [[nodiscard]] PointRuns countRuns() const { return scene_.track->countRuns(horizon_); }
    /// 1 in shadow, 0 lit; one entry a step.
    void findShadedSteps(std::vector<std::uint8_t>& shaded) const {
        scene_.track->findShadedSteps(horizon_, shaded);
    }

private:
    /// Altitudes that an overhang hides in one bin.
    struct BinGap {
        int bin;
        HiddenAltitudes hidden;
    };
    /// Bins from first to last; those from SunBins::count on are beyond north.
    struct Bins {
        int first, last;
    };
    void faceTowards(glm::vec3 normal);
    void setHorizon(int bin, float tan);
    [[nodiscard]] bool anyBelow(Bins bins, float tan) const;
    [[nodiscard]] bool risesAbove(const ObstacleBox& box) const;
    static Bins binsBetween(double from, double to);
    void raise(const TopEdge& edge);
    void addGaps(const OverhangFace& face);
    void addGap(const OverhangFace& face, int bin);
    void joinGaps();
    void subtractGap(int bin, const HiddenAltitudes& hidden, SunBins::Months& months) const;

    const HorizonScene& scene_;
    glm::vec3 eye_{};
    BinHorizon horizon_;
    std::vector<BinGap> gaps_;
    std::vector<HiddenAltitudes> joined_;
};

}  // namespace noonmark
