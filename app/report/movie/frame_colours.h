#pragma once

#include <QImage>

namespace noonmark {

/// The picture with a table of at most 256 colours: those that most of its pixels have, and for the others
/// the nearest of them. Maps have few colours, so that areas stay flat; photographs would show bands.
/// O(pixels).
QImage reduceColours(const QImage& image);

}  // namespace noonmark
