#pragma once

#include <QByteArray>
#include <QObject>
#include <QString>
#include <QStringList>
#include <memory>
#include <optional>

#include "app/gui/base/jobs/job.h"
#include "core/study/point_cases.h"
#include "core/study/point_study.h"
#include "render/view/scene_picker.h"

namespace noonmark {

/// The question about the surface under the cursor: the ground, a roof (taken as level) or, facing its
/// azimuth, a wall. The day, the clock and the step are left as they are.
PointQuestion questionAt(const City& city, const Pick& pick);

// What the sun and the sky are at a point that the user clicks: PointInspector computes it in a job for the
// displayed scenario, PointDock shows it, SkyPicture draws the skyline, questionAt() says which point it is.

class ViewPanel;
class Workbench;

/// The sun and sky of one point, ready to show.
struct PointAnswer {
    PointStudy study;
    QString sentence;
    QByteArray drawing;    ///< SVG, of skylineSvg()
    std::string from, to;  ///< names of the compared scenarios; the first empty: nothing was compared
    std::vector<PointCaseFigures> cases{};  ///< the existing city and all scenarios, if there are any
};

/// Which scenarios a point is compared in. Empty names: the baseline of the window, or else the existing
/// city, and the displayed scenario.
struct PointComparison {
    std::string from, to;
    bool operator==(const PointComparison&) const = default;
};

/// Measures the point that was clicked last, in two scenarios and, as a table, in all. By default these are
/// the displayed scenario and, if that changes the city, what it is compared with. Again when the city or the
/// day of the time strip changes, while the answer is visible.
class PointInspector final : public QObject {
    Q_OBJECT
public:
    PointInspector(Workbench& workbench, ViewPanel& panel);  ///< both must outlive this object

    void inspect(const Pick& pick);
    void setVisible(bool visible);                ///< whether the answer is; at first it is not
    void forget();                                ///< no point; for another project
    void compare(const PointComparison& chosen);  ///< names that do not exist count as empty
    [[nodiscard]] const PointComparison& comparison() const { return chosen_; }
    [[nodiscard]] QStringList scenarios() const;  ///< that can be compared, the existing city first

    [[nodiscard]] std::shared_ptr<const PointAnswer> answer() const { return answer_; }  ///< null: none yet
    [[nodiscard]] JobSlot& working() { return slot_; }

Q_SIGNALS:
    void asked();             ///< about another point
    void marked();            ///< the pin in the view was placed, moved or removed, or may have been
    void scenariosChanged();  ///< scenarios(), or comparison()
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
    PointComparison chosen_;
    CivilDate day_{};  // of the running or the last question
    bool visible_ = false;
    bool outdated_ = false;  // something changed while the answer was not visible
    std::shared_ptr<const PointAnswer> answer_;
    JobSlot slot_;
};

}  // namespace noonmark
