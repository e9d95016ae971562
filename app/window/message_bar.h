#pragma once

#include <QFrame>

#include "core/result.h"

class QLabel;
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
    [[nodiscard]] QString text() const;

private:
    void show(const QString& text, const char* colours);
    QLabel* label_;
    QTimer* leave_;
};

}  // namespace noonmark
