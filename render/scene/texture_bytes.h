#pragma once

#include <QByteArray>
#include <Qt3DRender/QTexture>

namespace noonmark {

/// Four numbers per pixel.
enum class PixelKind { bytes, floats };

/// A texture of `columns` x `rows` pixels, row by row; the first row is at v = 0. The caller sets the
/// filters.
Qt3DRender::QAbstractTexture* makeByteTexture(const QByteArray& pixels, PixelKind kind, int columns, int rows,
                                              Qt3DCore::QNode* parent);

}  // namespace noonmark
