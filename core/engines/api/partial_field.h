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

}  // namespace noonmark
