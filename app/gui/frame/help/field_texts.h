#pragma once

#include <QString>

class QWidget;

namespace noonmark {

/// What a field without a tool tip means, by its object name; empty for others.
QString findFieldText(const QWidget& field);

}  // namespace noonmark
