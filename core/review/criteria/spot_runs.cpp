#include "core/review/criteria/spot_runs.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <utility>

#include "core/measures/places/place_sums.h"

namespace noonmark {

int runsWanted(const Criterion& criterion) {
    const bool inParts = criterion.measure == Measure::share && criterion.spot.maxParts > 0;
    return inParts ? criterion.spot.maxParts : criterion.runs;
}

RunCounts countRuns(const Criterion& criterion, std::span<const std::uint32_t> lengths, double stepMin) {
    RunCounts runs;
    std::array<std::uint32_t, 8> top{};
    for (std::uint32_t length : lengths) {
        if (double(length) * stepMin < criterion.dropShorterMin * (1 - 1e-9)) continue;
        runs.total += length;
        runs.count += 1;
        for (std::uint32_t& place : top)
            if (length > place) std::swap(length, place);
    }
    runs.longest = top[0];
    for (int i = 0; i < runsWanted(criterion); ++i) runs.longestRuns += top[std::size_t(i)];
    return runs;
}

Measured measureSpot(const Criterion& criterion, const RunCounts& runs, const RunError& error) {
    const bool all = criterion.measure == Measure::spotTotal;
    const std::uint32_t steps = all                                            ? runs.total
                                : criterion.measure == Measure::spotLongestRun ? runs.longest
                                                                               : runs.longestRuns;
    const std::uint32_t uncertain = all ? runs.count : std::min(runs.count, std::uint32_t(criterion.runs));
    const double minutes = steps * error.stepMin, off = uncertain * error.runErrorMin;
    return {minutes, std::max(0.0, minutes - off), minutes + off};
}

bool meets(const SpotCondition& spot, const RunCounts& runs, const RunError& error, int sign) {
    constexpr double rounding = 1e-6;
    const double off = sign * error.runErrorMin;
    const double longest = runs.longest * error.stepMin + (runs.count > 0 ? off : 0) + rounding;
    const double total = runs.total * error.stepMin + runs.count * off + rounding;
    if ((spot.unbroken ? longest : total) >= spot.minutes) return true;
    if (spot.brokenMinutes <= 0 || longest < spot.partMinutes) return false;
    if (spot.maxParts == 0) return total >= spot.brokenMinutes;
    const std::uint32_t parts = std::min(runs.count, std::uint32_t(spot.maxParts));
    return runs.longestRuns * error.stepMin + parts * off + rounding >= spot.brokenMinutes;
}

namespace {

constexpr std::uint64_t allCells = ~std::uint64_t{0};

/// Bits of the cells of word `word` that exist.
std::uint64_t cellsOf(const PlaceShadow& shadow, std::size_t word) {
    const std::size_t left = shadow.baseline.receivers - word * 64;
    return left >= 64 ? allCells : (std::uint64_t{1} << left) - 1;
}

/// Bits of the cells that have the quantity at a step.
std::uint64_t quantityBits(const PlaceShadow& shadow, Quantity quantity, bool former, std::size_t step,
                           std::size_t word) {
    const std::uint64_t before = shadow.baseline.at(step)[word], after = shadow.scenario.at(step)[word];
    if (quantity == Quantity::incremental) return former ? 0 : after & ~before;
    const std::uint64_t shaded = former ? before : after;
    return quantity == Quantity::sun ? ~shaded & cellsOf(shadow, word) : shaded;
}

bool continuesFrom(const PlaceShadow& shadow, std::size_t step) {
    return step > 0 && shadow.steps[step].slot == shadow.steps[step - 1].slot + 1;
}

/// Collects the runs of the cells of one word.
class RunCounter {
public:
    RunCounter(SpotRuns& runs, const RunSettings& settings, double stepMinutes, std::size_t firstCell)
        : runs_(runs), settings_(settings), stepMinutes_(stepMinutes), firstCell_(firstCell) {
        if (settings.longest > 1) top_.resize(64);
    }

    void take(std::uint64_t bits, std::size_t step) {
        for (std::uint64_t ended = current_ & ~bits; ended != 0; ended &= ended - 1)
            end(std::size_t(std::countr_zero(ended)), step);
        for (std::uint64_t begun = bits & ~current_; begun != 0; begun &= begun - 1)
            begin_[std::size_t(std::countr_zero(begun))] = std::uint32_t(step);
        current_ = bits;
    }

    void finish() {
        for (std::size_t lane = 0; lane < top_.size(); ++lane)
            for (int i = 0; i < settings_.longest; ++i)
                if (const std::uint32_t length = top_[lane][std::size_t(i)]; length > 0)
                    runs_.longestRuns[firstCell_ + lane] += length;
    }

private:
    void end(std::size_t lane, std::size_t step) {
        std::uint32_t length = std::uint32_t(step) - begin_[lane];
        if (double(length) * stepMinutes_ < settings_.dropShorterMin * (1 - 1e-9)) return;
        const std::size_t cell = firstCell_ + lane;
        runs_.total[cell] += length;
        runs_.count[cell] += 1;
        runs_.longest[cell] = std::max(runs_.longest[cell], length);
        if (top_.empty()) {
            runs_.longestRuns[cell] = runs_.longest[cell];
            return;
        }
        for (std::uint32_t& place : top_[lane])
            if (length > place) std::swap(length, place);
    }

