#pragma once

#include <QColor>

#include "core/measures/palette.h"

namespace noonmark {

/// The colours of core/measures/palette.h as QColor.
QColor shadowColour(double share);
QColor impactColour(double share);

}  // namespace noonmark
