#include "core/bench/horizon/day_edits.h"

#include <fmt/format.h>

#include "core/base/stopwatch.h"
#include "core/bench/contests/moments.h"
#include "core/bench/horizon/moved_tower.h"
#include "core/engines/projected/projected_shadows.h"
#include "core/engines/projected/shadow_cache.h"

namespace noonmark::bench {

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

void addRows(Finding& finding, const char* what, const std::vector<double>& seconds) {
    for (const double one : seconds) finding.table.rows.push_back({std::string(what), one});
    const Moments moments = computeMoments(seconds);
    finding.comparisons[0].rows.push_back({what, fmt::format("{:.2f}", 1e3 * moments.median),
                                           fmt::format("{:.2f}", 1e3 * moments.least),
                                           fmt::format("{:.2f}", 1e3 * moments.most)});
    ChartSeries series{.name = what, .colourOf = what, .joined = false};
    for (std::size_t i = 0; i < seconds.size(); ++i)
        series.points.push_back({double(i + 1), 1e3 * seconds[i], {}});
    finding.charts[0].series.push_back(std::move(series));
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
    addRows(finding, "full run", times->full);
    addRows(finding, "tower moved", times->edits);
    const double editS = computeMoments(times->edits).median;
    finding.summary = {{"day_edit_fraction", editS / computeMoments(times->full).median},
                       {"day_edit_ms", 1e3 * editS}};
    return finding;
}

}  // namespace noonmark::bench
