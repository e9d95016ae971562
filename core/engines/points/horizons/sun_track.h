#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/engines/points/horizons/bin_horizon.h"

namespace noonmark {

/// Windows of neighbouring bins: 8, 16, ... 256 of them from every eighth bin on, and all. Index: first the
/// windows of 8 bins by their first bin, then those of 16, and so on; the last is of all bins.
struct BinRanges {
    static constexpr int step = 8, starts = SunBins::count / step, sizes = 6;
    static constexpr int all = starts * sizes, count = all + 1;

    /// The smallest window that holds `bins` of them from `first` on, which may lie beyond north.
    static int around(int first, int bins);
};

/// Bounds of a horizon in windows of bins: suns up to `low` are hidden, those above `high` are not.
struct RangeBounds {
    std::array<float, BinRanges::count> low, high;

    /// Some 2 us.
    explicit RangeBounds(const BinHorizon& horizon);
};

/// Suns in time order, in packets of up to 32 whose bins lie in one window; arrays for kernels.
struct SunPackets {
    static constexpr std::size_t size = 32;
    // One entry a step, and `size` more, which kernels may read.
    std::vector<std::uint16_t> bin;
    std::vector<float> tan;
    // One entry a packet, and up to 15 more.
    std::vector<std::int32_t> window;  ///< of BinRanges
    std::vector<float> lowestTan, highestTan;
};

/// One bit a packet, in words of 64: all of its suns are hidden, or none is. Where both bits are 0, some are,
/// or the bounds leave it open.
struct PacketBits {
    std::vector<std::uint64_t> hidden, lit;
};
void classifyPackets(const SunPackets& packets, const RangeBounds& bounds, PacketBits& bits);

/// Bit k: sun `first` + k is at or below the tangent of its bin. 32 suns.
std::uint32_t sunsUpTo(const SunPackets& packets, std::size_t first, const BinTangents& tangents);

/// Longest unbroken times of one point on any day, in steps.
struct PointRuns {
    std::uint32_t shadow = 0, sun = 0;
    bool operator==(const PointRuns&) const = default;
};

/// Steps [first, end) of the period, all of one day and without a gap.
struct TrackRun {
    std::uint32_t first = 0, end = 0;
    [[nodiscard]] std::uint32_t length() const { return end - first; }
};

/// The suns of a period in time order, to find the times of many points in shadow and sun. Steps are taken 32
/// at a time: where all are above or below the horizons of their azimuths, no single step is looked at. For
/// unbroken times, neither are days that cannot have a longer one than another day.
class SunTrack {
public:
    /// O(steps), 8 bytes a step.
    explicit SunTrack(const SunSteps& sun);

    [[nodiscard]] PointRuns countRuns(const BinHorizon& horizon) const;
    /// The longest runs in shadow and of sun.
    struct Longest {
        TrackRun shadow, sun;
    };
    [[nodiscard]] Longest findLongest(const BinHorizon& horizon) const;
    /// All runs of more than `steps`, the longest first.
    [[nodiscard]] std::vector<TrackRun> findRuns(const BinHorizon& horizon, bool ofShadow,
                                                 std::uint32_t steps) const;
    [[nodiscard]] bool hides(const BinHorizon& horizon, std::uint32_t step) const {
        return horizon.hides({suns_.bin[step], suns_.tan[step]});
    }
    [[nodiscard]] std::uint16_t binOf(std::uint32_t step) const { return suns_.bin[step]; }
    /// 1 in shadow, 0 lit; one entry a step.
    void findShadedSteps(const BinHorizon& horizon, std::vector<std::uint8_t>& shaded) const;

private:
    /// Consecutive steps of one day.
    struct Packet {
        std::uint32_t first = 0;
        std::uint32_t starts = 0;  // bit k: step k begins a new run
        int count = 0;
    };
    /// Packets of one day; one more follows (addNight()).
    struct Day {
        std::uint32_t first = 0, end = 0, steps = 0;
    };
    /// Packets in a row that may hold a run.
    struct Stretch {
        std::uint32_t first = 0, end = 0, maxSteps = 0;
    };
    struct Point;    // what the horizon of a point hides
    class LongRuns;  // visits the runs of a stretch

    void addDay(const SunSteps& sun, const SunDay& day);
    void addPacket(Packet packet);
    void addNight();
    [[nodiscard]] std::vector<Stretch> findStretches(const Point& point, bool ofShadow,
                                                     std::uint32_t minimum) const;
    [[nodiscard]] std::vector<Stretch> findLongestStretches(const Point& point, bool ofShadow) const;
    [[nodiscard]] TrackRun longestRun(Point& point, bool ofShadow) const;

    SunPackets suns_;
    std::vector<Packet> packets_;
    std::vector<Day> days_;
    std::vector<std::uint64_t> inDay_;  // bit k: packet k has steps
};

}  // namespace noonmark
