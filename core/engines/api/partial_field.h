#pragma once

#include <string>

#include "core/base/progress.h"
#include "core/engines/api/shadow_field.h"

namespace noonmark {

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
