#pragma once

#include <QObject>

#include "app/gui/view/time/sun_dome.h"

class QAction;
class QSettings;
class QTimer;

namespace noonmark {

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
