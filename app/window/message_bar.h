#pragma once

#include <QFrame>

#include "core/result.h"

class QLabel;

namespace noonmark {

/// A line over the view that says what went wrong or was done. It asks for nothing and waits to be closed.
class MessageBar final : public QFrame {
    Q_OBJECT
public:
    explicit MessageBar(QWidget* parent = nullptr);

    void showError(const Error& error);
    void showNote(const QString& text);
    [[nodiscard]] QString text() const;

private:
    void show(const QString& text, const char* colours);
    QLabel* label_;
};

}  // namespace noonmark
