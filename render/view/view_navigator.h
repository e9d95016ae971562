#pragma once

#include <QObject>
#include <QPointF>
#include <vector>

#include "render/view/camera_control.h"
#include "render/view/city_view.h"
#include "render/view/scene_picker.h"

class QKeyEvent;
class QMouseEvent;
class QWheelEvent;

namespace noonmark {

/// Something in the view that a left-button drag can grab instead of the camera.
class DragTarget {
public:
    virtual ~DragTarget() = default;
    virtual bool grab(QPointF pixel) = 0;  ///< true: grabbed; the target receives the rest of the drag
    virtual void dragTo(QPointF pixel) = 0;
    virtual void drop() = 0;
};

/// Mouse and keyboard control of a CityView. Left or middle drag rotates, right drag (or shift) moves, a drag
/// with Ctrl asks for the sun to be turned, the wheel zooms at the cursor; arrow keys move, + and - zoom,
/// Home shows the whole city, N turns north up, T looks from above. The eye never goes below the ground.
class ViewNavigator final : public QObject {
    Q_OBJECT
public:
    explicit ViewNavigator(CityView& view);  ///< child of `view`

    void setScene(ScenePicker scene) { scene_ = std::move(scene); }
    [[nodiscard]] const ScenePicker& scene() const { return scene_; }

    /// Targets are tried in this order when a drag starts. A target outlives the navigator or removes itself.
    void addTarget(DragTarget& target) { targets_.push_back(&target); }
    void removeTarget(DragTarget& target);

    /// The object under a pixel of the view; device-independent pixels from the top left corner.
    [[nodiscard]] std::optional<Pick> pickAt(QPointF pixel) const;
    [[nodiscard]] std::optional<glm::dvec3> groundAt(QPointF pixel) const;

    /// Shows a pose, kept above the ground and within the city.
    void go(const CameraPose& pose);

public Q_SLOTS:
    void showWholeCity();
    void turnNorthUp();
    void lookFromAbove();
    void setProjection(noonmark::Projection projection);
    void show(const Box2& box);          ///< from above
    void showSlanting(const Box2& box);  ///< like the whole city, but for this part

Q_SIGNALS:
    void hovered(QPointF pixel);
    void left();
    void clicked(QPointF pixel);  ///< left button, without a drag
    void doubleClicked(QPointF pixel);
    void rightClicked(QPointF pixel);
    void sunDragged(QPointF byPx);  ///< a drag with Ctrl
    void keyPressed(int key);       ///< a key that does not move the camera

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void press(const QMouseEvent& event);
    void drag(const QMouseEvent& event);
    void release(const QMouseEvent& event);
    void wheel(const QWheelEvent& event);
    bool key(const QKeyEvent& event);
    void zoomAt(QPointF pixel, double factor);
    void frame(CameraPose pose);

    CityView& view_;
    ScenePicker scene_;
    QPointF pressedAt_;
    QPointF last_;
    glm::dvec3 pivot_{0};  // of a drag that rotates: the ground below the middle of the view
    std::vector<DragTarget*> targets_;
    DragTarget* held_ = nullptr;
    bool dragging_ = false;
    bool doubled_ = false;  // the next release belongs to a double click
};

}  // namespace noonmark
