#pragma once

#include <QLabel>

class QWindow;

namespace noonmark {

/// A line or two of text beside the cursor over the view, such as the measures of what is being drawn or
/// dragged. Takes no clicks.
class CursorLabel final : public QLabel {
    Q_OBJECT
public:
    CursorLabel(QWindow& view, QWidget* parent);  ///< `view` must outlive it

    /// Shows the text beside this pixel of the view; an empty text hides it.
    void show(QPointF pixel, const QString& text);

private:
    QWindow& view_;
};

}  // namespace noonmark
