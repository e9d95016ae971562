#pragma once

#include <QObject>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "core/base/result.h"
#include "core/city/footprints/footprint.h"

namespace noonmark {

/// A polygon that grows by clicks on the ground. Knows no mouse and no window: both are given to it.
class PolygonTool final : public QObject {
    Q_OBJECT
public:
    /// `what` is drawn, for messages: "region", "lot".
    explicit PolygonTool(QString what, QObject* parent = nullptr);

    [[nodiscard]] bool active() const { return active_; }

    void begin();
    /// `square`: the new side goes on along the side before it or square to it; the first one along a compass
    /// direction.
    void addPoint(glm::dvec3 ground, bool square = false);
    void moveTo(glm::dvec3 ground, bool square = false);  ///< where the next point would be
    void removeLastPoint();
    void finish();  ///< with three points or more; else the tool stays active and says so
    void cancel();

    /// The points so far and the one under the cursor.
    [[nodiscard]] std::vector<glm::vec3> line() const;

    /// Of that line: its last side, and the area when it is closed (0 below three points). Metres, m2.
    [[nodiscard]] double sideM() const;
    [[nodiscard]] double areaM2() const;

Q_SIGNALS:
    void lineChanged();
    /// Disjoint pieces, never none: sides that cross make several.
    void finished(std::vector<noonmark::Footprint> pieces);
    void refused(noonmark::Error error);  ///< the polygon has no area, or not three points
    void activeChanged(bool active);

private:
    void end();
    [[nodiscard]] glm::vec3 placed(glm::dvec3 ground, bool square) const;

    QString what_;
    bool active_ = false;
    std::vector<glm::vec3> points_;
    std::optional<glm::vec3> cursor_;
};

}  // namespace noonmark
