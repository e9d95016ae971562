#pragma once

#include <QByteArray>
#include <Qt3DRender/QTexture>

#include "render/scene/ground_picture.h"
#include "render/scene/surface_layer.h"

namespace noonmark {

/// Four bytes, four floats, two floats or one float per pixel.
enum class PixelKind { bytes, floats, pairs, depths };

/// A texture of `columns` x `rows` pixels, row by row; the first row is at v = 0. The caller sets the
/// filters.
Qt3DRender::QAbstractTexture* makeByteTexture(const QByteArray& pixels, PixelKind kind, int columns, int rows,
                                              Qt3DCore::QNode* parent);

/// Replaces all pixels; size and kind stay. A new texture for each frame would cost its memory each time.
void replaceBytes(Qt3DRender::QAbstractTexture& texture, const QByteArray& pixels, PixelKind kind);

struct TracedView;

/// Makes a texture of a picture; its first row is at v = 0. Cells are sharp at close range and averaged at a
/// distance.
Qt3DRender::QAbstractTexture* makeTexture(const GroundPicture& picture, Qt3DCore::QNode* parent);

/// A texture of unfiltered samples, which the shaders look up one by one.
Qt3DRender::QAbstractTexture* makeTexture(const SurfacePicture& picture, Qt3DCore::QNode* parent);

/// Heights towards the sun, `size` x `size`, looked up one by one.
Qt3DRender::QAbstractTexture* makeDepthTexture(const std::vector<float>& depths, int size,
                                               Qt3DCore::QNode* parent);

/// What rays found, looked up one by one; the first row is the top of the picture.
Qt3DRender::QAbstractTexture* makeTexture(const TracedView& view, Qt3DCore::QNode* parent);
/// The same for a texture of a picture of the same size.
void replaceTexture(Qt3DRender::QAbstractTexture& texture, const TracedView& view);

/// A texture of one row of colours.
Qt3DRender::QAbstractTexture* makeTexture(const std::vector<GroundPicture::Pixel>& palette,
                                          Qt3DCore::QNode* parent);

}  // namespace noonmark
