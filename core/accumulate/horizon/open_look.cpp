#include "core/accumulate/horizon/open_look.h"

#include "core/accumulate/horizon/lanes16.h"

namespace noonmark {

namespace {

constexpr float onWhatHangs = 1e-3F;  // cells; nearer than that a receiver is on it
constexpr HorizonCode zenith = HorizonCode(steepnessLevels - 1 + int(noHorizon));

int ceilOf(float value) {
    const int whole =
        int(std::clamp(value, -float(2 * ReceiverBlocks::side), float(2 * ReceiverBlocks::side)));
    return whole + int(float(whole) < value);
}

[[gnu::always_inline]] inline HorizonCode codeOfRise(float rise, float distance) {
    const float steepness = rise > 0 ? rise / (rise + distance) : 0;
    const int level = int(steepness * float(steepnessLevels));
    return rise > 0 ? HorizonCode(std::min(level, steepnessLevels - 1) + int(noHorizon)) : noHorizon;
}

/// What is seen from some cells: what hides what.
struct Intervals {
    const float *toNear, *toFar, *nearRise, *farRise;
    HorizonCode *low, *high;
};

// Where the near side lies behind a cell, it is below what hangs or above it: what is over it hides all up to
// the zenith.
NOONMARK_EVERY_ISA
void findIntervals(const Intervals& of, bool solid, int count) {
    const Intervals seen = of;
    for (int i = 0; i < count; ++i) {
        const float toNear = seen.toNear[i], toFar = seen.toFar[i], near = seen.nearRise[i],
                    far = seen.farRise[i];
        const float over = solid ? far : near * toFar - far * toNear;
        const HorizonCode behind = over > 0 ? zenith : noHorizon;
        const HorizonCode ahead = codeOfRise(near, toNear > 0 ? toNear : 1);
        const HorizonCode atNear = toNear > 0 ? ahead : behind, atFar = codeOfRise(far, toFar);
        seen.low[i] = std::min(atNear, atFar);
        seen.high[i] = std::max(atNear, atFar);
    }
}

}  // namespace

void OpenLook::begin(const ShadowAxes& axes, double alongPerMetre, glm::ivec2 first, HorizonCode lowest) {
    axes_ = axes;
    alongPerMetre_ = float(alongPerMetre);
    shift_ = float(axes.k * axes.sign);
    first_ = axes.from(glm::dvec2(first));
    lowest_ = lowest;
    raised_.fill(0);
    apart_.clear();
}

void OpenLook::look(const OpenLayer& layer, std::span<const OpenStrip> strips, HorizonCode most) {
    findStrips(strips);
    if (strips_.empty()) return;
    seen_.count = 0;
    for (int line = 0; line < side; ++line) lookAlong(line, most);
    if (seen_.count == 0) return;
    findIntervals({seen_.toNear.data(), seen_.toFar.data(), seen_.nearRise.data(), seen_.farRise.data(),
                   seen_.low.data(), seen_.high.data()},
                  layer.solid, seen_.count);
    addSeen();
}

// In floats from the square's first cell on: strips that share a corner part the cells there between them.
void OpenLook::findStrips(std::span<const OpenStrip> strips) {
    const float all = shift_ * float(side - 1), lowest = std::min(0.0F, -all),
                highest = std::max(0.0F, -all) + float(side - 1);
    strips_.clear();
    for (const OpenStrip& strip : strips) {
        const auto low = float(strip.lowQ - first_.q), high = float(strip.highQ - first_.q);
        if (low > highest + 1 || high < lowest - 1) continue;
        strips_.push_back({low, high, sideFrom(strip.near), sideFrom(strip.far)});
    }
}

OpenLook::Side OpenLook::sideFrom(const OpenStrip::Side& of) const {
    return {float(first_.along - of.along), float(of.slope), float(of.rise), float(of.riseSlope)};
}

// The line's cells with lowQ <= q < highQ of a strip.
void OpenLook::lookAlong(int line, HorizonCode most) {
    const float shift = shift_ * float(line), along = float(axes_.sign) * float(line);
    const int end = std::min(side, ceilOf(strips_.back().high + shift));
    const Strip* strip = strips_.data();
    for (int place = std::max(0, ceilOf(strip->low + shift)); place < end; ++place) {
        while (strip->high + shift <= float(place)) ++strip;
        see(*strip, axes_.swapped ? place * side + line : line * side + place,
            float(place) - (strip->low + shift), along, most);
    }
}

// All cells are written down, and only those counted that count: which do nobody could guess.
void OpenLook::see(const Strip& strip, int cell, float width, float along, HorizonCode most) {
    const float ground = square_.groundsM == nullptr ? 0 : square_.groundsM[cell] * alongPerMetre_;
    const auto i = std::size_t(seen_.count);
    seen_.cell[i] = std::uint8_t(cell);
    seen_.toFar[i] = strip.far.distance + along - strip.far.slope * width;
    seen_.toNear[i] = strip.near.distance + along - strip.near.slope * width;
    seen_.nearRise[i] = strip.near.rise + strip.near.riseSlope * width - ground;
    seen_.farRise[i] = strip.far.rise + strip.far.riseSlope * width - ground;
    seen_.count +=
        int((width >= 0) & (square_.horizons.values[cell] <= most) & (seen_.toFar[i] > onWhatHangs));
}

void OpenLook::addSeen() {
    for (std::size_t i = 0; i < std::size_t(seen_.count); ++i) {
        const int cell = seen_.cell[i];
        if (seen_.high[i] <= std::max(lowest_, square_.horizons.values[cell])) continue;
        if (joins(cell, seen_.low[i]))
            raise(cell, seen_.low[i], seen_.high[i]);
        else
            apart_.push_back({cell, seen_.low[i], seen_.high[i]});
    }
}

void OpenLook::raise(int cell, HorizonCode low, HorizonCode high) {
    HorizonCode& horizon = square_.horizons.values[cell];
    if (high <= horizon) return;
    std::uint64_t& word = raised_[std::size_t(cell) / 64];
    const std::uint64_t bit = std::uint64_t{1} << (unsigned(cell) % 64);
    HorizonCode& lowest = lows_[std::size_t(cell)];
    lowest = (word & bit) != 0 ? std::min(lowest, low) : low;
    word |= bit;
    horizon = high;
}

}  // namespace noonmark
