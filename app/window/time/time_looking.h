#pragma once

#include <QObject>
#include <memory>

#include "app/window/study/job_slot.h"
#include "app/window/time/time_look.h"
#include "app/window/view/shared_horizon_cache.h"
#include "core/study/study.h"

namespace noonmark {

/// The shadow of a day or a moment on the receivers of a study.
struct TimeAnswer {
    std::shared_ptr<const Study> study;  ///< whose receivers they are
    TimeLook look;
    ShadowField field;  ///< without longest runs
};

/// Answers looks at a study's city from horizons that stay: the first look sweeps what its suns need, those
/// that follow are a walk through tables, fast enough to follow a slider. One is worked out at a time; of
/// those that come meanwhile the newest is next.
class TimeLooking final : public QObject {
    Q_OBJECT
public:
    explicit TimeLooking(
        std::shared_ptr<SharedHorizonCache> horizons = std::make_shared<SharedHorizonCache>(),
        QObject* parent = nullptr)
        : QObject(parent), horizons_(std::move(horizons)) {}

    void setStudy(std::shared_ptr<const Study> study);  ///< null: none. The look stays and is answered anew
    void look(const TimeLook& look);                    ///< the whole period: there is no answer then

    /// The latest; stays until there is another, also where a later look has none.
    [[nodiscard]] std::shared_ptr<const TimeAnswer> answer() const { return answer_; }
    [[nodiscard]] JobSlot& working() { return slot_; }

Q_SIGNALS:
    void changed();  ///< another answer, or none any more
    void failed(noonmark::TimeLook look, noonmark::Error error);

private:
    static Result<TimeAnswer> answered(TimeAnswer question, SharedHorizonCache& horizons, Progress& progress,
                                       const std::stop_token& stop);
    void ask();
    void take(Result<TimeAnswer> answer);

    std::shared_ptr<SharedHorizonCache> horizons_;
    std::shared_ptr<const Study> study_;
    TimeLook look_;
    TimeLook asked_;  // the last that was worked out, or is
    std::shared_ptr<const TimeAnswer> answer_;
    JobSlot slot_;
};

}  // namespace noonmark
