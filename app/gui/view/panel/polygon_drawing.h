#pragma once

#include <QObject>
#include <QPointF>
#include <array>

#include "app/gui/view/panel/polygon_tool.h"
#include "app/gui/view/panel/snapping.h"
#include "app/gui/view/panel/typed_length.h"

namespace noonmark {

class CursorLabel;
class ViewNavigator;

/// Draws regions, lots and places in the view: mouse and keys become calls of the PolygonTool that is active.
/// Points snap to corners and edges, Shift sets sides square, and a length typed after the first point is
/// that of the next side.
class PolygonDrawing final : public QObject {
    Q_OBJECT
public:
    /// All must outlive it.
    PolygonDrawing(CityView& view, ViewNavigator& navigator, CursorLabel& label, QObject* parent = nullptr);

    [[nodiscard]] PolygonTool& region() { return *tools_[0]; }
    [[nodiscard]] PolygonTool& lot() { return *tools_[1]; }
    [[nodiscard]] PolygonTool& place() { return *tools_[2]; }
    [[nodiscard]] PolygonTool* active() const;  ///< null: none
    [[nodiscard]] Snapping& snapping() { return snapping_; }

    void hover(QPointF pixel);
    bool key(int key);  ///< false: no polygon is being drawn
    void cancel();

Q_SIGNALS:
    void lineChanged();
    void refused(noonmark::Error error);
    void activeChanged(bool active);

private:
    void connectTool(PolygonTool* tool);
    void click(QPointF pixel);
    void takeTyped();
    void editKey(int key);
    void showLabel();
    [[nodiscard]] QString describe() const;
    [[nodiscard]] std::optional<glm::dvec3> groundAt(QPointF pixel);
    [[nodiscard]] QString describeTyped() const;

    ViewNavigator& navigator_;
    CursorLabel& label_;
    Snapping snapping_;
    std::array<PolygonTool*, 3> tools_;
    TypedLength typed_{TypedLength::Form::lengthAndAzimuth};
    std::optional<Snap> snap_;  ///< under the cursor
    QPointF pixel_;             ///< of the cursor
    ShortcutClaim claim_;
};

}  // namespace noonmark
