#pragma once

#include <QObject>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "core/receivers/region.h"
#include "core/result.h"

namespace noonmark {

/// A polygon that grows by clicks on the ground. Knows no mouse and no window: both are given to it.
class RegionTool final : public QObject {
    Q_OBJECT
public:
    explicit RegionTool(QObject* parent = nullptr) : QObject(parent) {}

    [[nodiscard]] bool active() const { return active_; }

    void begin();
    void addPoint(glm::dvec3 ground);
    void moveTo(glm::dvec3 ground);  ///< where the next point would be
    void removeLastPoint();
    void finish();  ///< with three points or more; else the tool stays active and says so
    void cancel();

    /// The points so far and the one under the cursor.
    [[nodiscard]] std::vector<glm::vec3> line() const;

Q_SIGNALS:
    void lineChanged();
    void finished(noonmark::Region region);
    void refused(noonmark::Error error);  ///< the polygon has no area, or not three points
    void activeChanged(bool active);

private:
    void end();

    bool active_ = false;
    std::vector<glm::vec3> points_;
    std::optional<glm::vec3> cursor_;
};

}  // namespace noonmark
