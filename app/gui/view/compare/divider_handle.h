#pragma once

#include <QCursor>
#include <QObject>
#include <optional>

#include "render/view/view_navigator.h"

namespace noonmark {

/// Drags the divider between the two scenarios of a swipe.
class DividerHandle final : public QObject, public DragTarget {
    Q_OBJECT
public:
    /// Both must outlive this object.
    DividerHandle(CityView& view, ViewNavigator& navigator, QObject* parent = nullptr);
    ~DividerHandle() override;

    void setActive(bool active);
    bool grab(QPointF pixel) override;
    void dragTo(QPointF pixel) override;
    void drop() override {}

private:
    [[nodiscard]] bool isAt(QPointF pixel) const;
    void showCursor(QPointF pixel);
    void restoreCursor();

    CityView& view_;
    ViewNavigator& navigator_;
    bool active_ = false;
    std::optional<QCursor> before_;  ///< the cursor while the one of the divider is shown
};

}  // namespace noonmark
