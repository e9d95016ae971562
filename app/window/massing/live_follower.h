#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <memory>
#include <optional>

#include "app/window/massing/live_shadow.h"
#include "app/window/study/job_slot.h"

namespace noonmark {

/// Follows a shape with its shadow, beside the window: one shape is worked out at a time, and of those that
/// come meanwhile the newest is next. Gross shadow while the shape moves; the longest runs, where they cost
/// more, when it rests.
class LiveFollower final : public QObject {
    Q_OBJECT
public:
    explicit LiveFollower(std::shared_ptr<SharedHorizonCache> horizons, QObject* parent = nullptr);

    void begin(LivePlace place, const LiveQuestion& question);  ///< what was before ends unheard
    void follow(const LiveReceivers::Shape& shape);             ///< does nothing before begin()
    void end();

    /// The latest since begin(); null: none yet.
    [[nodiscard]] std::shared_ptr<const LiveAnswer> answer() const { return answer_; }
    /// How long a newer shape than that of the answer is known, seconds; 0: there is none.
    [[nodiscard]] double ageSeconds() const;
    [[nodiscard]] JobSlot& working() { return slot_; }

Q_SIGNALS:
    void changed();  ///< another answer
    void aged();     ///< the answer is of a shape before the newest; some times a second while it is
    void failed(noonmark::Error error);  ///< or cancelled: nothing follows any more until begin()

private:
    struct Start {
        LivePlace place;
        LiveQuestion question;
    };
    struct Followed {
        std::shared_ptr<LiveShadow> live;
        LiveAnswer answer;
    };
    void ask(ShadowCounts counts);
    void take(Result<Followed> followed);
    void rested();

    std::shared_ptr<SharedHorizonCache> horizons_;
    std::shared_ptr<const Start> start_;  // null: nothing to follow
    std::shared_ptr<LiveShadow> live_;    // null before the first answer
    std::shared_ptr<const LiveAnswer> answer_;
    LiveReceivers::Shape shape_;
    ShadowCounts asked_ = ShadowCounts::gross;  // of the job at work
    QElapsedTimer newerThanAsked_;              // invalid: nothing newer
    QElapsedTimer newerThanShown_;
    QTimer rest_;
    QTimer age_;
    JobSlot slot_;
};

}  // namespace noonmark
