#include "app/report/maps/palette.h"

#include <array>

namespace noonmark {

QColor toColour(Rgb rgb) { return {rgb.red, rgb.green, rgb.blue}; }

QColor shadowColour(double share) { return toColour(shadowRgb(share)); }

QColor impactColour(double share) { return toColour(impactRgb(share)); }

QColor seriesColour(std::size_t series) {
    static constexpr std::array<QColor, maxSeries> colours{shade::baseline,          shade::sun,
                                                           QColor(0x00, 0x72, 0xb2), QColor(0x00, 0x9e, 0x73),
                                                           QColor(0xcc, 0x79, 0xa7), QColor(0x56, 0xb4, 0xe9),
                                                           shade::incremental,       shade::proposal};
    return colours[series % maxSeries];
}

}  // namespace noonmark
