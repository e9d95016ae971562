#pragma once

#include <QString>

class QPushButton;

namespace noonmark {

/// A button with its text and tooltip; `name` is what tests and style sheets know it by.
QPushButton* pushButton(const QString& text, const char* name, const QString& tip);

}  // namespace noonmark
