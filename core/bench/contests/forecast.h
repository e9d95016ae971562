#pragma once

#include "core/base/progress.h"
#include "core/base/stopwatch.h"
#include "core/bench/contests/deadline.h"

namespace noonmark::bench {

/// Whether work that has done so much of itself (0 to 1) will by far not end in time: a fifth longer than the
/// limit, seen once a quarter of it has passed. Work that reports nothing is let go on.
constexpr bool isHopeless(double elapsedS, double fraction, double limitS) {
    return elapsedS > limitS / 4 && fraction > 0 && elapsedS > fraction * 1.2 * limitS;
}

/// Ends work before its deadline where it is hopeless.
class Forecast final : public Progress {
public:
    /// The deadline outlives it.
    Forecast(Deadline& deadline, double limitS) : deadline_(deadline), limitS_(limitS) {}

    void report(double fraction, std::string_view) override {
        if (isHopeless(watch_.seconds(), fraction, limitS_)) deadline_.giveUp();
    }

private:
    Deadline& deadline_;
    double limitS_;
    Stopwatch watch_;
};

}  // namespace noonmark::bench