    SpotRuns& runs_;
    const RunSettings& settings_;
    double stepMinutes_;
    std::size_t firstCell_;
    std::uint64_t current_ = 0;
    std::array<std::uint32_t, 64> begin_{};
    std::vector<std::array<std::uint32_t, 8>> top_;  // empty: only the longest is wanted
};

/// Bits of the cells of a word that have the quantity, by step. False: none has it at any.
bool readWord(const PlaceShadow& shadow, Quantity quantity, bool former, std::size_t word,
              std::vector<std::uint64_t>& bits) {
    std::uint64_t any = 0;
    for (std::size_t step = 0; step < bits.size(); ++step)
        any |= bits[step] = quantityBits(shadow, quantity, former, step, word);
    return any != 0;
}

std::uint32_t countBits(std::span<const std::uint64_t> words) {
    std::uint32_t bits = 0;
    for (const std::uint64_t word : words) bits += std::uint32_t(std::popcount(word));
    return bits;
}

}  // namespace

SpotRuns countRuns(const PlaceShadow& shadow, Quantity quantity, bool former, const RunSettings& settings) {
    const std::size_t cells = shadow.baseline.receivers, steps = shadow.steps.size();
    SpotRuns runs;
    for (auto* counts : {&runs.total, &runs.longest, &runs.longestRuns, &runs.count})
        counts->assign(cells, 0);
    if (quantity == Quantity::incremental && former) return runs;
    std::vector<std::uint64_t> bits(steps);
    for (std::size_t word = 0; word < shadow.baseline.wordsPerStep(); ++word) {
        if (!readWord(shadow, quantity, former, word, bits)) continue;
        RunCounter counter(runs, settings, shadow.stepMinutes, word * 64);
        for (std::size_t step = 0; step < steps; ++step) {
            if (!continuesFrom(shadow, step)) counter.take(0, step);
            counter.take(bits[step], step);
        }
        counter.take(0, steps);
        counter.finish();
    }
    return runs;
}

const SpotRuns& RunsOfDay::count(Quantity quantity, bool former, const RunSettings& settings) {
    const auto known = std::ranges::find_if(counted_, [&](const Counted& one) {
        return one.quantity == quantity && one.former == former && one.settings == settings;
    });
    if (known != counted_.end()) return known->runs;
    counted_.push_back({quantity, former, settings, countRuns(*shadow_, quantity, former, settings)});
    return counted_.back().runs;
}

void leaveOutBeside(const PlaceShadow& shadow, Quantity quantity, std::vector<std::uint32_t>& steps) {
    constexpr auto endless = std::numeric_limits<std::uint32_t>::max();
    for (const WeightedCell& cell : shadow.uneven)
        if (cell.isBeside) steps[cell.bit] = quantity == Quantity::sun ? endless : 0;
}

std::vector<bool> findSpotsWithMore(const PlaceShadow& shadow, Quantity quantity) {
    std::vector<bool> more(shadow.baseline.receivers);
    for (std::size_t word = 0; word < shadow.baseline.wordsPerStep(); ++word) {
        std::uint64_t any = 0;
        for (std::size_t step = 0; step < shadow.steps.size(); ++step)
            any |= quantityBits(shadow, quantity, false, step, word) &
                   ~quantityBits(shadow, quantity, true, step, word);
        for (; any != 0; any &= any - 1) more[word * 64 + std::size_t(std::countr_zero(any))] = true;
    }
    return more;
}

ShadedCells countShadedCells(const PlaceShadow& shadow) {
    ShadedCells cells;
    for (std::size_t step = 0; step < shadow.steps.size(); ++step) {
        cells.baseline.push_back(countBits(shadow.baseline.at(step)));
        cells.scenario.push_back(countBits(shadow.scenario.at(step)));
        std::uint32_t added = 0;
        for (std::size_t word = 0; word < shadow.baseline.wordsPerStep(); ++word)
            added +=
                std::uint32_t(std::popcount(quantityBits(shadow, Quantity::incremental, false, step, word)));
        cells.incremental.push_back(added);
        const StepAreas areas =
            weighStep(shadow, step, {cells.baseline.back(), cells.scenario.back(), added});
        cells.baselineM2.push_back(areas.baselineM2);
        cells.scenarioM2.push_back(areas.scenarioM2);
        cells.incrementalM2.push_back(areas.incrementalM2);
        cells.baseline.back() = std::uint32_t(areas.centres.baseline);
        cells.scenario.back() = std::uint32_t(areas.centres.scenario);
        cells.incremental.back() = std::uint32_t(areas.centres.incremental);
    }
    return cells;
}

}  // namespace noonmark
