#pragma once

#include <QObject>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "core/base/units.h"

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

}  // namespace noonmark
