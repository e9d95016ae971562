#pragma once

#include <QString>

namespace noonmark {

/// "12,345.6": the one form of numbers in the window.
QString groupDigits(double number, int decimals = 0);

}  // namespace noonmark
