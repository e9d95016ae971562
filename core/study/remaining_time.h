#pragma once

#include <string>

#include "core/base/progress.h"
#include "core/base/stopwatch.h"

namespace noonmark {

/// "about 14 min left", "about 20 s left"; in steps that do not flicker.
std::string remainingWords(double seconds);

/// Progress of work in pieces of known sizes. Each piece reports its own part as if it were alone; the sink
/// hears the share of the whole and the time left, reckoned from the pace of the pieces done so far here.
class PiecewiseProgress final : public Progress {
public:
    /// `whole`: the sum of all sizes; `before`: what earlier runs have done of it.
    PiecewiseProgress(Progress& progress, double whole, double before)
        : progress_(progress), whole_(whole), before_(before) {}

    /// "tile 12 of 96"; not while a piece is at work.
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
