#pragma once

#include <QFrame>
#include <functional>

#include "core/base/result.h"

class QHBoxLayout;
class QLabel;
class QPushButton;
class QTimer;

namespace noonmark {

/// A line over the view that says what went wrong or was done. It asks for nothing and waits to be closed.
class MessageBar final : public QFrame {
    Q_OBJECT
public:
    explicit MessageBar(QWidget* parent = nullptr);

    void showError(const Error& error);
    void showNote(const QString& text);  ///< goes by itself after a while
    void showHelp(const QString& text);  ///< stays
    /// A button beside the message that is shown, until another is; it hides the message and calls `done`.
    void offer(const QString& remedy, std::function<void()> done);
    /// A second button beside that one; likewise.
    void offerToo(const QString& remedy, std::function<void()> done);
    void dismiss();  ///< hides the message unless it offers something
    [[nodiscard]] QString text() const;

private:
    void show(const QString& text, const char* colours);
    QLabel* label_;
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
