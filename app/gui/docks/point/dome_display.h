#pragma once

#include <QObject>

#include "core/sun/sun_paths.h"
#include "render/scene/dome_marks.h"

class QAction;
class QSettings;
class QTimer;

namespace noonmark {

/// Where a sun path dome stands.
struct DomePlace {
    glm::dvec3 centre{0};  ///< local metres
    double radiusM = 1;    ///< > 0
    bool operator==(const DomePlace&) const = default;
};

/// A dome that fits the view of a camera, also in a narrow one: around `centre`, or else the ground under the
/// camera's target (`groundM`: local z), slightly above it. Turning the camera around its target changes
/// nothing.
DomePlace placeDome(const CameraPose& pose, const ViewLens& lens, double groundM,
                    const std::optional<glm::dvec3>& centre);

/// How badly a dome that stands at `shown` represents one at `wanted`.
enum class DomeMismatch { none, small, large };
DomeMismatch compareDomes(const DomePlace& shown, const DomePlace& wanted);

/// The lines and names of a dome: paths, hours, the horizon with the quarters of the sky. January to June are
/// named where the sun rises, July to December where it sets, hours where they are highest.
/// `frameFromPlace`: of the observer of the paths.
DomeMarks::Net drawDome(const SunPaths& paths, const glm::dmat3& frameFromPlace, const DomePlace& place);

/// The path of a day and, if `towardsSun` (a unit vector) is above the horizon, the sun with a line to the
/// centre.
DomeMarks::Sun drawDomeSun(const std::vector<SunCurve>& path, const glm::dvec3& towardsSun,
                           const DomePlace& place);

class PointInspector;
class TimeDisplay;
class ViewPanel;
class Workbench;

/// The sun path dome in the view, around the pin of the dock Point or else what the camera looks at. It
/// follows the camera when that rests or has moved far; turning around the target redraws nothing. Its hours
/// are those of the clock on the date of the time strip. The switch is remembered in the settings.
class DomeDisplay final : public QObject {
    Q_OBJECT
public:
    /// All must outlive this object.
    DomeDisplay(QSettings& settings, Workbench& workbench, ViewPanel& panel, const TimeDisplay& time,
                const PointInspector& point);

    [[nodiscard]] QAction* action() const { return action_; }  ///< checkable: shows the dome
    /// Where it stands; empty while it is not shown.
    [[nodiscard]] const std::optional<DomePlace>& place() const { return place_; }

private:
    void setShown(bool shown);
    void followSun();     ///< another sun, date, place or study
    void followCamera();  ///< the pose, or the pin
    void settle();        ///< stands exactly where the camera wants it
    void draw();
    void drawSun();
    [[nodiscard]] DomePlace wantedPlace() const;
    [[nodiscard]] Result<SunPathQuestion> question() const;

    QSettings& settings_;
    Workbench& workbench_;
    ViewPanel& panel_;
    const TimeDisplay& time_;
    QAction* action_;
    QTimer* rest_;
    std::optional<DomePlace> place_;
    std::optional<SunPathQuestion> asked_;  // what paths_ answer
    SunPaths paths_;
};

}  // namespace noonmark
