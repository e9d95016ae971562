#include "app/report/maps/palette.h"

namespace noonmark {

namespace {

QColor pickColour(Rgb rgb) { return {rgb.red, rgb.green, rgb.blue}; }

}  // namespace

QColor shadowColour(double share) { return pickColour(shadowRgb(share)); }

QColor impactColour(double share) { return pickColour(impactRgb(share)); }

}  // namespace noonmark
