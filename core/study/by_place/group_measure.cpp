#include "core/study/by_place/group_measure.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <memory>

#include "core/base/progress.h"
#include "core/describe/text.h"
#include "core/engines/ray/tree_rays.h"
#include "core/engines/shade_trees.h"
#include "core/measures/shadow_figures.h"
#include "core/study/by_place/sum_places.h"

namespace noonmark {

namespace {

// A failure to measure the error does not fail the study; only a stop request ends it.
Result<std::optional<SampledError>> measureError(Measuring& m, std::size_t city, const Receivers& receivers,
                                                 const SunSteps& sun, const ShadowField& field) {
    std::optional<SampledError> error;
    const ErrorSampleSettings& sample = m.settings().study.errorSample;
    if (sample.receivers == 0 || m.settings().study.engine == referenceEngine) return error;
    NoProgress quiet;
    auto taken = takeError(sampleError(*m.cities[city], receivers, sun, field, sample, quiet, m.stop), error,
                           m.made[city].warnings);
    if (!taken) return tl::make_unexpected(taken.error());
    return error;
}

bool wantsErrors(const Measuring& m) {
    return m.settings().study.errorSample.receivers > 0 && m.settings().study.engine != referenceEngine;
}

ErrorSampleSettings sampleOf(const Measuring& m, bool isMain) {
    constexpr int minimum = 8;  // cells
    ErrorSampleSettings sample = m.settings().study.errorSample;
    if (!isMain)
        sample.receivers =
            std::max<decltype(sample.receivers)>(minimum, sample.receivers / sampledSmallGroups);
    return sample;
}

/// Holds the figures of places against rays, in one city after the other.
class PlaceErrors {
public:
    PlaceErrors(Measuring& m, const CellGroup& group, bool isMain)
        : m_(m), receivers_(group.on.receivers), wanted_(wantsErrors(m)) {
        if (wanted_) places_ = samplePlaces(group, sampleOf(m, isMain), m.daylight.steps.size());
    }

    /// Of small places; their differences are stated together with those of other groups.
    Result<void> takeSmall(std::size_t city, const ShadowBreakdown& sums) {
        if (!wanted_) return {};
        const SunlitTime time{m_.daylight.sunlitMinutes(), countDays(m_.daylight), 0};
        const auto compared = compare(city, m_.daylight, sums);
        if (!compared) return warn(m_.made[city], compared.error());
        std::vector<double>& off = m_.smallOff[city];
        std::ranges::copy(listMeanDifferences(places_, *compared, time), std::back_inserter(off));
        return {};
    }

    Result<void> takePeriod(std::size_t city, const ShadowBreakdown& sums) {
        if (!wanted_) return {};
        SunByPlace& made = m_.made[city];
        const SunlitTime time{m_.daylight.sunlitMinutes(), countDays(m_.daylight), made.settings.enoughHours};
        auto compared = compare(city, m_.daylight, sums);
        if (!compared) return warn(made, compared.error());
        if (made.error) {
            const ShownError cells = listErrors(*made.error, false).front();
            made.errors.push_back(
                {findErrorFacts("cell_sun"), {}, cells.mean, cells.p99, cells.largest, cells.count});
        }
        append(made, listPeriodErrors(places_, *compared, time));
        if (city > 0 && !m_.compared.empty())
            append(made,
                   {listChangeErrors(places_, m_.compared.front(), *compared, time, made.settings.lossMin)});
        m_.compared.push_back(*std::move(compared));
        return {};
    }

    Result<void> takeDate(std::size_t city, const SunSteps& sun, const ShadowBreakdown& sums,
                          const CivilDate& date) {
        if (!wanted_) return {};
        SunByPlace& made = m_.made[city];
        const SunlitTime time{sun.sunlitMinutes(), {1}, made.settings.enoughHours};
        const auto compared = compare(city, sun, sums);
        if (!compared) return warn(made, compared.error());
        append(made, listDateErrors(places_, *compared, time, formatText(date)));
        return {};
    }

    /// The same with trees, after takePeriod() of that city.
    Result<void> takeShadedPeriod(std::size_t city, const ShadedSets& shaded, const StepSets& months) {
        SunByPlace& made = m_.made[city];
        const SunlitTime time{m_.daylight.sunlitMinutes(), countDays(m_.daylight), made.settings.enoughHours};
        return compareShaded(city, m_.daylight, shaded, months, [&](TreeColumns column, ComparedSets all) {
            PlaceErrorList list = listPeriodErrors(places_, all, time);
            if (city > 0 && !m_.compared.empty()) {
                const auto first = shadedBaseline_.find(column);
                const ComparedSets& before =
                    first == shadedBaseline_.end() ? m_.compared.front() : first->second;
                std::ranges::move(listChangeErrors(places_, before, all, time, made.settings.lossMin),
                                  std::back_inserter(list.errors));
            }
            if (city == 0) shadedBaseline_.insert_or_assign(column, std::move(all));
            return list;
        });
    }

