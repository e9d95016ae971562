#pragma once

#include <string>

#include "core/base/progress.h"
#include "core/base/stopwatch.h"

namespace noonmark {

/// "about 2 s", "about 14 min", "about 3.5 h"
std::string describeDuration(double seconds);

/// "about 14 min left", "about 20 s left"; rounded so that the text does not flicker.
std::string describeRemaining(double seconds);

/// Progress of work in pieces of known sizes. Each piece reports its own fraction; `progress` receives the
/// fraction of the whole and the remaining time, estimated from the speed of the pieces done so far in this
/// run.
class PiecewiseProgress final : public Progress {
public:
    /// `whole`: the sum of all sizes; `before`: the part that earlier runs have done.
    PiecewiseProgress(Progress& progress, double whole, double before)
        : progress_(progress), whole_(whole), before_(before) {}

    /// `name`: "tile 12 of 96". Call only between pieces.
    void begin(std::string name, double size);
    void end();

    void report(double fraction, std::string_view stage) override;

private:
    Progress& progress_;
    double whole_;
    double before_;
    double done_ = 0;
    double size_ = 0;
    std::string name_;
    Stopwatch watch_;
};

}  // namespace noonmark
