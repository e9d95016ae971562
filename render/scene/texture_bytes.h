#pragma once

#include <QByteArray>
#include <Qt3DRender/QTexture>

namespace noonmark {

/// Four bytes, four floats, two floats or one float per pixel.
enum class PixelKind { bytes, floats, pairs, depths };

/// A texture of `columns` x `rows` pixels, row by row; the first row is at v = 0. The caller sets the
/// filters.
Qt3DRender::QAbstractTexture* makeByteTexture(const QByteArray& pixels, PixelKind kind, int columns, int rows,
                                              Qt3DCore::QNode* parent);

/// Replaces all pixels; size and kind stay. A new texture for each frame would cost its memory each time.
void replaceBytes(Qt3DRender::QAbstractTexture& texture, const QByteArray& pixels, PixelKind kind);

}  // namespace noonmark