    /// The same with trees, after takeDate() of that city.
    Result<void> takeShadedDate(std::size_t city, const SunSteps& sun, const ShadedSets& shaded,
                                const StepSets& one, const CivilDate& date) {
        const SunlitTime time{sun.sunlitMinutes(), {1}, m_.made[city].settings.enoughHours};
        return compareShaded(city, sun, shaded, one, [&](TreeColumns, const ComparedSets& all) {
            return listDateErrors(places_, all, time, formatText(date));
        });
    }

private:
    // `listErrors`: of a column and its compared sets.
    template <class ListErrors>
    Result<void> compareShaded(std::size_t city, const SunSteps& sun, const ShadedSets& shaded,
                               const StepSets& sets, const ListErrors& listErrors) {
        if (!wanted_ || reference_.empty()) return {};
        SunByPlace& made = m_.made[city];
        NoProgress quiet;
        const City weighed = withTreesFor(*m_.cities[city], m_.settings().study.trees);
        const auto taken =
            traceTreeSets(weighed, onlyReceivers(receivers_, places_.cells), sun, sets, quiet, m_.stop);
        if (!taken) return warn(made, taken.error());
        for (const SunWithTrees& with : made.withTrees) {
            ComparedSets all{minutesAt(*shaded.of(with.column), places_.cells), reference_};
            if (*taken) addTaken(all.reference, (*taken)->of(with.column));
            append(made, nameColumn(listErrors(with.column, std::move(all)), with.column));
        }
        return {};
    }

    static void addTaken(std::vector<std::vector<double>>& minutes,
                         const std::vector<std::vector<float>>& taken) {
        for (std::size_t set = 0; set < minutes.size(); ++set)
            for (std::size_t cell = 0; cell < minutes[set].size(); ++cell)
                minutes[set][cell] += double(taken[set][cell]);
    }

    static PlaceErrorList nameColumn(PlaceErrorList list, TreeColumns column) {
        const auto name = [column](std::string& of) {
            of += (of.empty() ? "" : ", ") + std::string(describeTrees(column));
        };
        for (ShownError& error : list.errors) name(error.of);
        for (SampledShares& shares : list.shares) name(shares.of);
        return list;
    }

    Result<ComparedSets> compare(std::size_t city, const SunSteps& sun, const ShadowBreakdown& sums) {
        NoProgress quiet;
        auto compared = compareSets(*m_.cities[city], receivers_, sun, sums, places_.cells, quiet, m_.stop);
        reference_ = compared ? compared->reference : std::vector<std::vector<double>>();
        return compared;
    }

    static void append(SunByPlace& made, PlaceErrorList list) {
        std::ranges::move(list.errors, std::back_inserter(made.errors));
        std::ranges::move(list.shares, std::back_inserter(made.sampledShares));
    }

    // A missing error fails nothing.
    static Result<void> warn(SunByPlace& made, const Error& error) {
        if (isCancelled(error)) return tl::make_unexpected(error);
        made.warnings.push_back(
            {WarningKind::leftOut, "the error of places against the ray reference", error.text()});
        return {};
    }

    Measuring& m_;
    const Receivers& receivers_;
    bool wanted_;
    SampledPlaces places_;
    std::vector<std::vector<double>> reference_;            // of what was compared last, without trees
    std::map<TreeColumns, ComparedSets> shadedBaseline_{};  // the period in the first city
};

/// Measures the places of one group in all cities.
class GroupMeasure {
public:
    GroupMeasure(Measuring& m, const MeasuredGroup& group, Progress& progress)
        : m_(m),
          group_(group.cells),
          receivers_(group_.on.receivers),
          isMain_(group.isMain),
          isSampled_(group.isSampled),
          progress_(progress) {}

    Result<void> run() {
        if (isSampled_) errors_ = std::make_unique<PlaceErrors>(m_, group_, isMain_);
        if (auto done = timeStage(m_.made.front(), "accumulate", [&] { return sweepMonths(); }); !done)
            return done;
        for (std::size_t date = 0; date < m_.dates.size(); ++date)
            if (auto done = timeStage(m_.made.front(), "dates", [&] { return sweepDate(date); }); !done)
                return done;
        return {};
    }

