#pragma once

#include <QObject>
#include <QString>
#include <memory>

#include "app/gui/base/jobs/job.h"
#include "app/gui/session/study/shared_horizon_cache.h"
#include "core/study/study.h"
#include "core/sun/period.h"

namespace noonmark {

/// Which part of a study's period is displayed.
enum class ShownSpan {
    period,  ///< all of it
    day,     ///< its hours on one day
    moment,  ///< one moment of one day
};

/// A part of time displayed instead of the whole period of a study.
struct ShownTime {
    ShownSpan span = ShownSpan::period;
    CivilDate date{std::chrono::year{2026}, std::chrono::March, std::chrono::day{21}};
    std::chrono::minutes at{12 * 60};  ///< wall clock, 0 to 24 h; used for a moment only
    bool operator==(const ShownTime&) const = default;
};

/// The period of a shown time. Time zone, air, step and hours are those of the study.
Period periodOf(const ShownTime& look, const Period& study);

/// What is shown first of a period: its first day, at noon or the middle of its hours.
ShownTime firstShownTime(const Period& study);

/// "21 March 2026", "21 March 2026, 14:35"; empty for the whole period.
QString describe(const ShownTime& look);

/// The shadow of a day or moment on the receivers of a study.
struct TimeAnswer {
    std::shared_ptr<const Study> study;  ///< the study with the receivers
    ShownTime look;
    ShadowField field;  ///< without continuous shadow
};

/// Computes the shadow of shown times from cached horizons. The first sweeps the horizons for its sun
/// positions; later ones are table look-ups, fast enough to follow a slider. One is computed at a time;
/// of those that arrive meanwhile the newest is next.
class MomentPreview final : public QObject {
    Q_OBJECT
public:
    explicit MomentPreview(
        std::shared_ptr<SharedHorizonCache> horizons = std::make_shared<SharedHorizonCache>(),
        QObject* parent = nullptr)
        : QObject(parent), horizons_(std::move(horizons)) {}

    /// Null: none. The shown time stays and is computed again.
    void setStudy(std::shared_ptr<const Study> study);
    void look(const ShownTime& look);  ///< for the whole period there is no answer

    /// The latest answer; it stays until the next one, also if a later time has none.
    [[nodiscard]] std::shared_ptr<const TimeAnswer> answer() const { return answer_; }
    [[nodiscard]] JobSlot& working() { return slot_; }

Q_SIGNALS:
    void changed();  ///< a new answer, or none any more
    void failed(noonmark::ShownTime look, noonmark::Error error);

private:
    static Result<TimeAnswer> answered(TimeAnswer question, SharedHorizonCache& horizons, Progress& progress,
                                       const std::stop_token& stop);
    void ask();
    void take(Result<TimeAnswer> answer);

    std::shared_ptr<SharedHorizonCache> horizons_;
    std::shared_ptr<const Study> study_;
    ShownTime look_;
    ShownTime computed_;  // the last one computed or being computed
    std::shared_ptr<const TimeAnswer> answer_;
    JobSlot slot_;
};

}  // namespace noonmark
