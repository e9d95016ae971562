#pragma once

#include <QColor>
#include <cstddef>

#include "core/measures/palette.h"

namespace noonmark {

QColor toColour(Rgb rgb);

/// The colours of core/measures/palette.h as QColor.
QColor shadowColour(double share);
QColor impactColour(double share);

/// Colours of series side by side, the first of which is what the others are compared with; told apart by
/// colour-blind readers (after Okabe and Ito). They repeat after maxSeries.
QColor seriesColour(std::size_t series);
inline constexpr std::size_t maxSeries = 8;

/// Colours of shadows, told apart by colour-blind readers and by lightness in grey print.
namespace shade {
constexpr QColor baseline{0xb4, 0xb8, 0xc4};
constexpr QColor sun{0xe0, 0xa8, 0x3c};
constexpr QColor incremental{0xd5, 0x5e, 0x00};
constexpr QColor gained{0xf7, 0xdc, 0x6f};
constexpr QColor place{0xe4, 0xf0, 0xe2};
constexpr QColor placeLine{0x0b, 0x5d, 0x57};
constexpr QColor building{0xf4, 0xf4, 0xf5};
constexpr QColor buildingLine{0x85, 0x88, 0x90};
constexpr QColor proposal{0x3b, 0x2a, 0x6e};  ///< the dark end of the palette
}  // namespace shade

}  // namespace noonmark
