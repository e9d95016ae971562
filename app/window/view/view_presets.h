#pragma once

#include <QObject>

#include "render/view/camera_pose.h"

class QAction;

namespace noonmark {

class TimeDisplay;
class ViewPanel;
struct SunAtMoment;

/// The same ground from a side, nearly level, as an elevation shows it. `fromDeg`: azimuth of the side on
/// which the camera stands, clockwise from true north.
CameraPose lookFromSide(CameraPose pose, double fromDeg);

/// The same ground from the direction of the sun: what is visible is sunlit. From above the horizon only.
CameraPose lookFromSun(CameraPose pose, const SunAtMoment& sun);

/// Camera positions with a key each: from south, east, north and west, and from the sun of the time strip.
class ViewPresets final : public QObject {
    Q_OBJECT
public:
    ViewPresets(ViewPanel& panel, const TimeDisplay& time);  ///< both must outlive it

    [[nodiscard]] const QList<QAction*>& actions() const { return actions_; }

private:
    void addSide(const QString& text, const QKeySequence& keys, double fromDeg);
    void showSunsView();
    void go(const CameraPose& pose);

    ViewPanel& panel_;
    const TimeDisplay& time_;
    QList<QAction*> actions_;
};

}  // namespace noonmark
