#pragma once

// The live shadow: what an edit shades, while it is dragged. LiveFollower runs one computation at a time for
// the newest shape; LiveShadow computes it, with the receivers of live_receivers and the engine that
// live_rule chooses. LiveFacades does the same for the sunlight of facades, which facade_sunlight measures.
// SharedHorizonCache holds the horizons that the time sliders use too.

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <memory>
#include <optional>

#include "app/gui/base/jobs/job.h"
#include "app/gui/tools/live/live_shadow.h"

namespace noonmark {

/// Keeps the shadow of a shape up to date while the user edits it. One shape is computed at a time, in a job;
/// when it is ready, the newest of the shapes that arrived meanwhile is next. While the shape moves only
/// gross shadow is computed; continuous shadow, where it costs more, when the shape rests.
class LiveFollower final : public QObject {
    Q_OBJECT
public:
    explicit LiveFollower(std::shared_ptr<SharedHorizonCache> horizons, QObject* parent = nullptr);

    void begin(LivePlace place, const LiveQuestion& question);  ///< cancels the work before
    void follow(const LiveReceivers::Shape& shape);             ///< does nothing before begin()
    void end();

    /// The latest answer since begin(); null if there is none yet.
    [[nodiscard]] std::shared_ptr<const LiveAnswer> answer() const { return answer_; }
    /// How long a shape newer than the answer's has been known, seconds; 0 if there is none.
    [[nodiscard]] double ageSeconds() const;
    [[nodiscard]] JobSlot& working() { return slot_; }

Q_SIGNALS:
    void changed();  ///< a new answer
    /// The answer is of an older shape than the newest; emitted several times a second while it is.
    void aged();
    /// Also if cancelled. Nothing is computed until the next begin().
    void failed(noonmark::Error error);

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
    std::shared_ptr<const Start> start_;  // null: not active
    std::shared_ptr<LiveShadow> live_;    // null before the first answer
    std::shared_ptr<const LiveAnswer> answer_;
    LiveReceivers::Shape shape_;
    ShadowCounts asked_ = ShadowCounts::gross;  // of the running job
    QElapsedTimer newerThanAsked_;              // invalid: no newer shape
    QElapsedTimer newerThanShown_;
    QTimer rest_;
    QTimer age_;
    JobSlot slot_;
};

}  // namespace noonmark
