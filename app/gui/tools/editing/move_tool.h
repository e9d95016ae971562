#pragma once

#include <QObject>
#include <QTimer>

#include "render/view/view_navigator.h"

namespace noonmark {

class ViewPanel;

/// Drags one building over the ground while active.
class MoveTool final : public QObject, public DragTarget {
    Q_OBJECT
public:
    explicit MoveTool(ViewPanel& panel, QObject* parent = nullptr);  ///< `panel` must outlive it
    ~MoveTool() override;

    void begin(std::uint32_t building);  ///< index in the view's city
    void end();
    [[nodiscard]] bool active() const { return building_.has_value(); }

    bool grab(QPointF pixel) override;
    void dragTo(QPointF pixel) override;
    void drop() override;

Q_SIGNALS:
    void began();
    /// Metres east and north of its present place; at most once per frame.
    void dragged(glm::dvec2 byM);
    void dropped(glm::dvec2 byM);

private:
    void follow();

    ViewPanel& panel_;
    std::optional<std::uint32_t> building_;
    std::optional<glm::dvec3> from_;  // the point grabbed
    glm::dvec2 byM_{0, 0};
    QPointF pixel_;
    QTimer next_;
};

}  // namespace noonmark
