#pragma once

#include <QObject>
#include <QTimer>
#include <optional>

#include "render/view/view_navigator.h"

namespace noonmark {

class ViewPanel;

/// The arrow on top of a tower: dragged up and down it states a height, in whole storeys or freely with
/// Shift. A number that is typed over the view states it too, with Enter.
class ExtrudeHandle final : public QObject, public DragTarget {
    Q_OBJECT
public:
    explicit ExtrudeHandle(ViewPanel& panel, QObject* parent = nullptr);  ///< `panel` outlives it
    ~ExtrudeHandle() override;

    struct Tower {
        glm::dvec3 foot{0};  ///< on the ground, under the handle
        double heightM = 0;
        double storeyM = 3.5;
    };
    void stand(const Tower& tower);
    void hide();
    [[nodiscard]] bool shown() const { return tower_.has_value(); }
    [[nodiscard]] bool dragging() const { return grabbedM_.has_value(); }

    /// Beside the cursor while it is dragged, and under it the keys.
    void tell(const QString& figures);

    bool grab(QPointF pixel) override;
    void dragTo(QPointF pixel) override;
    void drop() override;

    /// True where the key was a part of a number, or ended one.
    bool key(int key);

Q_SIGNALS:
    void dragged(double heightM);  ///< as often as a picture can be made
    void dropped(double heightM);  ///< the drag, or the typing, has ended

private:
    [[nodiscard]] std::optional<double> heightAt(QPointF pixel) const;
    [[nodiscard]] double metresUp(QPointF pixel) const;
    [[nodiscard]] bool isAt(QPointF pixel) const;
    void follow();
    void showTyped();

    ViewPanel& panel_;
    std::optional<Tower> tower_;
    std::optional<double> grabbedM_;  // from the handle to where it was taken
    bool fromAbove_ = false;          // the drag counts pixels
    QPointF pixel_;
    QTimer next_;  // several moves of the mouse in one picture
    QString typed_;
};

}  // namespace noonmark
