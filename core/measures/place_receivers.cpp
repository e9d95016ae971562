#include "core/measures/place_receivers.h"

#include <algorithm>
#include <limits>

#include "core/receivers/rasterize.h"

namespace noonmark {

namespace {

Region regionOfAll(std::span<const Place> places) {
    Region region{"places", {}};
    for (const Place& place : places)
        region.polygons.insert(region.polygons.end(), place.polygons.begin(), place.polygons.end());
    return region;
}

// Leaves out the cells of `from` that are no receivers in `other`.
void keepCommon(Receivers& from, const Receivers& other) {
    std::erase_if(from.cells, [&](std::uint32_t cell) {
        const bool gone = !isReceiver(other.kind[cell]);
        if (gone) from.kind[cell] = other.kind[cell];
        return gone;
    });
}

std::vector<CellSpan> spansIn(const Place& place, const Receivers& receivers) {
    std::vector<CellSpan> spans;
    const auto& cells = receivers.cells;
    for (const Footprint& polygon : place.polygons)
        forEachRun(polygon, receivers.grid, [&](int row, int first, int end) {
            const auto from = std::ranges::lower_bound(cells, receivers.grid.index(first, row));
            const auto to = std::lower_bound(from, cells.end(), receivers.grid.index(end - 1, row) + 1);
            if (from != to) spans.push_back({std::uint32_t(from - cells.begin()), std::uint32_t(to - from)});
        });
    std::ranges::sort(spans, {}, &CellSpan::first);
    return spans;
}

// Joins spans that follow or overlap each other: polygons of a place may touch.
std::vector<CellSpan> joined(const std::vector<CellSpan>& spans) {
    std::vector<CellSpan> all;
    for (const CellSpan& span : spans) {
        if (all.empty() || span.first > all.back().first + all.back().count)
            all.push_back(span);
        else
            all.back().count =
                std::max(all.back().first + all.back().count, span.first + span.count) - all.back().first;
    }
    return all;
}

std::uint64_t bitsAt(std::span<const std::uint64_t> words, std::size_t bit) {
    const std::size_t word = bit / 64, shift = bit % 64;
    std::uint64_t bits = words[word] >> shift;
    if (shift != 0 && word + 1 < words.size()) bits |= words[word + 1] << (64 - shift);
    return bits;
}

void orBits(std::span<std::uint64_t> words, std::size_t bit, std::uint64_t bits) {
    const std::size_t word = bit / 64, shift = bit % 64;
    words[word] |= bits << shift;
    if (shift != 0 && bits >> (64 - shift) != 0) words[word + 1] |= bits >> (64 - shift);
}

std::size_t countOf(std::span<const CellSpan> spans) {
    std::size_t count = 0;
    for (const CellSpan& span : spans) count += span.count;
    return count;
}

}  // namespace

std::size_t PlaceReceivers::cellCount(std::size_t place) const { return countOf(cellsOf[place]); }

std::uint32_t PlaceReceivers::receiverOf(std::size_t place, std::size_t cell) const {
    for (const CellSpan& span : cellsOf[place]) {
        if (cell < span.count) return span.first + std::uint32_t(cell);
        cell -= span.count;
    }
    return std::numeric_limits<std::uint32_t>::max();
}

Result<PlaceReceivers> placeReceiversOnPlaces(std::span<const City* const> cities,
                                              std::span<const Place> places, const ReceiverSettings& settings,
                                              const std::stop_token& stop) {
    if (places.empty()) return failure("There is no place to measure", "places", "Read or draw places first");
    const Region region = regionOfAll(places);
    PlaceReceivers placed;
    for (std::size_t i = 0; i < cities.size(); ++i) {
        auto receivers = placeReceiversOnGround(*cities[i], region, settings, stop);
        if (!receivers) return tl::make_unexpected(receivers.error());
        if (i == 0)
            placed.receivers = *std::move(receivers);
        else
            keepCommon(placed.receivers, *receivers);
    }
    for (const Place& place : places) placed.cellsOf.push_back(joined(spansIn(place, placed.receivers)));
    return placed;
}

void chooseReceivers(const StepMasks& all, std::span<const CellSpan> spans, StepMasks& chosen) {
    chosen.receivers = countOf(spans);
    chosen.steps = all.steps;
    chosen.words.assign(chosen.steps * chosen.wordsPerStep(), 0);
    for (std::size_t step = 0; step < all.steps; ++step) {
        const auto from = all.at(step);
        const auto to = chosen.at(step);
        std::size_t bit = 0;
        for (const CellSpan& span : spans)
            for (std::uint32_t done = 0; done < span.count; done += 64) {
                const std::uint32_t left = std::min(64U, span.count - done);
                orBits(to, bit, bitsAt(from, span.first + done) & ~std::uint64_t{0} >> (64 - left));
                bit += left;
            }
    }
}

}  // namespace noonmark
