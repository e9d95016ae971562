#include "core/lab/bench/horizon/horizon_bench.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "core/base/progress.h"
#include "core/engines/api/shadow_field.h"
#include "core/engines/horizon/cache/horizon_cache.h"
#include "core/engines/projected/projected_shadows.h"
#include "core/engines/projected/shadow_cache.h"
#include "core/lab/bench/contests/moments.h"
#include "core/receivers/receivers.h"

namespace noonmark::bench {

namespace {

/// A city with a tower of 40 x 40 x 200 m in its middle, and the receivers around it.
struct TowerPlace {
    City city;
    Receivers receivers;
};

/// Distance that the tower moves, towards the east.
inline constexpr float towerMoveM = 10;

constexpr float towerSideM = 40, towerHighM = 200;

City withTower(City city, glm::vec2 middle) {
    const glm::vec2 a = middle - towerSideM / 2, b = middle + towerSideM / 2;
    Building tower;
    tower.parts.push_back({.footprint = {{a, {b.x, a.y}, b, {a.x, b.y}}, {}}, .topM = towerHighM});
    city.buildings.push_back(std::make_shared<const Building>(std::move(tower)));
    return city;
}

bool same(const std::vector<float>& a, const std::vector<float>& b) {
    return std::ranges::equal(a, b,
                              [](float x, float y) { return x == y || (std::isnan(x) && std::isnan(y)); });
}

/// The city with the tower `eastM` east of its middle. Shares the buildings of the site's city. Error: as for
/// the receivers.
Result<TowerPlace> placeTower(const BenchSite& site, float eastM, const Work& work) {
    const Region square = pickMiddleSquare(site.city, site.sideM);
    const Box2 box = bounds(square);
    TowerPlace place{withTower(site.city, (box.low + box.high) / 2.0F + glm::vec2(eastM, 0)), {}};
    auto receivers = placeReceiversOnGround(place.city, square, {}, work.stop);
    if (!receivers) return tl::make_unexpected(receivers.error());
    place.receivers = std::move(*receivers);
    return place;
}

/// Whether two fields are equal bit for bit, including cells that are not receivers.
bool haveSameMinutes(const ShadowField& a, const ShadowField& b) {
    return same(a.grossMin, b.grossMin) && same(a.continuousMin, b.continuousMin);
}

constexpr double hoursADay = 8, fewerHoursADay = 6;

/// A horizon cache and the times of operations on it. Stops at the first error.
class SavedStudy {
public:
    SavedStudy(HorizonCache kept, const Work& work) : kept_(std::move(kept)), work_(work) {}

    /// Time for gross shadow, seconds.
    Result<double> computePeriod(const SunSteps& sun) {
        return timed([&] { return kept_.computePeriod(sun, silent_, work_.stop, ShadowCounts::gross); });
    }
    Result<double> change(const TowerPlace& state) {
        return timed([&] {
            return kept_.change(state.city, state.receivers, silent_, work_.stop, ShadowCounts::gross);
        });
    }
    /// Additional time for the longest runs, seconds.
    Result<double> countRuns() {
        return timed([&] { return kept_.withRuns(silent_, work_.stop); });
    }

    [[nodiscard]] const ShadowField& field() const { return field_; }

private:
    Result<double> timed(const auto& work) {
        const Stopwatch watch;
        auto field = work();
        const double seconds = watch.seconds();
        if (!field) return tl::make_unexpected(field.error());
        field_ = std::move(*field);
        return seconds;
    }

