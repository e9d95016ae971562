#pragma once

#include <QObject>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

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
    void removeLastPoint();
    /// Needs three points or more; otherwise the tool emits refused() and stays active.
    void finish();
    void cancel();

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
    [[nodiscard]] glm::vec3 placed(glm::dvec3 ground, bool square) const;

    QString what_;
    bool active_ = false;
    std::vector<glm::vec3> points_;
    std::optional<glm::vec3> cursor_;
};

}  // namespace noonmark
