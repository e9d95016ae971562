#pragma once

namespace noonmark {

/// When the next running result is due. One that comes late, since the work looks up only now and then, does
/// not put off those after it: work that looks up at least so often shows one every `usualS` at the mean.
class PartialPace {
public:
    static constexpr double usualS = 0.18;  ///< five a second, and a little room

    /// `nowS` by any clock that never goes back, seconds.
    [[nodiscard]] bool due(double nowS) const { return nowS >= nextS_; }

    /// One was taken at that time. After a longer pause, or one that came unasked, the pace begins anew.
    void taken(double nowS) {
        const double lateS = nowS - nextS_;
        nextS_ = (lateS >= 0 && lateS < usualS ? nextS_ : nowS) + usualS;
    }

private:
    double nextS_ = 0;
};

}  // namespace noonmark
