#pragma once

#include <QColor>
#include <QFont>
#include <QPainter>

namespace noonmark {

/// A painter and the size of a typographic point (1/72 inch of print) in its units: all sizes of text and
/// lines are in points, so that a picture on the screen and a page in print look the same. The painter is not
/// owned.
struct Canvas {
    QPainter& painter;
    double point = 1;
};

namespace ink {
constexpr QColor text{0x1d, 0x20, 0x27};
constexpr QColor heading{0x3b, 0x2a, 0x6e};  ///< of the palette's dark end
constexpr QColor quiet{0x5c, 0x61, 0x6b};    ///< less important text; 6:1 on white
constexpr QColor line{0xc9, 0xcc, 0xd1};
constexpr QColor paper{0xff, 0xff, 0xff};
constexpr QColor building{0x9b, 0x9d, 0xa0};  ///< stands on the ground, in the region
constexpr QColor buildingLine{0x7c, 0x7f, 0x84};
constexpr QColor context{0xe3, 0xe4, 0xe6};  ///< a building outside the region
constexpr QColor contextLine{0xcf, 0xd1, 0xd4};
}  // namespace ink

/// Roboto, or what stands in for it; `points` high on `canvas`. Unhinted: the same line breaks at every size.
QFont textFont(const Canvas& canvas, double points, QFont::Weight weight = QFont::Normal);

/// Every letter equally wide: hashes and command lines.
QFont codeFont(const Canvas& canvas, double points);

/// A pen of `points` width.
QPen linePen(const Canvas& canvas, const QColor& colour, double points);

}  // namespace noonmark
