#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/warnings.h"
#include "core/geo/grid.h"
#include "core/receivers/receivers.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// Which quantities are computed for a period. The longest runs cost about as much as everything else
/// together.
enum class ShadowCounts {
    gross,  ///< continuousMin is NaN everywhere
    grossAndRuns,
};

/// The cost of a computation and the work it could skip. Part of every result.
struct Cost {
    std::map<std::string, double> seconds;         ///< by stage ("build", "trace"); stages do not overlap
    std::uint64_t rays = 0;                        ///< occlusion tests, for engines that trace rays
    std::uint32_t buildingsUsed = 0;               ///< buildings whose shadow can reach a receiver
    std::map<std::string, std::uint64_t> skipped;  ///< skipped work by reason, in words
};

struct TreeShade;  // tree_shade.h

/// Shadow on a grid for one period. Cells that are not receivers hold NaN.
struct ShadowField {
    Grid grid;
    std::vector<float> grossMin;       ///< minutes in shadow per day, mean over the period's days; grid order
    std::vector<float> continuousMin;  ///< longest unbroken run on any day, minutes; grid order
    double sunlitMinutesPerDay = 0;    ///< mean minutes per day with the sun up; 100 % of the time
    double stepMinutes = 1;
    int days = 1;

    std::string engine;     ///< name and settings in words, for the report
    std::string engineKey;  ///< key of the engine that computed the field ("ray"); set by engines that
                            ///< delegate to another one
    Warnings warnings;
    Cost cost;
    std::shared_ptr<const TreeShade> trees;  ///< the same with trees; null: none reaches a receiver
};

/// Keys of Cost::skipped that every result has; the last only where there are such cells.
inline constexpr const char* cellsUnderBuildings = "cells under buildings";
inline constexpr const char* cellsOutside = "cells outside the region";
inline constexpr const char* cellsOnWater = "cells on water";

/// Square metres of the cells that were left out as water (WaterCells).
double findWaterM2(const Cost& cost, const Grid& grid);
inline double findWaterM2(const ShadowField& field) { return findWaterM2(field.cost, field.grid); }

/// Counts in Cost::skipped the cells that are no receivers, by what they are.
void countSkippedCells(Cost& cost, const Receivers& receivers);

/// The field that every engine starts from: the receivers' grid, 0 minutes at receivers and NaN elsewhere,
/// the period's day count, sunlit minutes and step length, and in Cost::skipped the cells and steps that no
/// engine has to process.
ShadowField makeBlankField(const Receivers& receivers, const SunSteps& sun);

/// Sets everything makeBlankField() sets except the minutes. For reusing a field of the same receivers for
/// another period.
void setPeriod(ShadowField& field, const Receivers& receivers, const SunSteps& sun);

/// A running result of an accumulation: not an estimate, but the exact result for the part that is finished.
struct PartialField {
    /// Cells without a result yet hold NaN. If only part of the period is finished, grossMin and
    /// sunlitMinutesPerDay count the minutes of that part, averaged over all days of the period, so their
    /// ratio is the share of the finished time that lies in shadow; continuousMin is the longest run within
    /// the finished days.
    ShadowField field;
    double share = 0;          ///< finished share of the whole, 0 to 1
    std::string part;          ///< the finished part in words: "112 of 299 sun intervals", "40 of 96 tiles"
    bool wholePeriod = false;  ///< the unfinished part is filled from results known around each cell
};

/// Receives running results. A Progress that displays them derives from this class too; engines find it with
/// findPartialSink().
class PartialSink {
public:
    virtual ~PartialSink() = default;

    /// Whether a running result would be displayed now. Cheap; called often, from any thread.
    [[nodiscard]] virtual bool wants() const = 0;

    /// Called from any thread, by one thread at a time.
    virtual void take(PartialField partial) = 0;
};

/// The sink that displays running results of the work with this progress; null if there is none.
[[nodiscard]] inline PartialSink* findPartialSink(Progress& progress) {
    return dynamic_cast<PartialSink*>(&progress);
}

/// Decides when the next running result is due. Engines check only now and then, so a result may be late; a
/// late one does not delay those after it. An engine that checks at least every `defaultS` delivers one
/// result per `defaultS` on average.
class PartialPace {
public:
    static constexpr double defaultS = 0.18;  ///< five per second with a small margin

    /// `nowS`: seconds on any monotonic clock.
    [[nodiscard]] bool due(double nowS) const { return nowS >= nextS_; }

    /// A result was taken at that time. After a pause longer than `defaultS`, or a result that was not due,
    /// the schedule restarts at `nowS`.
    void taken(double nowS) {
        const double lateS = nowS - nextS_;
        nextS_ = (lateS >= 0 && lateS < defaultS ? nextS_ : nowS) + defaultS;
    }

private:
    double nextS_ = 0;
};

}  // namespace noonmark
