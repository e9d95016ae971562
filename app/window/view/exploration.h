#pragma once

#include <QObject>

#include "app/window/study/job_slot.h"
#include "app/window/view/view_refinement.h"

namespace noonmark {

/// Keeps the shadow of what the view shows up to date: a coarse picture while the camera moves, finer ones
/// when it rests. Works beside the window; a newer view, period or city overtakes an older one. While the
/// camera moves, the coarsest picture of each view taken up is finished, so that there is always something to
/// see.
class Exploration final : public QObject {
    Q_OBJECT
public:
    explicit Exploration(QObject* parent = nullptr);

    void setCity(std::shared_ptr<const OpenCity> city);
    void setPeriod(const Period& period,
                   const Observer& observer);                 ///< nothing happens when both are as before
    void look(const CameraPose& pose, const ViewLens& lens);  ///< `lens` in device pixels
    /// By shadow accrual maps, as in the paper, or by rays: exact, and on a processor as fast.
    void setByMaps(bool maps);
    void setActive(bool active);  ///< begins or stops; what was found stays until something changes

    [[nodiscard]] bool working() const { return slot_.busy(); }
    /// With the running result of the work at hand, where there is one; null: none yet.
    [[nodiscard]] std::shared_ptr<const ViewAnswer> answer() const { return running_ ? running_ : answer_; }

Q_SIGNALS:
    void changed();  ///< another answer, or none any more
    void failed(noonmark::Error error);

private:
    void makeEngine();
    void ask();     // anew, from the coarsest level
    void refine();  // one step further
    void take(Result<ViewAnswer> answer);
    void takeRunning(const PartialField& running);
    [[nodiscard]] bool canAsk() const;

    ViewQuestion question_;
    ViewEngine engine_;
    bool byMaps_ = false;
    std::shared_ptr<const ViewAnswer> answer_;
    std::shared_ptr<const ViewAnswer> running_;
    JobSlot slot_;
    bool active_ = false;
    bool fresh_ = false;    // the job at work is the coarsest picture of a view
    bool waiting_ = false;  // the view has moved on since
};

}  // namespace noonmark
