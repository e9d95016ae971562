#pragma once

#include <QColor>
#include <QFont>
#include <QPainter>
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

/// Width of a picture, pixels: default, and the range. Without Qt, for options.
constexpr int pictureWidth = 1600, minPictureWidth = 400, maxPictureWidth = 12000;

namespace ink {
constexpr QColor text{0x1d, 0x20, 0x27};
constexpr QColor heading{0x3b, 0x2a, 0x6e};  ///< the dark end of the palette
constexpr QColor quiet{0x5c, 0x61, 0x6b};    ///< less important text; contrast 6:1 on white
constexpr QColor line{0xc9, 0xcc, 0xd1};
constexpr QColor paper{0xff, 0xff, 0xff};
constexpr QColor building{0x9b, 0x9d, 0xa0};  ///< on the ground, inside the region
constexpr QColor buildingLine{0x7c, 0x7f, 0x84};
constexpr QColor context{0xe3, 0xe4, 0xe6};  ///< a building outside the region
constexpr QColor contextLine{0xcf, 0xd1, 0xd4};
}  // namespace ink

/// The colours of text and lines, and of the paper under them: as printed, unless a dark window asks for
/// others.
struct Inks {
    QColor text = ink::text, quiet = ink::quiet, line = ink::line, paper = ink::paper;
};

/// A painter and the size of a typographic point (1/72 inch in print) in its units. All text sizes and line
/// widths are in points, so that a picture on screen and a printed page look the same. Does not own the
/// painter.
struct Canvas {
    QPainter& painter;
    double point = 1;
    Inks inks{};
};

/// `colour`; where it is about as light as the paper, the same hue with its lightness mirrored about the
/// middle.
QColor readableOn(const QColor& paper, const QColor& colour);

/// Roboto, or a fallback, `points` high on `canvas`. Unhinted, so that lines break in the same places at
/// every size.
QFont textFont(const Canvas& canvas, double points, QFont::Weight weight = QFont::Normal);

/// Monospaced font for hashes and command lines.
QFont codeFont(const Canvas& canvas, double points);

/// A pen of `points` width.
QPen linePen(const Canvas& canvas, const QColor& colour, double points);

}  // namespace noonmark
