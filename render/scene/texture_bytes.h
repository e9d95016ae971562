#pragma once

#include <QByteArray>
#include <Qt3DRender/QTexture>

namespace noonmark {

/// Four bytes, four floats or one float per pixel.
enum class PixelKind { bytes, floats, depths };

/// A texture of `columns` x `rows` pixels, row by row; the first row is at v = 0. The caller sets the
/// filters.
Qt3DRender::QAbstractTexture* makeByteTexture(const QByteArray& pixels, PixelKind kind, int columns, int rows,
                                              Qt3DCore::QNode* parent);

}  // namespace noonmark
