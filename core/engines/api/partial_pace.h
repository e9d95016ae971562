#pragma once

namespace noonmark {

/// Decides when the next running result is due. Engines check only now and then, so a result may be late; a
/// late one does not delay those after it. An engine that checks at least every `usualS` delivers one result
/// per `usualS` on average.
class PartialPace {
public:
    static constexpr double usualS = 0.18;  ///< five per second with a small margin

    /// `nowS`: seconds on any monotonic clock.
    [[nodiscard]] bool due(double nowS) const { return nowS >= nextS_; }

    /// A result was taken at that time. After a pause longer than `usualS`, or a result that was not due, the
    /// schedule restarts at `nowS`.
    void taken(double nowS) {
        const double lateS = nowS - nextS_;
        nextS_ = (lateS >= 0 && lateS < usualS ? nextS_ : nowS) + usualS;
    }

private:
    double nextS_ = 0;
};

}  // namespace noonmark
