#pragma once

#include <QObject>
#include <QPointF>
#include <QRectF>
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
/// with Ctrl asks for the sun to be turned, with Ctrl and Shift it draws a rectangle, the wheel zooms at the
/// cursor; arrow keys move, + and - zoom, Home shows the whole city, N turns north up, T looks from above.
/// The eye never goes below the ground.
class ViewNavigator final : public QObject {
    Q_OBJECT
public:
    explicit ViewNavigator(CityView& view);  ///< child of `view`

    void setScene(ScenePicker scene) { scene_ = std::move(scene); }
    [[nodiscard]] const ScenePicker& scene() const { return scene_; }

    /// Targets are tried in this order when a drag starts. A target outlives the navigator or removes itself.
    void addTarget(DragTarget& target) { targets_.push_back(&target); }
    void removeTarget(DragTarget& target);

    /// The object under a pixel of the view; device-independent pixels from the top left corner of the
    /// picture, see CityView::sideOffset(). Signals and drag targets count them in the same way.
    [[nodiscard]] std::optional<Pick> pickAt(QPointF pixel) const;
    [[nodiscard]] std::optional<glm::dvec3> groundAt(QPointF pixel) const;

    /// Left edge of the picture under the mouse, see CityView::sideOffset().
    [[nodiscard]] double pictureLeft() const { return side_; }
    /// The keys that are held at the click which clicked() reports.
    [[nodiscard]] Qt::KeyboardModifiers clickModifiers() const { return clickModifiers_; }

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
    /// A drag of the left button that began with Ctrl and Shift: its rectangle so far, and at its end.
    void boxDragged(QRectF pixels);
    void boxDropped(QRectF pixels);
    void keyPressed(int key);  ///< a key that does not move the camera

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QPointF inPicture(QPointF position);
    void press(const QMouseEvent& event);
    void drag(const QMouseEvent& event);
    void release(const QMouseEvent& event);
    void wheel(const QWheelEvent& event);
    bool key(const QKeyEvent& event);
    void zoomAt(QPointF pixel, double factor);
    void frame(CameraPose pose);

    CityView& view_;
    ScenePicker scene_;
    double side_ = 0;  // left edge of the picture under the mouse, or in which a drag began
    QPointF pressedAt_;
    QPointF last_;
    glm::dvec3 pivot_{0};  // of a drag that rotates: the ground below the middle of the view
    std::vector<DragTarget*> targets_;
    DragTarget* held_ = nullptr;
    Qt::KeyboardModifiers clickModifiers_;
    bool dragging_ = false;
    bool boxing_ = false;   // the drag draws a rectangle
    bool doubled_ = false;  // the next release belongs to a double click
};

}  // namespace noonmark