    /// Seconds that run() is expected to take, if no sample is off.
    [[nodiscard]] double forecast() const {
        double seconds = forecast(0, m_.daylight, m_.months);
        for (std::size_t date = 0; date < m_.dates.size(); ++date) {
            const SunSteps& day = m_.dates[date];
            if (day.steps.empty() || m_.stop.stop_requested()) continue;
            seconds += forecast(date + 1, day, makeOneSet(day));
        }
        return seconds;
    }

private:
    [[nodiscard]] double forecast(std::size_t sweep, const SunSteps& sun, const StepSets& sets) const {
        CitySweeps sweeps(engineOf(sweep), m_.cities, receivers_, sun, sets);
        const double seconds = sweeps.forecast(keyOf(sweep), sampledOver(sun));
        return m_.hasTrees ? seconds + sweeps.forecastTrees(isMain_ ? sampledPlaces(sun) : 0) : seconds;
    }

    [[nodiscard]] std::size_t sampledPlaces(const SunSteps& sun) const {
        return sampleSize(sampleOf(m_, isMain_), sun.steps.size()) / 2;
    }

    // Cells that rays are traced to in each city: the sample, and half as many in places.
    [[nodiscard]] std::size_t sampledOver(const SunSteps& sun) const {
        const std::size_t places = sampledPlaces(sun);
        if (isMain_) return places * 3;
        return isSampled_ && &sun == &m_.daylight ? places : 0;
    }

    // Over the period (0) or on a date (1 and on).
    [[nodiscard]] const Engine& engineOf(std::size_t sweep) const {
        const auto& own = m_.chosen[sweep].engine;
        return isMain_ || !own ? m_.engine : *own;
    }
    [[nodiscard]] std::string_view keyOf(std::size_t sweep) const {
        const ChosenEngine& own = m_.chosen[sweep];
        return isMain_ || !own.engine ? std::string_view(m_.settings().study.engine)
                                      : std::string_view(own.key);
    }

    // By the engine in use, and by those that it goes on to while samples are off by more than it aims at.
    Result<void> sweepMonths() {
        CitySweeps sweeps(m_.missed.empty() ? engineOf(0) : m_.engine, m_.cities, receivers_, m_.daylight,
                          m_.months);
        for (const SampledDeviation& off : m_.missed) sweeps.switchToMoreExact(off);
        for (;;) {
            auto first = sweepFirst(sweeps);
            if (!first) return tl::make_unexpected(first.error());
            const auto& error = m_.made.front().error;
            if (isMain_ && error && sweeps.switchToMoreExact(error->grossOff())) {
                m_.missed.push_back(error->grossOff());
                --done_;  // the same again
                continue;
            }
            if (auto taken = takeErrors(0, *first); !taken) return taken;
            if (auto shaded = shadeMonths(0, *first); !shaded) return shaded;
            return sweepOthers(sweeps, *first);
        }
    }

    Result<ShadowBreakdown> sweepFirst(CitySweeps& sweeps) {
        ProgressShare share = nextShare();
        auto sums = sweeps.sweepFirst(share, m_.stop);
        if (!sums) return sums;
        if (auto taken = take(0, *sums); !taken) return tl::make_unexpected(taken.error());
        return sums;
    }

    Result<void> sweepOthers(CitySweeps& sweeps, const ShadowBreakdown& first) {
        for (std::size_t city = 1; city < m_.cities.size(); ++city) {
            ProgressShare share = nextShare();
            const auto sums = sweeps.sweepOther(city, first, share, m_.stop);
            if (!sums) return tl::make_unexpected(sums.error());
            if (auto taken = take(city, *sums); !taken) return taken;
            if (auto taken = takeErrors(city, *sums); !taken) return taken;
            if (auto shaded = shadeMonths(city, *sums); !shaded) return shaded;
        }
        return {};
    }

    Result<void> takeErrors(std::size_t city, const ShadowBreakdown& sums) {
        if (!errors_) return {};
        const Stopwatch watch;
        auto taken = isMain_ ? errors_->takePeriod(city, sums) : errors_->takeSmall(city, sums);
        m_.made[city].seconds["error_sample"] += watch.seconds();
        return taken;
    }

    Result<void> take(std::size_t city, const ShadowBreakdown& sums) {
        SunByPlace& made = m_.made[city];
        const MeanDay day = averageDay(sums, m_.daylight);
        takeMonths(made, group_, sums, day, made.sun);
        if (!isMain_) return {};
        ShadowField field = makeField(sums, day, receivers_, m_.daylight);
        const Stopwatch watch;
        auto error = measureError(m_, city, receivers_, m_.daylight, field);
        made.seconds["error_sample"] += watch.seconds();
        if (!error) return tl::make_unexpected(error.error());
        made.error = *error;
        made.field = std::move(field);
        return {};
    }

