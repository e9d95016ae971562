#include "core/engines/points/horizons/sun_track.h"

#include <algorithm>
#include <bit>

namespace noonmark {

namespace {

// Rows of bits in words of 64: bit k is bit k % 64 of word k / 64.
using BitRows = std::vector<std::uint64_t>;

// Bit k stays set if the bit `further` on is set, too; whether any does. `further`: below 64.
bool keepBoth(BitRows& words, std::uint32_t further) {
    std::uint64_t any = 0;
    for (std::size_t word = 0; word < words.size(); ++word) {
        const std::uint64_t next = word + 1 < words.size() ? words[word + 1] : 0;
        words[word] &= words[word] >> further | (further > 0 ? next << (64 - further) : 0);
        any |= words[word];
    }
    return any != 0;
}

/// The bits that are not set in `others`, which has as many words.
BitRows without(BitRows words, const BitRows& others) {
    for (std::size_t word = 0; word < words.size(); ++word) words[word] &= ~others[word];
    return words;
}

/// The first bit from `bit` on that is set, or is not; the number of all bits if there is none.
std::uint32_t firstBit(const BitRows& words, std::uint32_t bit, bool set) {
    for (std::size_t word = bit / 64; word < words.size(); ++word) {
        std::uint64_t some = set ? words[word] : ~words[word];
        if (word == bit / 64) some &= ~0ULL << (bit % 64);
        if (some != 0) return std::uint32_t(word * 64 + std::size_t(std::countr_zero(some)));
    }
    return std::uint32_t(words.size() * 64);
}

/// Keeps the bits with which rows of at least `length` set bits begin, or go on for so many.
void keepBeginsOfRows(BitRows& words, std::uint32_t length) {
    for (std::uint32_t kept = 1; kept < length;) {
        const std::uint32_t further = std::min({kept, length - kept, 63U});
        if (!keepBoth(words, further)) return;
        kept += further;
    }
}

/// Length of the longest row of set bits.
std::uint32_t findLongestRow(BitRows words) {
    std::uint32_t length = std::ranges::any_of(words, [](std::uint64_t word) { return word != 0; }) ? 1 : 0;
    while (length > 0 && keepBoth(words, 1)) ++length;
    return length;
}

}  // namespace

int BinRanges::around(int first, int bins) {
    first %= SunBins::count;
    for (int size = 0; size < sizes; ++size)
        if (first % step + bins <= step << unsigned(size)) return size * starts + first / step;
    return all;
}

RangeBounds::RangeBounds(const BinHorizon& horizon) {
    constexpr int starts = BinRanges::starts;
    for (int start = 0; start < starts; ++start) {
        const auto first = std::size_t(start * BinRanges::step), at = std::size_t(start);
        low[at] = high[at] = horizon.tan[first];
        for (std::size_t bin = first; bin < first + BinRanges::step; ++bin) {
            low[at] = std::min(low[at], horizon.tan[bin]);
            high[at] = std::max(high[at], horizon.topTan(bin));
        }
    }
    for (int size = 1; size < BinRanges::sizes; ++size)  // of two windows of half the size
        for (int start = 0; start < starts; ++start) {
            const int halves = (size - 1) * starts;
            const auto a = std::size_t(halves + start);
            const auto b = std::size_t(halves + (start + (1 << unsigned(size - 1))) % starts);
            const auto at = std::size_t(size * starts + start);
            low[at] = std::min(low[a], low[b]);
            high[at] = std::max(high[a], high[b]);
        }
    low[BinRanges::all] = *std::min_element(low.begin(), low.begin() + starts);
    high[BinRanges::all] = *std::max_element(high.begin(), high.begin() + starts);
}

namespace {

constexpr auto packetSteps = std::uint32_t(SunPackets::size);
constexpr std::uint32_t firstBits(int count) { return std::uint32_t((1ULL << unsigned(count)) - 1); }

bool bitOf(const std::vector<std::uint64_t>& words, std::size_t bit) {
    return (words[bit / 64] >> (bit % 64) & 1U) != 0;
}

// The shortest arc of bins that begins or ends near the first and holds all.
int rangeAround(const std::uint16_t* bins, int count) {
    int low = 0, high = 0;
    for (int k = 1; k < count; ++k) {
        int further = bins[k] - bins[0];
        if (further > SunBins::count / 2) further -= SunBins::count;
        if (further < -SunBins::count / 2) further += SunBins::count;
        low = std::min(low, further), high = std::max(high, further);
    }
    return BinRanges::around(bins[0] + low + SunBins::count, high - low + 1);
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
    inDay_.resize((packets_.size() + 63) / 64);
    for (std::size_t i = 0; i < packets_.size(); ++i)
        if (packets_[i].count > 0) inDay_[i / 64] |= 1ULL << (i % 64);
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
    addNight();
}

// A packet without steps, so that packets in a row are of one day.
void SunTrack::addNight() {
    suns_.lowestTan.push_back(0);
    suns_.highestTan.push_back(0);
    suns_.window.push_back(0);
    packets_.push_back({});
}

void SunTrack::addPacket(Packet packet) {
    const auto [lowest, highest] = std::minmax_element(suns_.tan.begin() + packet.first,
                                                       suns_.tan.begin() + packet.first + packet.count);
    suns_.lowestTan.push_back(*lowest);
    suns_.highestTan.push_back(*highest);
    suns_.window.push_back(rangeAround(&suns_.bin[packet.first], packet.count));
    packets_.push_back(packet);
}

struct SunTrack::Point {
    const SunTrack& track;
    const BinHorizon& horizon;
    PacketBits bits;
    std::vector<std::uint64_t> mayBeHidden, mayBeLit;
    BinTangents tops{};  // BinHorizon::topTan; only if there are gaps
    // Of packets that were looked at step by step, and which those are.
    std::vector<std::uint32_t> steps;
    std::vector<bool> known;

