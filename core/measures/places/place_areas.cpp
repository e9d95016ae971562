#include "core/measures/places/place_areas.h"

#include <algorithm>
#include <bit>

namespace noonmark {

namespace {

bool hasBit(std::span<const std::uint64_t> words, std::uint32_t bit) {
    return (words[bit / 64] >> (bit % 64) & 1U) != 0;
}

}  // namespace

StepAreas weighStep(const PlaceShadow& shadow, std::size_t step, const StepCounts& counts) {
    const auto before = shadow.baseline.at(step), after = shadow.scenario.at(step);
    double baseline = double(counts.baseline), scenario = double(counts.scenario),
           incremental = double(counts.incremental),
           gained = double(counts.baseline + counts.incremental - counts.scenario);
    StepCounts centres = counts;
    for (const UnevenCell& cell : shadow.uneven) {
        const bool was = hasBit(before, cell.bit), is = hasBit(after, cell.bit);
        baseline += was ? cell.extra : 0;
        scenario += is ? cell.extra : 0;
        incremental += is && !was ? cell.extra : 0;
        gained += was && !is ? cell.extra : 0;
        if (!cell.isBeside) continue;
        centres.baseline -= was ? 1 : 0;
        centres.scenario -= is ? 1 : 0;
        centres.incremental -= is && !was ? 1 : 0;
    }
    // Shares that add up to nothing leave a rounding error, which is no shadow.
    const auto area = [&](double cells, std::size_t count) {
        return count == 0 ? 0 : std::max(0.0, cells * shadow.cellAreaM2);
    };
    return {area(baseline, counts.baseline), area(scenario, counts.scenario),
            area(incremental, counts.incremental),
            area(gained, counts.baseline + counts.incremental - counts.scenario), centres};
}

std::size_t countCentres(const PlaceShadow& shadow) {
    const auto beside = std::ranges::count_if(shadow.uneven, &UnevenCell::isBeside);
    return shadow.baseline.receivers - std::size_t(beside);
}

StepMasks keepCentres(const PlaceShadow& shadow, const StepMasks& masks) {
    StepMasks kept = masks;
    for (const UnevenCell& cell : shadow.uneven)
        for (std::size_t step = 0; cell.isBeside && step < kept.steps; ++step)
            kept.at(step)[cell.bit / 64] &= ~(std::uint64_t{1} << cell.bit % 64);
    return kept;
}

std::uint64_t bitsAt(std::span<const std::uint64_t> words, std::size_t bit) {
    const std::size_t word = bit / 64, shift = bit % 64;
    if (word >= words.size()) return 0;
    std::uint64_t bits = words[word] >> shift;
    if (shift != 0 && word + 1 < words.size()) bits |= words[word + 1] << (64 - shift);
    return bits;
}

std::size_t countEdges(std::span<const std::uint64_t> words, std::span<const NeighbourCells> neighbours) {
    std::size_t edges = 0;
    for (const NeighbourCells& pairs : neighbours)
        for (std::uint32_t done = 0; done < pairs.count; done += 64) {
            const std::uint32_t left = std::min(64U, pairs.count - done);
            const std::uint64_t differ =
                bitsAt(words, pairs.first + done) ^ bitsAt(words, pairs.second + done);
            edges += std::size_t(std::popcount(differ & ~std::uint64_t{0} >> (64 - left)));
        }
    return edges;
}

}  // namespace noonmark
