#include "core/measures/places/place_timeline.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <tuple>

#include "core/measures/places/place_sums.h"

namespace noonmark {

namespace {

// Words of a row that are searched together: with a day's minutes they stay in the first level of the cache.
constexpr std::size_t stripWords = 4;

/// Some words of all rows, of which a bit remains where a run of `length()` rows begins.
class StripRuns {
public:
    StripRuns(std::span<const BitRow> rows, std::size_t word, std::size_t words)
        : bits_(rows.size() * stripWords) {
        for (std::size_t row = 0; row < rows.size(); ++row) {
            if (rows[row].set == nullptr) continue;
            for (std::size_t i = 0; i < words; ++i) {
                const std::uint64_t unset = rows[row].unset == nullptr ? 0 : rows[row].unset[word + i];
                bits_[row * stripWords + i] = rows[row].set[word + i] & ~unset;
            }
        }
        any_ = std::ranges::any_of(bits_, [](std::uint64_t bits) { return bits != 0; });
    }

    [[nodiscard]] bool any() const { return any_; }
    [[nodiscard]] std::size_t length() const { return length_; }

    /// Keeps runs of `length` rows only, or more precisely their beginnings.
    void keep(std::size_t length) {
        while (any_ && length_ < length) {
            const std::size_t by = std::min(length_, length - length_);
            any_ = extend(by, bits_);
            length_ += by;
        }
    }

    /// Keeps the longest runs. Some run must be there.
    void keepLongest() {
        while (tryExtending(length_)) {
        }
        for (std::size_t by = std::bit_floor(length_ - 1); by > 0; by /= 2) tryExtending(by);
    }

    /// The first run in the earliest row; `column` is counted from the first word of the strip.
    [[nodiscard]] ColumnRun first() const {
        const auto at =
            std::size_t(std::ranges::find_if(bits_, [](auto bits) { return bits != 0; }) - bits_.begin());
        return {at / stripWords, at % stripWords * 64 + std::size_t(std::countr_zero(bits_[at])), length_};
    }

private:
    // Writes where runs begin that are longer by some rows, at most length(). Returns whether there are any.
    bool extend(std::size_t by, std::vector<std::uint64_t>& longer) const {
        const std::size_t offset = by * stripWords,
                          common = bits_.size() > offset ? bits_.size() - offset : 0;
        longer.resize(bits_.size());
        std::uint64_t any = 0;
        for (std::size_t i = 0; i < common; ++i) any |= longer[i] = bits_[i] & bits_[i + offset];
        std::fill(longer.begin() + std::ptrdiff_t(common), longer.end(), 0);
        return any != 0;
    }

    bool tryExtending(std::size_t by) {
        if (!extend(by, longer_)) return false;
        bits_.swap(longer_);
        length_ += by;
        return true;
    }

    std::vector<std::uint64_t> bits_, longer_;  // by row
    std::size_t length_ = 1;
    bool any_ = false;
};

bool isBetter(const ColumnRun& run, const ColumnRun& than) {
    return std::tuple(than.length, run.row, run.column) < std::tuple(run.length, than.row, than.column);
}

}  // namespace

std::optional<ColumnRun> findLongestColumnRun(std::span<const BitRow> rows, std::size_t words) {
    std::optional<ColumnRun> longest;
    for (std::size_t word = 0; word < words; word += stripWords) {
        StripRuns runs(rows, word, std::min(stripWords, words - word));
        if (longest) runs.keep(longest->length);
        if (!runs.any()) continue;
        runs.keepLongest();
        ColumnRun run = runs.first();
        run.column += word * 64;
        if (!longest || isBetter(run, *longest)) longest = run;
    }
    return longest;
}

namespace {

/// The end of each step, and which steps begin a new span.
class StepTimes {
public:
    explicit StepTimes(const PlaceShadow& shadow) : shadow_(shadow) {}