    HorizonCache kept_;
    const Work& work_;
    NoProgress silent_;
    ShadowField field_;
};

/// Seconds for gross shadow, and for gross shadow and the longest runs together.
struct EditTimes {
    std::vector<double> gross, both;
};

struct CacheTimes {
    EditTimes full, retimes, edits;
    std::vector<double> firstEdit;
};

Result<void> checkSame(const SavedStudy& study, const SavedStudy& fresh) {
    if (haveSameMinutes(study.field(), fresh.field())) return {};
    return failure("The edited field differs from a fresh one", "cached horizons");
}

Result<SavedStudy> studyOf(const TowerPlace& state, const Work& work) {
    return HorizonCache::make(state.city, state.receivers).map([&](HorizonCache&& kept) {
        return SavedStudy(std::move(kept), work);
    });
}

Result<void> add(std::vector<double>& times, const Result<double>& seconds) {
    return seconds.map([&](double taken) { times.push_back(taken); });
}

Result<void> addBoth(std::vector<double>& times, SavedStudy& study, const Result<double>& gross) {
    if (!gross) return tl::make_unexpected(gross.error());
    return add(times, study.countRuns().map([&](double runs) { return *gross + runs; }));
}

Result<void> addFull(EditTimes& times, SavedStudy& study, const SunSteps& year) {
    const Result<double> gross = study.computePeriod(year);
    const Result<void> state = add(times.gross, gross);
    return state ? addBoth(times.both, study, gross) : state;
}

// As while a tower is dragged: first gross shadow alone, then each move with the longest runs.
Result<void> addEdits(EditTimes& times, SavedStudy& study, const TowerPlace& here, const TowerPlace& there,
                      int runs) {
    Result<void> state;
    const auto place = [&](int run) -> const TowerPlace& { return run % 2 == 0 ? here : there; };
    for (int run = 0; run < 2 * runs && state; ++run) state = add(times.gross, study.change(place(run)));
    for (int run = 0; run < 2 * runs && state; ++run)
        state = addBoth(times.both, study, study.change(place(run)));
    return state;
}

// Times a change of hours, as while a slider is dragged; each run changes back.
Result<void> addRetimes(EditTimes& times, SavedStudy& study, const SunSteps& year, const SunSteps& shorter,
                        int runs) {
    Result<void> state;
    const auto back = [&] { return study.computePeriod(year).map([](double) {}); };
    for (int run = 0; run < runs && state; ++run) {
        state = add(times.gross, study.computePeriod(shorter));
        if (state) state = back();
    }
    for (int run = 0; run < runs && state; ++run) {
        state = addBoth(times.both, study, study.computePeriod(shorter));
        if (state) state = back();
    }
    return state;
}

Result<void> measure(CacheTimes& times, const BenchSite& site, const Extent& extent, const SunSteps& year,
                     const SunSteps& shorter, const Work& work) {
    const auto here = placeTower(site, 0, work), there = placeTower(site, towerMoveM, work);
    if (!here || !there) return tl::make_unexpected(here ? there.error() : here.error());
    auto fresh = studyOf(*there, work), study = studyOf(*here, work);
    if (!fresh || !study) return tl::make_unexpected(fresh ? study.error() : fresh.error());
    Result<void> state = addFull(times.full, *fresh, year);
    if (state) state = addFull(times.full, *study, year);
    if (state) state = add(times.firstEdit, study->change(*there));
    if (state) state = study->countRuns().map([](double) {});
    if (state) state = checkSame(*study, *fresh);
    if (state) state = addEdits(times.edits, *study, *here, *there, extent.runs);
    if (state) state = checkSame(*study, *fresh);
    if (state) state = addRetimes(times.retimes, *study, year, shorter, extent.runs);
    return state;
}

// `decimals`: of milliseconds.
void addRows(Finding& finding, const char* what, const std::vector<double>& seconds, int decimals) {
    for (const double one : seconds) finding.table.rows.push_back({std::string(what), one});
    const Moments moments = computeMoments(seconds);
    finding.comparisons[0].rows.push_back({what, fmt::format("{:.{}f}", 1e3 * moments.median, decimals),
                                           fmt::format("{:.{}f}", 1e3 * moments.minimum, decimals),
                                           fmt::format("{:.{}f}", 1e3 * moments.maximum, decimals)});
    ChartSeries series{.name = what, .colourOf = what, .joined = false};
    for (std::size_t i = 0; i < seconds.size(); ++i)
        series.points.push_back({double(i + 1), 1e3 * seconds[i], {}});
    finding.charts[0].series.push_back(std::move(series));
}

}  // namespace

Result<Finding> benchHorizonEdits(const BenchSite& site, const Extent& extent, const Work& work) {
    work.progress.report(0, "cached horizons");
    const auto year = computeYearSun(site, hoursADay), shorter = computeYearSun(site, fewerHoursADay);
    if (!year || !shorter) return tl::make_unexpected(year ? shorter.error() : year.error());
    CacheTimes times;
    if (const auto done = measure(times, site, extent, *year, *shorter, work); !done)
        return tl::make_unexpected(done.error());
    Finding finding;
    finding.key = "horizon_edits";
    finding.title = "Other hours, and a moved tower";
    finding.text =
        "A year of 8 h days with cached horizons: the full sweep, the hours changed from 8 to 6 a day, and a "
        "tower of 40 x 40 x 200 m in the middle moved by 10 m and back. The field after the first move and "
        "the last equals a fresh one, bit for bit. The first move computes the horizon behind the tower; "
        "later moves reuse it. Moves and changes of hours are measured one after the other, first for gross "
        "shadow alone, then each with the longest runs. Fractions refer to the same count in the full sweep: "
        "gross shadow, which the window shows first, or with the longest runs, which it can show later.";
    finding.table.columns = {"what", "time_s"};
    finding.comparisons[0].header = {"", "median, ms", "least", "most"};
    finding.charts = {{"Time of each run", {.label = "run", .whole = true}, {"time, ms", true}, {}}};
    addRows(finding, "full sweep, gross", times.full.gross, 1);
    addRows(finding, "full sweep, with runs", times.full.both, 1);
    addRows(finding, "other hours, gross", times.retimes.gross, 1);
    addRows(finding, "other hours, with runs", times.retimes.both, 1);
    addRows(finding, "tower moved for the first time, gross", times.firstEdit, 1);
    addRows(finding, "tower moved, gross", times.edits.gross, 1);
    addRows(finding, "tower moved, with runs", times.edits.both, 1);
    const auto fraction = [](const std::vector<double>& part, const std::vector<double>& whole) {
        return computeMoments(part).median / computeMoments(whole).median;
    };
    finding.summary = {{"retime_fraction", fraction(times.retimes.gross, times.full.gross)},
                       {"retime_with_runs_fraction", fraction(times.retimes.both, times.full.both)},
                       {"edit_fraction", fraction(times.edits.gross, times.full.gross)},
                       {"edit_with_runs_fraction", fraction(times.edits.both, times.full.both)},
                       {"edit_ms", 1e3 * computeMoments(times.edits.gross).median},
                       {"edit_first_ms", 1e3 * computeMoments(times.firstEdit).median}};
    return finding;
}

namespace {

struct DayTimes {
    double keepS = 0;
    std::uint64_t bytes = 0;
    std::vector<double> full, edits;  // seconds
};

Result<ShadowField> fullRun(const TowerPlace& place, const SunSteps& day, const Work& work,
                            std::vector<double>& seconds) {
    NoProgress silent;
    const Stopwatch watch;
    auto field = ProjectedShadows().accumulate(place.city, place.receivers, day, silent, work.stop);
    seconds.push_back(watch.seconds());
    return field;
}

Result<void> edit(ShadowCache& kept, const TowerPlace& place, const Work& work,
                  std::vector<double>& seconds) {
    NoProgress silent;
    const Stopwatch watch;
    auto done = kept.change(place.city, place.receivers, silent, work.stop);
    seconds.push_back(watch.seconds());
    return done;
}

Result<void> checkedEdit(ShadowCache& kept, const TowerPlace& place, const SunSteps& day, const Work& work,
                         DayTimes& times) {
    const auto fresh = fullRun(place, day, work, times.full);
    if (!fresh) return tl::make_unexpected(fresh.error());
    if (const auto done = edit(kept, place, work, times.edits); !done) return done;
    if (haveSameMinutes(kept.field(), *fresh)) return {};
    return failure("The edited field differs from a fresh one", "cached shadows");
}

Result<DayTimes> measureDay(const BenchSite& site, const Extent& extent, const SunSteps& day,
                            const Work& work) {
    const auto here = placeTower(site, 0, work), there = placeTower(site, towerMoveM, work);
    if (!here || !there) return tl::make_unexpected(here ? there.error() : here.error());
    DayTimes times;
    NoProgress silent;
    const Stopwatch watch;
    auto kept = ShadowCache::make(here->city, here->receivers, day, silent, work.stop);
    if (!kept) return tl::make_unexpected(kept.error());
    times.keepS = watch.seconds();
    for (int run = 0; run < 2 * extent.runs; ++run)
        if (const auto done = checkedEdit(*kept, run % 2 == 0 ? *there : *here, day, work, times); !done)
            return tl::make_unexpected(done.error());
    times.bytes = kept->bytes();
    return times;
}

}  // namespace

Result<Finding> benchDayEdits(const BenchSite& site, const Extent& extent, const Work& work) {
    work.progress.report(0, "cached shadows");
    const auto day = computeSunOver(site, site.date, 1);
    if (!day) return tl::make_unexpected(day.error());
    const auto times = measureDay(site, extent, *day, work);
    if (!times) return tl::make_unexpected(times.error());
    Finding finding;
    finding.key = "day_edits";
    finding.title = "A tower is moved, one day";
    finding.text = fmt::format(
        "6 h around noon on {} at every minute, gross and continuous: full runs of projected shadows, in "
        "turn with edits that move a tower of 40 x 40 x 200 m in the middle by 10 m and back with cached "
        "shadows. After every move the field equals that of the full run, bit for bit. Making the cache took "
        "{:.3g} s and {:.0f} MB.",
        formatText(site.date), times->keepS, double(times->bytes) * 1e-6);
    finding.table.columns = {"what", "time_s"};
    finding.comparisons[0].header = {"", "median, ms", "least", "most"};
    finding.charts = {{"Time of each run", {.label = "run", .whole = true}, {"time, ms", true}, {}}};
    addRows(finding, "full run", times->full, 2);
    addRows(finding, "tower moved", times->edits, 2);
    const double editS = computeMoments(times->edits).median;
    finding.summary = {{"day_edit_fraction", editS / computeMoments(times->full).median},
                       {"day_edit_ms", 1e3 * editS}};
    return finding;
}

}  // namespace noonmark::bench
