#pragma once

#include <QObject>

#include "render/view/camera_pose.h"

class QAction;

namespace noonmark {

class TimeDisplay;
class ViewPanel;
struct SunAtMoment;

/// The same ground from a side: in perspective nearly level, over the roofs in front; in a parallel
/// projection an elevation, level, with the ground in the lower part of the picture. `fromDeg`: azimuth of
/// the side on which the camera stands, clockwise from true north.
CameraPose lookFromSide(CameraPose pose, double fromDeg);

/// The same ground from the direction of the sun: what is visible is sunlit. From above the horizon only.
CameraPose lookFromSun(CameraPose pose, const SunAtMoment& sun);

/// The projection, and camera positions with a key each: plan, from south, east, north and west, and from the
/// sun of the time strip.
class ViewPresets final : public QObject {
    Q_OBJECT
public:
    ViewPresets(ViewPanel& panel, const TimeDisplay& time);  ///< both must outlive it

    [[nodiscard]] QAction* parallel() const { return parallel_; }  ///< checkable
    [[nodiscard]] const QList<QAction*>& actions() const { return actions_; }

private:
    void addSide(const QString& text, const QKeySequence& keys, double fromDeg);
    void showPlan();
    void showSunsView();

    ViewPanel& panel_;
    const TimeDisplay& time_;
    QAction* parallel_;
    QList<QAction*> actions_;
};

}  // namespace noonmark
