#include "core/engines/points/horizons/sun_track.h"

#include <algorithm>
#include <limits>

#include "core/engines/common/run_counter.h"

namespace noonmark {

namespace {

constexpr auto packetSteps = std::uint32_t(SunPackets::size);
constexpr std::uint32_t firstBits(int count) { return std::uint32_t((1ULL << unsigned(count)) - 1); }

bool bitOf(const std::vector<std::uint64_t>& words, std::size_t bit) {
    return (words[bit / 64] >> (bit % 64) & 1U) != 0;
}

// The shortest arc of bins that begins or ends near the first and holds all.
int windowAround(const std::uint16_t* bins, int count) {
    int low = 0, high = 0;
    for (int k = 1; k < count; ++k) {
        int further = bins[k] - bins[0];
        if (further > SunBins::count / 2) further -= SunBins::count;
        if (further < -SunBins::count / 2) further += SunBins::count;
        low = std::min(low, further), high = std::max(high, further);
    }
    return BinWindows::around(bins[0] + low + SunBins::count, high - low + 1);
}

}  // namespace

SunTrack::SunTrack(const SunSteps& sun) {
    suns_.bin.reserve(sun.steps.size() + packetSteps);
    suns_.tan.reserve(sun.steps.size() + packetSteps);
    for (const SunStep& step : sun.steps) {
        const SunInBin binned = binSun(step);
        suns_.bin.push_back(binned.bin);
        suns_.tan.push_back(binned.tan);
    }
    for (const SunDay& day : sun.days) addDay(sun, day);
    suns_.bin.resize(suns_.bin.size() + packetSteps);
    suns_.tan.resize(suns_.tan.size() + packetSteps);
    const std::size_t whole = (packets_.size() + 15) / 16 * 16;
    suns_.window.resize(whole), suns_.lowestTan.resize(whole), suns_.highestTan.resize(whole);
}

void SunTrack::addDay(const SunSteps& sun, const SunDay& day) {
    const std::uint32_t end = day.first + day.count;
    const auto firstPacket = std::uint32_t(packets_.size());
    for (std::uint32_t first = day.first; first < end; first += packetSteps) {
        Packet packet{.first = first, .count = int(std::min<std::uint32_t>(packetSteps, end - first))};
        for (int k = 0; k < packet.count; ++k) {
            const std::uint32_t step = first + std::uint32_t(k);
            if (step == day.first || sun.steps[step].slot != sun.steps[step - 1].slot + 1)
                packet.starts |= 1U << unsigned(k);
        }
        addPacket(packet);
    }
    days_.push_back({firstPacket, std::uint32_t(packets_.size()), day.count});
}

void SunTrack::addPacket(Packet packet) {
    const auto [lowest, highest] = std::minmax_element(suns_.tan.begin() + packet.first,
                                                       suns_.tan.begin() + packet.first + packet.count);
    suns_.lowestTan.push_back(*lowest);
    suns_.highestTan.push_back(*highest);
    suns_.window.push_back(windowAround(&suns_.bin[packet.first], packet.count));
    packets_.push_back(packet);
}

struct SunTrack::Point {
    const SunTrack& track;
    const BinHorizon& horizon;
    PacketBits bits;
    BinTangents tops{};  // BinHorizon::topTan; only if there are gaps
    // Of packets that were looked at step by step, and which those are.
    std::vector<std::uint32_t> steps;
    std::vector<bool> known;

    Point(const SunTrack& of, const BinHorizon& its) : track(of), horizon(its) {
        const std::size_t words = (of.packets_.size() + 63) / 64;
        bits.hidden.resize(words), bits.lit.resize(words);
        steps.resize(of.packets_.size()), known.resize(of.packets_.size());
        classifyPackets(of.suns_, WindowBounds(its), bits);
        for (std::size_t bin = 0; bin < SunBins::count && !its.gaps.empty(); ++bin)
            tops[bin] = its.topTan(bin);
    }

    std::uint32_t shadedSteps(std::size_t index) {
        if (bitOf(bits.lit, index)) return 0;
        if (bitOf(bits.hidden, index)) return firstBits(track.packets_[index].count);
        if (!known[index]) steps[index] = findShaded(track.packets_[index]), known[index] = true;
        return steps[index];
    }

    [[nodiscard]] std::uint32_t findShaded(const Packet& packet) const {
        const std::uint32_t all = firstBits(packet.count);
        const std::uint32_t hidden = sunsUpTo(track.suns_, packet.first, horizon.tan);
        return (horizon.gaps.empty() ? hidden : hidden | hiddenByGaps(packet.first, ~hidden & all)) & all;
    }

