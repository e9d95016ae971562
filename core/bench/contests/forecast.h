#pragma once

#include "core/base/progress.h"
#include "core/base/stopwatch.h"
#include "core/bench/contests/deadline.h"

namespace noonmark::bench {

/// Whether work that has done `fraction` of itself (0 to 1) will clearly miss its limit: by a fifth, judged
/// once a quarter of the limit has passed. Work that reports no progress is never hopeless.
constexpr bool isHopeless(double elapsedS, double fraction, double limitS) {
    return elapsedS > limitS / 4 && fraction > 0 && elapsedS > fraction * 1.2 * limitS;
}

/// Stops work before its deadline if it is hopeless.
class Forecast final : public Progress {
public:
    /// `deadline` must outlive this object.
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
