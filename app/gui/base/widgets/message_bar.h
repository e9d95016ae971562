#pragma once

#include <QFrame>
#include <functional>

#include "core/base/result.h"

class QHBoxLayout;
class QLabel;
class QPushButton;
class QTimer;
class QToolButton;

namespace noonmark {

/// A bar over the view for errors and notices. It is not modal and stays until closed. Of a notice of
/// several lines it shows the first, and the others on request.
class MessageBar final : public QFrame {
    Q_OBJECT
public:
    explicit MessageBar(QWidget* parent = nullptr);

    void showError(const Error& error);
    void showNote(const QString& text);  ///< disappears after a while
    void showHelp(const QString& text);  ///< stays until closed
    /// Adds a button to the current message; clicking it hides the message and calls `done`.
    void offer(const QString& remedy, std::function<void()> done);
    /// Adds a second button; likewise.
    void offerToo(const QString& remedy, std::function<void()> done);
    void dismiss();                      ///< hides the message unless it offers something
    [[nodiscard]] QString text() const;  ///< all lines; empty: no message

private:
    void show(const QString& text);
    void unfold(bool all);
    void paintColours();
    QLabel* label_;
    QToolButton* more_;
    QString text_;
    bool isError_ = false;
    bool unfolded_ = false;
    struct Remedy {
        QPushButton* button;
        std::function<void()> chosen;
    };
    void add(Remedy& remedy, const char* name, QHBoxLayout& row);
    static void offer(Remedy& remedy, const QString& text, std::function<void()> done);

    Remedy remedy_;
    Remedy other_;
    QTimer* leave_;
};

}  // namespace noonmark
