#pragma once

#include <QDialog>
#include <QObject>
#include <array>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "core/base/units.h"
#include "render/view/section_box.h"
#include "render/view/view_navigator.h"

namespace noonmark {

/// What a line between points on ground, roofs and walls measures. Metres, m2.
struct LineMeasures {
    double sideM = 0;    ///< of the last side, in the plan
    double riseM = 0;    ///< of the last side: height of its end above its beginning
    double slopeM = 0;   ///< of the last side, in space
    double lengthM = 0;  ///< of all sides, in the plan
    double areaM2 = 0;   ///< of the closed line in the plan; 0 below three points
};
LineMeasures measureLine(const std::vector<glm::dvec3>& points);

/// "124.3 m, 20.0 m up (125.9 m in space)"; with three points and more also the length of all sides and the
/// area; empty without a side.
QString describeMeasures(const LineMeasures& measures, UnitSystem units);

/// A line that measures distances, heights and areas, drawn by clicks on what the view shows. Independent of
/// mouse and window: points are passed in, local metres.
class MeasureTool final : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

    [[nodiscard]] bool active() const { return active_; }
    void begin();
    void end();
    void addPoint(glm::dvec3 point);
    void moveTo(glm::dvec3 point);  ///< where the next point would be
    void removeLastPoint();

    /// The points so far, and the one under the cursor.
    [[nodiscard]] std::vector<glm::dvec3> line() const;

Q_SIGNALS:
    void lineChanged();
    void activeChanged(bool active);

private:
    bool active_ = false;
    std::vector<glm::dvec3> points_;
    std::optional<glm::dvec3> cursor_;
};

class CursorLabel;

/// The section box of a view, and the handles on its sides that can be dragged.
class SectionTool final : public QObject, public DragTarget {
    Q_OBJECT
public:
    /// All must outlive it.
    SectionTool(CityView& view, ViewNavigator& navigator, CursorLabel& label, QObject* parent = nullptr);
    ~SectionTool() override;

    [[nodiscard]] const std::optional<SectionBox>& box() const { return view_.section(); }
    void set(const std::optional<SectionBox>& box);  ///< empty: shows everything
    void setAroundCity();
    void setAround(const Box2& ground);  ///< this part of the city, at its full height
    /// Shows outline and handles. Without them the box still cuts, so that pictures show the city alone.
    void showHandles(bool shown);

    bool grab(QPointF pixel) override;
    void dragTo(QPointF pixel) override;
    void drop() override;

Q_SIGNALS:
    void changed();

private:
    [[nodiscard]] std::optional<std::size_t> handleAt(QPointF pixel) const;
    [[nodiscard]] glm::dvec2 pixelsPerMetre(const glm::dvec3& at, int axis) const;
    void showMarks();

    /// A drag: the side, where it was, and how its axis lies on the screen.
    struct Drag {
        std::size_t side = 0;
        double startM = 0;
        QPointF fromPx;
        glm::dvec2 alongPx{0};  ///< pixels a metre
    };

    CityView& view_;
    CursorLabel& label_;
    bool handlesShown_ = false;
    std::optional<Drag> drag_;
};

class LengthField;
class ViewPanel;

/// The sides of the section box as numbers. It stays open beside the view, whose handles are shown as long.
class SectionDialog final : public QDialog {
    Q_OBJECT
public:
    SectionDialog(ViewPanel& panel, QWidget* parent);  ///< `panel` must outlive it

Q_SIGNALS:
    void removed();  ///< the box is no longer wanted

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void addFields();
    void addButtons();
    void showBox();
    void takeField(std::size_t side);
    void takeView();

    ViewPanel& panel_;
    SectionTool& tool_;
    std::array<LengthField*, 6> fields_{};  ///< by sectionSides
};

}  // namespace noonmark
