#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/engines/points/hidden_altitudes.h"
#include "core/engines/points/sun_bins.h"

namespace noonmark {

/// What one point sees of the sky, by bins of azimuth.
struct BinHorizon {
    std::array<float, SunBins::count> tan{};  ///< up to this tangent suns are hidden; infinite: all are
    /// What overhangs hide above that, of bin k: gaps[firstGap[k]] to gaps[firstGap[k + 1]], disjoint.
    std::array<std::uint32_t, SunBins::count + 1> firstGap{};
    std::vector<HiddenAltitudes> gaps;

    [[nodiscard]] bool hides(BinnedSun sun) const;
};

/// Longest unbroken times of one point on any day, in steps.
struct PointRuns {
    std::uint32_t shadow = 0, sun = 0;
};

/// The suns of a period in time order, to count the unbroken times of many points. Steps are taken 32 at a
/// time: where all are above or below the horizons of their azimuths, no single step is looked at.
class SunTrack {
public:
    /// O(steps), 10 bytes a step.
    explicit SunTrack(const SunSteps& sun);

    [[nodiscard]] PointRuns countRuns(const BinHorizon& horizon) const;
    /// 1 in shadow, 0 lit; one entry a step. Some 2 ns a step.
    void findShadedSteps(const BinHorizon& horizon, std::vector<std::uint8_t>& shaded) const;

private:
    static constexpr int binsOfGroup = 8;
    static constexpr int groupCount = SunBins::count / binsOfGroup;
    /// Consecutive steps of one day.
    struct Packet {
        std::uint32_t first = 0;
        std::uint32_t starts = 0;                  // bit k: step k begins a new run
        std::uint32_t firstGroup = 0, groups = 0;  // groups of bins that the steps lie in, in groups_
        int count = 0;
        float lowestTan = 0, highestTan = 0;
    };
    /// Of the bins of each group: all suns up to `low` are hidden, and none above `high`.
    struct GroupBounds {
        std::array<float, groupCount> low{}, high{};
    };
    static GroupBounds boundsOf(const BinHorizon& horizon);
    void addDay(const SunSteps& sun, const SunDay& day);
    void addPacket(Packet packet);
    [[nodiscard]] std::uint32_t shadedSteps(const Packet& packet, const BinHorizon& horizon,
                                            const GroupBounds& bounds) const;

    std::vector<BinnedSun> suns_;
    std::vector<Packet> packets_;
    std::vector<std::uint8_t> groups_;
};

}  // namespace noonmark
