#pragma once

#include <QObject>

#include "app/gui/base/jobs/job.h"
#include "app/gui/view/exploration/view_refinement.h"
#include "app/report/maps/legend_painter.h"
#include "render/scene/surface_layer.h"
#include "render/view/explored_view.h"

namespace noonmark {

Legend makeLegend(const ExploredView& view, ShadowMeasure measure, const LegendChoice& choice = {});

/// Whether the view covers only a part of the period so far.
bool coversPart(const ExploredView& view);

/// `top` minutes get the last colour of the palette. O(samples).
SurfacePicture surfacePicture(const ExploredView& view, ShadowMeasure measure, double top);

/// Describes level of detail and days: "12 of 365 days; a sample every 4 pixels, 1.2 m". `distanceM`:
/// distance to the view's target.
QString describeDetail(const ExploredView& view, double distanceM);

// The explored view: the shadow on all visible surfaces, refined step by step. Exploration runs the jobs,
// view_refinement decides what comes next, ViewTurn how much of it at a time, and surfacePicture() colours
// the answer.

/// Keeps the shadow of the visible surfaces up to date: a coarse picture while the camera moves, finer ones
/// when it rests. Works in jobs; a new view, period or city replaces the work before. While the camera moves,
/// the coarsest picture of a view is always finished once begun, so that there is something to see.
class Exploration final : public QObject {
    Q_OBJECT
public:
    explicit Exploration(QObject* parent = nullptr);

    void setCity(std::shared_ptr<const OpenCity> city);
    void setPeriod(const Period& period,
                   const Observer& observer);  ///< does nothing if both are unchanged
    /// `lens` in device pixels.
    void look(const CameraPose& pose, const ViewLens& lens, const std::optional<SectionBox>& section = {});
    /// Uses shadow accrual maps, as in the paper, or rays, which are exact and on a CPU as fast.
    void setByMaps(bool maps);
    void setActive(bool active);  ///< starts or stops; the last answer stays until something changes

    [[nodiscard]] bool working() const { return slot_.busy(); }
    /// The latest answer, including the partial result of the running job; null: none yet.
    [[nodiscard]] std::shared_ptr<const ViewAnswer> answer() const { return running_ ? running_ : answer_; }

Q_SIGNALS:
    void changed();  ///< a new answer, or none any more
    void failed(noonmark::Error error);

private:
    void makeEngine();
    void ask();     // again, from the coarsest level
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
    bool fresh_ = false;    // the running job computes the coarsest picture of a view
    bool waiting_ = false;  // the view has changed meanwhile
};

}  // namespace noonmark
