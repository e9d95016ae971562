#include "app/report/palette.h"

namespace noonmark {

namespace {

QColor colourOf(Rgb rgb) { return {rgb.red, rgb.green, rgb.blue}; }

}  // namespace

QColor shadowColour(double share) { return colourOf(shadowRgb(share)); }

QColor impactColour(double share) { return colourOf(impactRgb(share)); }

}  // namespace noonmark
