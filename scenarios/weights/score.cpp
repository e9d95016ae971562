#include "scenarios/weights/score.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>

#include "core/progress_share.h"
#include "core/receivers/rasterize.h"
#include "core/study/memory_need.h"
#include "scenarios/weights/time_pieces.h"

namespace noonmark {

namespace {

// Sunlit minutes of every interval, in the table's order.
std::vector<double> sunlitOf(const std::vector<TimePiece>& pieces, std::size_t intervals) {
    std::vector<double> minutes(intervals, 0);
    for (const TimePiece& piece : pieces)
        if (piece.interval) minutes[*piece.interval] += piece.sun.sunlitMinutes();
    return minutes;
}

MonthFigures& figuresFor(std::vector<MonthFigures>& months, std::chrono::year_month month) {
    const auto found = std::ranges::find(months, month, &MonthFigures::month);
    if (found != months.end()) return *found;
    return months.emplace_back(MonthFigures{.month = month});
}

// Adds fields of pieces up to a score. Until finish() the months' shadow areas are cell-minutes x m2.
class ScoreSum {
public:
    ScoreSum(const Receivers& receivers, const TimeWeights& weights, std::vector<double> sunlit)
        : receivers_(receivers),
          weights_(weights),
          sunlit_(std::move(sunlit)),
          sum_(receivers.grid.size(), 0) {
        for (const WeightedInterval& interval : weights.intervals)
            score_.intervals.push_back({interval.name, interval.weight});
    }

    void add(const TimePiece& piece, const ShadowField& field) {
        const double days = double(piece.sun.dayCount());
        const double cellM2 = receivers_.grid.cellAreaM2();
        const double perMinute = piece.interval ? 1 / sunlit_[*piece.interval] : 0;
        const double weight = piece.interval ? weights_.intervals[*piece.interval].weight : 0;
        double minutes = 0;
        for (const std::uint32_t cell : receivers_.cells) {
            const double shaded = double(field.grossMin[cell]) * days;
            minutes += shaded;
            sum_[cell] += weight * shaded * perMinute;
        }
        MonthFigures& month = figuresFor(score_.months, piece.month);
        month.sunlitMinutes += piece.sun.sunlitMinutes();
        month.shadowAreaM2 += minutes * cellM2;
        month.scoreM2 += weight * minutes * perMinute * cellM2;
        if (piece.interval) score_.intervals[*piece.interval].shadowAreaM2 += minutes * perMinute * cellM2;
        score_.engine = field.engine;
        if (score_.warnings.empty()) score_.warnings = field.warnings;
    }

    Score finish() && {
        score_.grid = receivers_.grid;
        score_.score.assign(sum_.size(), std::numeric_limits<float>::quiet_NaN());
        for (const std::uint32_t cell : receivers_.cells) {
            score_.score[cell] = float(sum_[cell]);
            score_.scoreM2 += sum_[cell] * receivers_.grid.cellAreaM2();
        }
        score_.receiverAreaM2 = double(receivers_.cells.size()) * receivers_.grid.cellAreaM2();
        for (MonthFigures& month : score_.months) month.shadowAreaM2 /= month.sunlitMinutes;
        for (IntervalFigures& interval : score_.intervals)
            interval.scoreM2 = interval.weight * interval.shadowAreaM2;
        std::ranges::sort(score_.months, {}, &MonthFigures::month);
        return std::move(score_);
    }

private:
    const Receivers& receivers_;
    const TimeWeights& weights_;
    std::vector<double> sunlit_;
    std::vector<double> sum_;
    Score score_;
};

}  // namespace

Result<Score> scoreOf(const City& city, const Receivers& receivers, const SunSteps& sun, const Zone& zone,
                      const TimeWeights& weights, const Accumulator& engine, Progress& progress,
                      const std::stop_token& stop) {
    if (const auto sound = checked(weights); !sound) return tl::make_unexpected(sound.error());
    const std::vector<TimePiece> pieces = piecesOf(sun, zone, weights);
    ScoreSum sum(receivers, weights, sunlitOf(pieces, weights.intervals.size()));
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        ProgressShare share(progress, i, pieces.size());
        const auto field = engine.accumulate(city, receivers, pieces[i].sun, share, stop);
        if (!field) return tl::make_unexpected(field.error());
        sum.add(pieces[i], *field);
    }
    return std::move(sum).finish();
}

Result<Score> runScore(const City& city, const StudySettings& settings, const TimeWeights& weights,
                       Progress& progress, const std::stop_token& stop, const EngineList& engines) try {
    const auto engine = makeAccumulator(settings.engine, settings.engineSettings, engines);
    if (!engine) return tl::make_unexpected(engine.error());
    const auto zone = Zone::named(settings.period.zone);
    if (!zone) return tl::make_unexpected(zone.error());
    if (auto fits = checkMemory(city, settings, engines); !fits) return tl::make_unexpected(fits.error());
    const auto receivers = receiversOnGround(city, settings.region, settings.receivers, stop);
    if (!receivers) return tl::make_unexpected(receivers.error());
    if (receivers->cells.empty())
        return failure("No cell of the region lies on open ground", settings.region.name,
                       "Choose a region outside the buildings, or smaller cells");
    const auto sun = checked(settings.period).and_then([&](const Period& period) {
        return sunSteps(period, observerOf(Study{.city = city, .settings = settings}), stop);
    });
    if (!sun) return tl::make_unexpected(sun.error());
    if (sun->steps.empty())
        return failure("The sun is below the horizon all the time", textOf(settings.period),
                       "Choose other hours or days");
    return scoreOf(city, *receivers, *sun, *zone, weights, **engine, progress, stop);
} catch (const std::bad_alloc&) {
    return failure("There is not enough memory for this score", "",
                   "Choose larger cells, a smaller region or fewer steps");
}

double scoreIn(const Score& score, const Region& region) {
    double sum = 0;
    for (const Footprint& polygon : region.polygons)
        forEachRun(polygon, score.grid, [&](int row, int first, int end) {
            for (int column = first; column < end; ++column) {
                const double value = double(score.score[score.grid.index(column, row)]);
                if (!std::isnan(value)) sum += value * score.grid.cellAreaM2();
            }
        });
    return sum;
}

}  // namespace noonmark
