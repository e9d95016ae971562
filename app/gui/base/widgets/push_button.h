#pragma once

#include <QString>

class QPushButton;

namespace noonmark {

/// A button with text and tooltip; tests and style sheets identify it by `name`.
QPushButton* pushButton(const QString& text, const char* name, const QString& tip);

}  // namespace noonmark
