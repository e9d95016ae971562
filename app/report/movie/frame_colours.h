#pragma once

#include <QImage>

namespace noonmark {

/// The picture with a table of at most 256 colours: those that most of its pixels have and, where it has more
/// colours, 96 that are spread evenly. All others become the nearest of them; areas of maps stay flat.
/// O(pixels).
QImage reduceColours(const QImage& image);

}  // namespace noonmark