    // A day on which the sun does not rise leaves every cell without sun.
    Result<void> sweepDate(std::size_t date) {
        const SunSteps& sun = m_.dates[date];
        const StepSets one = makeOneSet(sun);
        if (sun.steps.empty()) {
            for (std::size_t city = 0; city < m_.cities.size(); ++city) takeSunlessDay(city);
            return {};
        }
        CitySweeps sweeps(engineOf(date + 1), m_.cities, receivers_, sun, one);
        std::optional<ShadowBreakdown> first;
        for (std::size_t city = 0; city < m_.cities.size(); ++city) {
            ProgressShare share = nextShare();
            auto sums = city == 0 ? sweeps.sweepFirst(share, m_.stop)
                                  : sweeps.sweepOther(city, *first, share, m_.stop);
            if (!sums) return tl::make_unexpected(sums.error());
            if (auto taken = takeDay(city, sun, *sums); !taken) return taken;
            if (isMain_ && errors_)
                if (auto taken = errors_->takeDate(city, sun, *sums, m_.settings().dates[date]); !taken)
                    return taken;
            if (auto shaded = shadeDate(city, date, *sums); !shaded) return shaded;
            if (city == 0) first = *std::move(sums);
        }
        return {};
    }

    // Where no tree reaches a place of one of several cities, its figures are those without trees.
    Result<std::optional<ShadedSets>> shade(std::size_t city, const SunSteps& sun,
                                            const ShadowBreakdown& sums) {
        if (!m_.hasTrees) return std::nullopt;
        const Stopwatch watch;
        ProgressShare share = nextShare();
        auto shaded =
            shadeTreeSets(*m_.cities[city], receivers_, sun, sums, m_.settings().study.trees, share, m_.stop);
        m_.made[city].seconds["trees"] += watch.seconds();
        if (shaded && *shaded) {
            m_.treesReached = true;
            if (isMain_) m_.made[city].treesHow = (*shaded)->how;
        }
        return shaded;
    }

    Result<void> shadeMonths(std::size_t city, const ShadowBreakdown& sums) {
        SunByPlace& made = m_.made[city];
        const auto shaded = shade(city, m_.daylight, sums);
        if (!shaded) return tl::make_unexpected(shaded.error());
        for (SunWithTrees& with : made.withTrees) {
            const ShadowBreakdown& own = *shaded ? *(*shaded)->of(with.column) : sums;
            takeMonths(made, group_, own, averageDay(own, m_.daylight), with.sun);
        }
        if (!*shaded || !isMain_ || !errors_) return {};
        return errors_->takeShadedPeriod(city, **shaded, m_.months);
    }

    Result<void> shadeDate(std::size_t city, std::size_t date, const ShadowBreakdown& sums) {
        SunByPlace& made = m_.made[city];
        const SunSteps& sun = m_.dates[date];
        const auto shaded = shade(city, sun, sums);
        if (!shaded) return tl::make_unexpected(shaded.error());
        for (SunWithTrees& with : made.withTrees) {
            const ShadowBreakdown& own = *shaded ? *(*shaded)->of(with.column) : sums;
            takeDate(made, group_, averageDay(own, sun), with.sun);
        }
        if (!*shaded || !isMain_ || !errors_) return {};
        return errors_->takeShadedDate(city, sun, **shaded, sums.sets, m_.settings().dates[date]);
    }

    void takeSunlessDay(std::size_t city) {
        SunByPlace& made = m_.made[city];
        const MeanDay sunless{std::vector<float>(receivers_.cells.size()), 0};
        takeDate(made, group_, sunless, made.sun);
        for (SunWithTrees& with : made.withTrees) takeDate(made, group_, sunless, with.sun);
        if (isMain_) m_.made[city].dateErrors.emplace_back();
    }

    Result<void> takeDay(std::size_t city, const SunSteps& sun, const ShadowBreakdown& sums) {
        const MeanDay day = averageDay(sums, sun);
        takeDate(m_.made[city], group_, day, m_.made[city].sun);
        if (!isMain_) return {};
        auto error = measureError(m_, city, receivers_, sun, makeField(sums, day, receivers_, sun));
        if (!error) return tl::make_unexpected(error.error());
        m_.made[city].dateErrors.push_back(*error);
        return {};
    }

    // Each sweep, and with trees another one.
    ProgressShare nextShare() {
        return {progress_, done_++, m_.cities.size() * (1 + m_.dates.size()) * (m_.hasTrees ? 2 : 1)};
    }

    Measuring& m_;
    const CellGroup& group_;
    const Receivers& receivers_;
    bool isMain_, isSampled_;
    Progress& progress_;
    std::unique_ptr<PlaceErrors> errors_;  // null: it is not sampled
    std::size_t done_ = 0;
};

}  // namespace

Result<void> measureGroup(Measuring& m, const MeasuredGroup& group, Progress& progress) {
    return GroupMeasure(m, group, progress).run();
}

double forecastGroup(Measuring& m, const MeasuredGroup& group) {
    return GroupMeasure(m, group, m.progress).forecast();
}

}  // namespace noonmark