    // Of the steps from `first` on whose bits are set.
    [[nodiscard]] std::uint32_t hiddenByGaps(std::uint32_t first, std::uint32_t steps) const {
        std::uint32_t hidden = 0;
        for (std::uint32_t left = sunsUpTo(track.suns_, first, tops) & steps; left != 0; left &= left - 1) {
            const std::uint32_t step = first + std::uint32_t(std::countr_zero(left));
            if (horizon.hides({track.suns_.bin[step], track.suns_.tan[step]})) hidden |= left & -left;
        }
        return hidden;
    }
};

// No run is longer than the packets in a row that may have one.
void SunTrack::findStretches(const Day& day, const std::vector<std::uint64_t>& none,
                             std::vector<Stretch>& stretches) const {
    for (std::uint32_t i = day.first; i < day.end; ++i) {
        if (bitOf(none, i)) continue;
        const std::uint32_t first = i;
        while (i < day.end && !bitOf(none, i)) ++i;
        stretches.push_back({first, i, std::min((i - first) * packetSteps, day.steps)});
    }
}

std::vector<SunTrack::Stretch> SunTrack::findStretches(const Point& point, bool ofShadow) const {
    std::vector<Stretch> stretches;
    for (const Day& day : days_) findStretches(day, ofShadow ? point.bits.lit : point.bits.hidden, stretches);
    return stretches;
}

// A run does not go on from one stretch to another.
std::uint32_t SunTrack::longestIn(Point& point, bool ofShadow, const Stretch& stretch) const {
    LongestRun runs;
    for (std::uint32_t i = stretch.first; i < stretch.end; ++i) {
        const Packet& packet = packets_[i];
        const std::uint32_t shaded = point.shadedSteps(i), all = firstBits(packet.count);
        const std::uint32_t starts = i == stretch.first ? packet.starts | 1U : packet.starts;
        runs.add(ofShadow ? shaded : ~shaded & all, starts, packet.count);
    }
    return runs.longest();
}

// Calls visit(run) for each run of a stretch, in time order.
template <class Visit>
void SunTrack::forEachRun(Point& point, bool ofShadow, const Stretch& stretch, const Visit& visit) const {
    TrackRun run;
    const auto end = [&] {
        if (run.length() > 0) visit(run);
        run = {};
    };
    for (std::uint32_t i = stretch.first; i < stretch.end; ++i) {
        const Packet& packet = packets_[i];
        const std::uint32_t shaded = point.shadedSteps(i), wanted = ofShadow ? shaded : ~shaded;
        for (int k = 0; k < packet.count; ++k) {
            const std::uint32_t step = packet.first + std::uint32_t(k);
            if ((packet.starts >> unsigned(k) & 1U) != 0 || (wanted >> unsigned(k) & 1U) == 0) end();
            if ((wanted >> unsigned(k) & 1U) == 0) continue;
            if (run.length() == 0) run.first = step;
            run.end = step + 1;
        }
    }
    end();
}

// The stretch that may hold the longest run is walked first.
TrackRun SunTrack::longestRun(Point& point, bool ofShadow) const {
    std::vector<Stretch> stretches = findStretches(point, ofShadow);
    if (stretches.empty()) return {};
    std::iter_swap(stretches.begin(), std::ranges::max_element(stretches, {}, &Stretch::mostSteps));
    const Stretch* holder = nullptr;
    std::uint32_t longest = 0;
    for (const Stretch& stretch : stretches) {
        if (stretch.mostSteps <= longest) continue;
        const std::uint32_t steps = longestIn(point, ofShadow, stretch);
        if (steps > longest) longest = steps, holder = &stretch;
    }
    TrackRun found;
    if (holder != nullptr)
        forEachRun(point, ofShadow, *holder, [&](const TrackRun& run) {
            if (run.length() > found.length()) found = run;
        });
    return found;
}

SunTrack::Longest SunTrack::findLongest(const BinHorizon& horizon) const {
    Point point(*this, horizon);
    const TrackRun shadow = longestRun(point, true);
    return {shadow, longestRun(point, false)};
}

std::vector<TrackRun> SunTrack::findRuns(const BinHorizon& horizon, bool ofShadow,
                                         std::uint32_t steps) const {
    Point point(*this, horizon);
    std::vector<TrackRun> runs;
    for (const Stretch& stretch : findStretches(point, ofShadow)) {
        if (stretch.mostSteps <= steps || longestIn(point, ofShadow, stretch) <= steps) continue;
        forEachRun(point, ofShadow, stretch, [&](const TrackRun& run) {
            if (run.length() > steps) runs.push_back(run);
        });
    }
    std::ranges::stable_sort(runs, std::ranges::greater{}, &TrackRun::length);
    return runs;
}

PointRuns SunTrack::countRuns(const BinHorizon& horizon) const {
    const Longest longest = findLongest(horizon);
    return {longest.shadow.length(), longest.sun.length()};
}

void SunTrack::findShadedSteps(const BinHorizon& horizon, std::vector<std::uint8_t>& shaded) const {
    Point point(*this, horizon);
    shaded.resize(suns_.bin.size() - packetSteps);
    for (std::size_t i = 0; i < packets_.size(); ++i) {
        const Packet& packet = packets_[i];
        const std::uint32_t bits = point.shadedSteps(i);
        for (int k = 0; k < packet.count; ++k)
            shaded[packet.first + std::uint32_t(k)] = std::uint8_t(bits >> unsigned(k) & 1U);
    }
}

}  // namespace noonmark
