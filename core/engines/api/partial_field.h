#pragma once

#include <string>

#include "core/engines/api/shadow_field.h"

namespace noonmark {

/// What an accumulation knows while it runs: no estimate, but the true result for the part that is done.
struct PartialField {
    /// NaN in cells of which nothing is known yet. Where only part of the period is done, grossMin and
    /// sunlitMinutesPerDay count the minutes of that part over all days of the period, so that their ratio is
    /// the share of the time done that lies in shadow; continuousMin is the longest run of the days done.
    ShadowField field;
    double share = 0;          ///< of the whole, 0 to 1
    std::string part;          ///< in words: "112 of 299 sun intervals", "40 of 96 tiles"
    bool wholePeriod = false;  ///< the rest of the period is as it was known around each cell
};

/// Who wants to see running results. An engine finds it at Progress::partials().
class PartialSink {
public:
    virtual ~PartialSink() = default;

    /// Whether another one would be shown by now. Cheap; asked often, from any thread.
    [[nodiscard]] virtual bool wants() const = 0;

    /// From any thread, one at a time.
    virtual void take(PartialField partial) = 0;
};

}  // namespace noonmark
