#pragma once

#include <Qt3DRender/QTexture>

#include "render/scene/ground_picture.h"
#include "render/scene/surface_picture.h"

namespace noonmark {

/// A new texture of a picture; its first row is at v = 0. Near by, cells are crisp; far away, averaged.
Qt3DRender::QAbstractTexture* makeTexture(const GroundPicture& picture, Qt3DCore::QNode* parent);

/// Samples as they are, for the shaders to look up one by one.
Qt3DRender::QAbstractTexture* makeTexture(const SurfacePicture& picture, Qt3DCore::QNode* parent);

/// Colours in one row.
Qt3DRender::QAbstractTexture* makeTexture(const std::vector<GroundPicture::Pixel>& palette,
                                          Qt3DCore::QNode* parent);

}  // namespace noonmark
