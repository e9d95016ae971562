#pragma once

#include <QObject>
#include <QPointF>
#include <array>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "app/gui/view/panel/point_input.h"
#include "core/base/result.h"
#include "core/city/footprints/footprint.h"

namespace noonmark {

/// A polygon drawn by clicks on the ground. Independent of mouse and window: points are passed in.
class PolygonTool final : public QObject {
    Q_OBJECT
public:
    /// `what` names the polygon in messages: "region", "lot".
    explicit PolygonTool(QString what, QObject* parent = nullptr);

    [[nodiscard]] bool active() const { return active_; }

    void begin();
    /// `square`: the new side continues the previous one or is perpendicular to it; the first side follows a
    /// compass direction.
    void addPoint(glm::dvec3 ground, bool square = false);
    void moveTo(glm::dvec3 ground, bool square = false);  ///< where the next point would be
    /// Places a corner so far from the last one, metres: at an azimuth, degrees clockwise from north, or else
    /// towards the point under the cursor. Emits refused() where there is no such direction.
    void addSide(double lengthM, std::optional<double> azimuthDeg = {});
    void removeLastPoint();
    /// Needs three points or more; otherwise the tool emits refused() and stays active.
    void finish();
    void cancel();

    [[nodiscard]] const std::vector<glm::vec3>& points() const { return points_; }
    /// Whether a point lies on the first corner of an outline that could be finished.
    [[nodiscard]] bool closesAt(glm::dvec2 ground) const;
    /// The points so far, and the one under the cursor.
    [[nodiscard]] std::vector<glm::vec3> line() const;

    /// Length of the line's last side, and area of the closed line (0 below three points). Metres, m2.
    [[nodiscard]] double sideM() const;
    [[nodiscard]] double areaM2() const;

Q_SIGNALS:
    void lineChanged();
    /// Disjoint pieces, at least one: crossing sides produce several.
    void finished(std::vector<noonmark::Footprint> pieces);
    void refused(noonmark::Error error);  ///< no area, or fewer than three points
    void activeChanged(bool active);

private:
    void end();
    [[nodiscard]] std::optional<glm::dvec2> cursorDirection() const;  ///< from the last corner
    [[nodiscard]] glm::vec3 placed(glm::dvec3 ground, bool square) const;

    QString what_;
    bool active_ = false;
    std::vector<glm::vec3> points_;
    std::optional<glm::vec3> cursor_;
};

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
