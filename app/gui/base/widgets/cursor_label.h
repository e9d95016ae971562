#pragma once

#include <QLabel>
#include <functional>

class QWindow;

namespace noonmark {

/// Some lines of text beside the cursor over the view, such as the measures of what is being drawn or
/// dragged. Takes no clicks.
class CursorLabel final : public QLabel {
    Q_OBJECT
public:
    CursorLabel(QWindow& view, QWidget* parent);  ///< `view` must outlive it

    /// Where the picture begins in the view whose pixels show() counts, in pixels.
    void setLeft(std::function<double()> left) { left_ = std::move(left); }
    /// Shows the text beside this pixel of the picture; an empty text hides it.
    void show(QPointF pixel, const QString& text);
    /// To which side of the cursor the ground is free of the shadow that is looked at, as a direction in the
    /// view: x to the right, y down. {}: below at the right.
    void setFreeSide(QPointF direction) { freeSide_ = direction; }
    /// More lines below the text of show(), until they are replaced; empty: none.
    void setLinesBelow(const QString& lines);

private:
    void place();

    QWindow& view_;
    QPointF pixel_, freeSide_;
    QString text_, below_;
    std::function<double()> left_ = [] { return 0.0; };
};

}  // namespace noonmark
