#pragma once

#include <QLabel>

class QWindow;

namespace noonmark {

/// A line or two beside the cursor over the view: what is drawn or dragged measures just now. Takes no
/// clicks.
class CursorLabel final : public QLabel {
    Q_OBJECT
public:
    CursorLabel(QWindow& view, QWidget* parent);  ///< `view` outlives it

    /// Beside this pixel of the view; an empty text hides it.
    void show(QPointF pixel, const QString& text);

private:
    QWindow& view_;
};

}  // namespace noonmark
