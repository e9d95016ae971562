#pragma once

// What the sun and the sky are at a point that the user clicks: PointInspector computes it in a job for the
// displayed scenario, PointDock shows it, SkyPicture draws the skyline, picked_point says which point it is.

#include <QByteArray>
#include <QObject>
#include <QString>
#include <memory>
#include <optional>

#include "app/window/study/job_slot.h"
#include "core/study/point_study.h"
#include "render/view/scene_picker.h"

namespace noonmark {

class ViewPanel;
class Workbench;

/// The sun and sky of one point, ready to show.
struct PointAnswer {
    PointStudy study;
    QString sentence;
    QByteArray drawing;  ///< SVG, of skylineSvg()
};

/// Measures the point that was clicked last, of the displayed scenario and, if that changes the city, of what
/// it is compared with. Again when the city or the day of the time strip changes, while the answer is
/// visible.
class PointInspector final : public QObject {
    Q_OBJECT
public:
    PointInspector(Workbench& workbench, ViewPanel& panel);  ///< both must outlive this object

    void inspect(const Pick& pick);
    void setVisible(bool visible);  ///< whether the answer is; at first it is not
    void forget();                  ///< no point; for another project

    [[nodiscard]] std::shared_ptr<const PointAnswer> answer() const { return answer_; }  ///< null: none yet
    [[nodiscard]] JobSlot& working() { return slot_; }

Q_SIGNALS:
    void asked();  ///< about another point
    void changed();
    void failed(noonmark::Error error);  ///< the answer is null then

private:
    void mark();  ///< in the view, while the answer is visible
    void follow();
    void ask();
    void take(Result<PointAnswer> answer);

    Workbench& workbench_;
    ViewPanel& panel_;
    std::optional<Pick> pick_;
    CivilDate day_{};  // of the running or the last question
    bool visible_ = false;
    bool outdated_ = false;  // something changed while the answer was not visible
    std::shared_ptr<const PointAnswer> answer_;
    JobSlot slot_;
};

}  // namespace noonmark