    // The beginning of the next step where it follows at once, else one step length later.
    [[nodiscard]] Instant endOf(std::size_t step) const {
        const auto steps = shadow_.steps;
        if (step + 1 < steps.size() && !breaks(step + 1)) return steps[step + 1].at;
        return steps[step].at + std::chrono::milliseconds(std::llround(shadow_.stepMinutes * 60000));
    }
    [[nodiscard]] bool breaks(std::size_t step) const {
        return step == 0 || shadow_.steps[step].slot != shadow_.steps[step - 1].slot + 1;
    }

private:
    const PlaceShadow& shadow_;
};

/// Adds up one kind of shadow step by step.
class ShadowSum {
public:
    ShadowSum(const PlaceShadow& shadow, ShadowOnPlace& to) : shadow_(shadow), times_(shadow), to_(to) {}

    /// `points`: those in shadow that lie in the place, centres of cells and others.
    void add(std::size_t step, double areaM2, std::size_t points) {
        const Instant at = shadow_.steps[step].at;
        to_.areaHoursM2 += areaM2 * shadow_.stepMinutes / 60;
        if (areaM2 > to_.largestM2) {
            to_.largestM2 = areaM2;
            to_.largestAt = at;
        }
        const bool shaded = points > 0;
        if (shaded && (!before_ || times_.breaks(step)))
            to_.intervals.push_back({at, times_.endOf(step)});
        else if (shaded)
            to_.intervals.back().to = times_.endOf(step);
        if (shaded) to_.minutes += shadow_.stepMinutes;
        before_ = shaded;
    }

private:
    const PlaceShadow& shadow_;
    StepTimes times_;
    ShadowOnPlace& to_;
    bool before_ = false;
};

/// The longest run of rows in which a column has its bit.
std::size_t findLongestRunOf(const std::vector<BitRow>& rows, std::size_t column) {
    const std::uint64_t bit = std::uint64_t{1} << column % 64;
    const std::size_t word = column / 64;
    std::size_t longest = 0, current = 0;
    for (const BitRow& row : rows) {
        const bool set = row.set != nullptr && (row.set[word] & bit) != 0 &&
                         (row.unset == nullptr || (row.unset[word] & bit) == 0);
        current = set ? current + 1 : 0;
        longest = std::max(longest, current);
    }
    return longest;
}

bool isBesidePlace(const PlaceShadow& shadow, std::size_t cell) {
    return std::ranges::any_of(shadow.uneven,
                               [&](const WeightedCell& one) { return one.bit == cell && one.isBeside; });
}

/// The most steps between a cell's longest run and those of the cells beside it that have their centres in
/// the place.
std::size_t findStepsBeside(const PlaceShadow& shadow, const std::vector<BitRow>& rows, std::size_t cell,
                            std::size_t steps) {
    std::size_t maximum = 0;
    const auto compare = [&](std::size_t from, std::size_t to, std::size_t count) {
        if (cell < from || cell >= from + count) return;
        const std::size_t other = to + (cell - from);
        if (isBesidePlace(shadow, other)) return;
        const std::size_t beside = findLongestRunOf(rows, other);
        maximum = std::max(maximum, steps - std::min(steps, beside));
    };
    for (const NeighbourCells& pairs : shadow.neighbours) {
        compare(pairs.first, pairs.second, pairs.count);
        compare(pairs.second, pairs.first, pairs.count);
    }
    return maximum;
}

// The steps' rows, with an empty row where steps do not follow each other.
std::optional<LongestStay> findLongestStay(const PlaceShadow& shadow, const StepMasks& of,
                                           const StepMasks* without = nullptr) {
    const StepTimes times(shadow);
    std::vector<BitRow> rows;
    std::vector<std::size_t> stepOfRow;
    rows.reserve(shadow.steps.size());
    stepOfRow.reserve(shadow.steps.size());
    for (std::size_t step = 0; step < shadow.steps.size(); ++step) {
        if (step > 0 && times.breaks(step)) {
            rows.emplace_back();
            stepOfRow.push_back(step);
        }
        rows.push_back({of.at(step).data(), without == nullptr ? nullptr : without->at(step).data()});
        stepOfRow.push_back(step);
    }
    const auto run = findLongestColumnRun(rows, of.wordsPerStep());
    if (!run) return std::nullopt;
    const std::size_t first = stepOfRow[run->row], last = first + run->length - 1;
    const std::size_t beside = findStepsBeside(shadow, rows, run->column, run->length);
    return LongestStay{.minutes = double(run->length) * shadow.stepMinutes,
                       .errorMin = double(beside + 1) * shadow.stepMinutes,
                       .cell = run->column,
                       .when = {shadow.steps[first].at, times.endOf(last)}};
}

void addLongestStays(const PlaceShadow& shadow, DayTimeline& day) {
    const StepMasks before = dropEdgeCells(shadow, shadow.baseline),
                    after = dropEdgeCells(shadow, shadow.scenario);
    const bool differ = day.incremental.minutes > 0 || day.gained.minutes > 0;
    if (day.baseline.minutes > 0) day.baseline.longest = findLongestStay(shadow, before);
    if (!differ)
        day.scenario.longest = day.baseline.longest;
    else if (day.scenario.minutes > 0)
        day.scenario.longest = findLongestStay(shadow, after);
    if (day.incremental.minutes > 0) day.incremental.longest = findLongestStay(shadow, after, &before);
    if (day.gained.minutes > 0) day.gained.longest = findLongestStay(shadow, before, &after);
}

}  // namespace

std::optional<Instant> ShadowOnPlace::enters() const {
    if (intervals.empty()) return std::nullopt;
    return intervals.front().from;
}

std::optional<Instant> ShadowOnPlace::exits() const {
    if (intervals.empty()) return std::nullopt;
    return intervals.back().to;
}

namespace {

/// Points in shadow at a step, of those with their centre in the place.
StepAreas countPoints(std::span<const PlaceShadow> shadows, std::size_t step) {
    StepAreas sum;
    for (const PlaceShadow& shadow : shadows) {
        const StepCounts counts = countStep(shadow.baseline.at(step), shadow.scenario.at(step));
        const StepCounts centres = weighStep(shadow, step, counts).centres;
        sum.centres.baseline += centres.baseline;
        sum.centres.scenario += centres.scenario;
        sum.centres.incremental += centres.incremental;
    }
    return sum;
}

}  // namespace

DayTimeline computeTimeline(const PlaceShadow& shadow, const TimelineSettings& settings) {
    DayTimeline day{.day = shadow.day, .areaM2 = shadow.areaM2(), .stepMinutes = shadow.stepMinutes};
    day.sunlitMinutes = double(shadow.steps.size()) * shadow.stepMinutes;
    ShadowSum baseline(shadow, day.baseline), scenario(shadow, day.scenario),
        incremental(shadow, day.incremental), gained(shadow, day.gained);
    const std::size_t cells = countCentres(shadow);
    for (std::size_t step = 0; step < shadow.steps.size(); ++step) {
        const StepCounts counts = countStep(shadow.baseline.at(step), shadow.scenario.at(step));
        const StepAreas weighed = weighStep(shadow, step, counts);
        const PlaceStep areas{shadow.steps[step].at, weighed.baselineM2, weighed.scenarioM2,
                              weighed.incrementalM2, weighed.gainedM2};
        const StepCounts& centres = weighed.centres;
        const StepAreas between = countPoints(settings.spots, step);
        baseline.add(step, areas.baselineM2, centres.baseline + between.centres.baseline);
        scenario.add(step, areas.scenarioM2, centres.scenario + between.centres.scenario);
        incremental.add(step, areas.incrementalM2, centres.incremental + between.centres.incremental);
        gained.add(step, areas.gainedM2, weighed.gainedCentres() + between.gainedCentres());
        if (cells > 0 && centres.scenario == cells) {
            day.fullCoverMin += shadow.stepMinutes;
            if (centres.baseline < cells) day.allSunTakenMin += shadow.stepMinutes;
        }
        if (settings.steps) day.steps.push_back(areas);
    }
    if (settings.longestStays) addLongestStays(shadow, day);
    return day;
}

}  // namespace noonmark
