#pragma once

#include <QObject>
#include <glm/vec3.hpp>
#include <optional>

#include "app/gui/session/project/view_mode.h"
#include "render/view/camera_pose.h"

class QAction;
class QActionGroup;

namespace noonmark {

/// The pose that looks at a place from in front of its wall, from at most 80 m. `azimuthDeg`: that the wall
/// faces, from true north; none: the direction of the view stays.
CameraPose faceWall(CameraPose pose, glm::dvec3 place, std::optional<double> azimuthDeg);

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

/// The three modes as an exclusive action group. Knows no view.
class ModeSwitch final : public QObject {
    Q_OBJECT
public:
    explicit ModeSwitch(QObject* parent = nullptr);

    [[nodiscard]] ViewMode mode() const { return mode_; }
    void setMode(ViewMode mode);
    void showStudies();  ///< leaves exploration, which shows no study

    [[nodiscard]] QList<QAction*> actions() const;

Q_SIGNALS:
    void changed(noonmark::ViewMode mode);

private:
    void makeAction(ViewMode mode, const QKeySequence& keys);

    QActionGroup* group_;
    ViewMode mode_ = ViewMode::exploration;
};

}  // namespace noonmark
