#include "core/engines/points/sun_track.h"

#include <algorithm>
#include <limits>

#include "core/engines/common/run_counter.h"

namespace noonmark {

namespace {

constexpr int packetSteps = 32;
constexpr std::uint32_t firstBits(int count) { return std::uint32_t((1ULL << unsigned(count)) - 1); }

}  // namespace

bool BinHorizon::hides(BinnedSun sun) const {
    if (sun.tan <= tan[sun.bin]) return true;
    for (std::uint32_t i = firstGap[sun.bin]; i < firstGap[sun.bin + 1U]; ++i)
        if (sun.tan >= float(gaps[i].lowTan) && sun.tan <= float(gaps[i].highTan)) return true;
    return false;
}

SunTrack::SunTrack(const SunSteps& sun) {
    suns_.reserve(sun.steps.size());
    for (const SunStep& step : sun.steps) suns_.push_back(binSun(step));
    for (const SunDay& day : sun.days) addDay(sun, day);
}

void SunTrack::addDay(const SunSteps& sun, const SunDay& day) {
    const std::uint32_t end = day.first + day.count;
    for (std::uint32_t first = day.first; first < end; first += packetSteps) {
        Packet packet{.first = first, .count = int(std::min<std::uint32_t>(packetSteps, end - first))};
        for (int k = 0; k < packet.count; ++k) {
            const std::uint32_t step = first + std::uint32_t(k);
            if (step == day.first || sun.steps[step].slot != sun.steps[step - 1].slot + 1)
                packet.starts |= 1U << unsigned(k);
        }
        addPacket(packet);
    }
}

void SunTrack::addPacket(Packet packet) {
    packet.firstGroup = std::uint32_t(groups_.size());
    packet.lowestTan = std::numeric_limits<float>::infinity();
    packet.highestTan = -packet.lowestTan;
    for (std::uint32_t i = packet.first; i < packet.first + std::uint32_t(packet.count); ++i) {
        packet.lowestTan = std::min(packet.lowestTan, suns_[i].tan);
        packet.highestTan = std::max(packet.highestTan, suns_[i].tan);
        const auto group = std::uint8_t(suns_[i].bin / binsOfGroup);
        if (std::find(groups_.begin() + packet.firstGroup, groups_.end(), group) == groups_.end())
            groups_.push_back(group);
    }
    packet.groups = std::uint32_t(groups_.size()) - packet.firstGroup;
    packets_.push_back(packet);
}

SunTrack::GroupBounds SunTrack::boundsOf(const BinHorizon& horizon) {
    GroupBounds bounds;
    for (std::size_t group = 0; group < groupCount; ++group) {
        const auto first = horizon.tan.begin() + std::ptrdiff_t(group * binsOfGroup);
        const auto [low, high] = std::minmax_element(first, first + binsOfGroup);
        const bool gaps =
            horizon.firstGap[group * binsOfGroup] != horizon.firstGap[(group + 1) * binsOfGroup];
        bounds.low[group] = *low;
        bounds.high[group] = gaps ? std::numeric_limits<float>::infinity() : *high;
    }
    return bounds;
}

std::uint32_t SunTrack::shadedSteps(const Packet& packet, const BinHorizon& horizon,
                                    const GroupBounds& bounds) const {
    bool allShaded = true, allLit = true;
    for (std::uint32_t i = packet.firstGroup; i < packet.firstGroup + packet.groups; ++i) {
        allShaded = allShaded && packet.highestTan <= bounds.low[groups_[i]];
        allLit = allLit && packet.lowestTan > bounds.high[groups_[i]];
    }
    if (allShaded) return firstBits(packet.count);
    if (allLit) return 0;
    std::uint32_t shaded = 0;
    for (int k = 0; k < packet.count; ++k)
        if (horizon.hides(suns_[packet.first + std::uint32_t(k)])) shaded |= 1U << unsigned(k);
    return shaded;
}

PointRuns SunTrack::countRuns(const BinHorizon& horizon) const {
    const GroupBounds bounds = boundsOf(horizon);
    RunCounter shadow, sun;
    for (const Packet& packet : packets_) {
        const std::uint32_t shaded = shadedSteps(packet, horizon, bounds);
        shadow.add(shaded, packet.starts, packet.count);
        sun.add(~shaded & firstBits(packet.count), packet.starts, packet.count);
    }
    return {shadow.longest(), sun.longest()};
}

void SunTrack::findShadedSteps(const BinHorizon& horizon, std::vector<std::uint8_t>& shaded) const {
    shaded.resize(suns_.size());
    const GroupBounds bounds = boundsOf(horizon);
    for (const Packet& packet : packets_) {
        const std::uint32_t bits = shadedSteps(packet, horizon, bounds);
        for (int k = 0; k < packet.count; ++k)
            shaded[packet.first + std::uint32_t(k)] = std::uint8_t(bits >> unsigned(k) & 1U);
    }
}

}  // namespace noonmark
