#pragma once

#include <QFrame>

class QLabel;
class QMainWindow;
class QPushButton;

namespace noonmark {

/// A frame around the control of a step. The mouse goes through it.
class TourFrame final : public QWidget {
    Q_OBJECT
public:
    explicit TourFrame(QWidget* parent);

    void put(const QRect& control);  ///< in the parent; empty: hides it

protected:
    void paintEvent(QPaintEvent* event) override;
};

/// The text of a step beside its control, above the 3D view too: a window of its own without a frame.
class TourBubble final : public QFrame {
    Q_OBJECT
public:
    explicit TourBubble(QMainWindow& window);

    /// What the button does that takes the user on.
    enum class Onward { showMe, next, finish };
    void tell(const QString& title, const QString& text, Onward onward);
    void put(const QRect& control);  ///< beside it, in the window; empty: in the middle

Q_SIGNALS:
    void showMe();
    void ended();

private:
    QMainWindow& window_;
    QLabel* title_;
    QLabel* text_;
    QPushButton* show_;
    QPushButton* end_;
};

}  // namespace noonmark
