#pragma once

namespace noonmark {

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
