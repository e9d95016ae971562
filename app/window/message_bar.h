#pragma once

#include <QFrame>

#include "core/result.h"

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
    void offer(const QString& remedy);   ///< a button beside the message that is shown, until another is
    [[nodiscard]] QString text() const;

Q_SIGNALS:
    void remedyChosen();

private:
    void show(const QString& text, const char* colours);
    QLabel* label_;
    QPushButton* remedy_;
    QTimer* leave_;
};

}  // namespace noonmark
