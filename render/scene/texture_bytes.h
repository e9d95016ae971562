#pragma once

#include <QByteArray>
#include <Qt3DRender/QTexture>

namespace noonmark {

/// Four numbers a pixel.
enum class PixelKind { bytes, floats };

/// A new texture of `columns` x `rows` pixels, row by row; the first row is at v = 0. Filters are the
/// caller's to set.
Qt3DRender::QAbstractTexture* makeByteTexture(const QByteArray& pixels, PixelKind kind, int columns, int rows,
                                              Qt3DCore::QNode* parent);

}  // namespace noonmark