    Point(const SunTrack& of, const BinHorizon& its) : track(of), horizon(its) {
        const std::size_t words = (of.packets_.size() + 63) / 64;
        bits.hidden.resize(words), bits.lit.resize(words);
        steps.resize(of.packets_.size()), known.resize(of.packets_.size());
        classifyPackets(of.suns_, RangeBounds(its), bits);
        mayBeHidden = without(of.inDay_, bits.lit);
        mayBeLit = without(of.inDay_, bits.hidden);
        for (std::size_t bin = 0; bin < SunBins::count && !its.gaps.empty(); ++bin)
            tops[bin] = its.topTan(bin);
    }

    /// Bit k: packet k may have steps in shadow, or lit ones.
    [[nodiscard]] const std::vector<std::uint64_t>& packetsOf(bool shadow) const {
        return shadow ? mayBeHidden : mayBeLit;
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

// Only those that may have a run of more than `minimum` steps: none is longer than the packets in a row that
// may have steps of one.
std::vector<SunTrack::Stretch> SunTrack::findStretches(const Point& point, bool ofShadow,
                                                       std::uint32_t minimum) const {
    std::vector<std::uint64_t> begins = point.packetsOf(ofShadow);
    keepBeginsOfRows(begins, minimum / packetSteps + 1);
    std::vector<Stretch> stretches;
    auto day = days_.begin();
    for (std::uint32_t first = firstBit(begins, 0, true); first < packets_.size();) {
        while (day->end <= first) ++day;
        const std::uint32_t end = firstBit(point.packetsOf(ofShadow), first, false),
                            maximum = std::min((end - first) * packetSteps, day->steps);
        if (maximum > minimum) stretches.push_back({first, end, maximum});
        first = firstBit(begins, end, true);
    }
    return stretches;
}

// Those with the most packets.
std::vector<SunTrack::Stretch> SunTrack::findLongestStretches(const Point& point, bool ofShadow) const {
    const std::uint32_t packets = findLongestRow(point.packetsOf(ofShadow));
    return packets == 0 ? std::vector<Stretch>() : findStretches(point, ofShadow, packets * packetSteps - 1);
}

/// Visits the runs of a stretch that have more than some number of steps, in time order. Such a run fills all
/// packets but its first and last, so most packets need not be looked at: the ones that it would fill are
/// tried from the last on, and where one has a step outside, the run begins there or later.
class SunTrack::LongRuns {
public:
    LongRuns(Point& point, bool ofShadow, const Stretch& stretch)
        : point_(point),
          packets_(point.track.packets_),
          ofShadow_(ofShadow),
          at_(stretch.first),
          end_(stretch.end) {}

    /// `visit(run)` returns the number of steps that runs must exceed from then on.
    template <class Visit>
    void visitLongerThan(std::uint32_t minimum, const Visit& visit) {
        while (at_ < end_) {
            const std::uint32_t filled = minimum < packetSteps ? 0 : (minimum + 1) / packetSteps - 1;
            if (at_ + filled >= end_) return;
            if (skipTo(at_ + filled)) continue;
            const TrackRun run = next();
            if (run.length() > minimum) minimum = visit(run);
        }
    }

private:
    [[nodiscard]] std::uint32_t wantedSteps(std::uint32_t packet) const {
        const std::uint32_t shaded = point_.shadedSteps(packet);
        return ofShadow_ ? shaded : ~shaded & firstBits(packets_[packet].count);
    }
    [[nodiscard]] bool isFilled(std::uint32_t packet) const {
        return packets_[packet].starts == 0 && wantedSteps(packet) == firstBits(packets_[packet].count);
    }
    // Number of steps from bit `from` on that are wanted and belong to one run.
    [[nodiscard]] std::uint32_t countOn(std::uint32_t packet, std::uint32_t from) const {
        const std::uint32_t ends =
            ~wantedSteps(packet) | (packets_[packet].starts & ~firstBits(int(from) + 1));
        return std::uint32_t(std::countr_zero(std::uint64_t(ends) >> from | 1ULL << (packetSteps - from)));
    }
    void moveTo(std::uint32_t packet, std::uint32_t bit) { at_ = packet, bit_ = bit; }

    // Goes to the last packet up to this one that no run fills; false if there is none.
    bool skipTo(std::uint32_t packet) {
        for (; packet > at_; --packet)
            if (!isFilled(packet)) {
                moveTo(packet, 0);
                return true;
            }
        return false;
    }

    // The next run; empty if the rest of the packet has none.
    [[nodiscard]] TrackRun next() {
        const std::uint32_t wanted = wantedSteps(at_) & ~firstBits(int(bit_));
        if (wanted == 0) return moveTo(at_ + 1, 0), TrackRun{};
        const auto from = std::uint32_t(std::countr_zero(wanted)), to = from + countOn(at_, from);
        const std::uint32_t first = packets_[at_].first + from;
        if (to < std::uint32_t(packets_[at_].count)) {
            bit_ = to;
            return {first, packets_[at_].first + to};
        }
        return {first, endOfRunAfter(at_)};
    }

    // The end of a run that reaches the end of a packet.
    [[nodiscard]] std::uint32_t endOfRunAfter(std::uint32_t packet) {
        std::uint32_t last = packet + 1;
        while (last < end_ && isFilled(last)) ++last;
        const bool goesOn = last < end_ && (packets_[last].starts & 1U) == 0;
        const std::uint32_t more = goesOn ? countOn(last, 0) : 0;
        moveTo(last, more);
        const Packet& before = packets_[last - 1];
        return before.first + std::uint32_t(before.count) + more;
    }

    Point& point_;
    const std::vector<Packet>& packets_;
    bool ofShadow_;
    std::uint32_t at_, end_, bit_ = 0;
};

// First where it probably is, so that little else need be looked at.
TrackRun SunTrack::longestRun(Point& point, bool ofShadow) const {
    TrackRun found;
    const auto walk = [&](const std::vector<Stretch>& stretches) {
        for (const Stretch& stretch : stretches) {
            if (stretch.maxSteps <= found.length()) continue;
            LongRuns(point, ofShadow, stretch).visitLongerThan(found.length(), [&](const TrackRun& run) {
                found = run;
                return run.length();
            });
        }
    };
    walk(findLongestStretches(point, ofShadow));
    walk(findStretches(point, ofShadow, found.length()));
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
    for (const Stretch& stretch : findStretches(point, ofShadow, steps))
        LongRuns(point, ofShadow, stretch).visitLongerThan(steps, [&](const TrackRun& run) {
            runs.push_back(run);
            return steps;
        });
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
