#include "render/scene/picture_texture.h"

#include "core/engines/accrual/sun_depth_map.h"
#include "core/engines/ray/traced_view.h"
#include "render/scene/texture_bytes.h"

namespace noonmark {

namespace {

template <class Pixel>
QByteArray bytesOf(const std::vector<Pixel>& pixels) {
    return {reinterpret_cast<const char*>(pixels.data()), qsizetype(pixels.size() * sizeof(Pixel))};
}

Qt3DRender::QAbstractTexture* unfiltered(Qt3DRender::QAbstractTexture* texture) {
    texture->setMinificationFilter(Qt3DRender::QAbstractTexture::Nearest);
    texture->setMagnificationFilter(Qt3DRender::QAbstractTexture::Nearest);
    return texture;
}

}  // namespace

Qt3DRender::QAbstractTexture* makeTexture(const GroundPicture& picture, Qt3DCore::QNode* parent) {
    auto* texture = makeByteTexture(bytesOf(picture.pixels), PixelKind::bytes, picture.grid.columns,
                                    picture.grid.rows, parent);
    texture->setMinificationFilter(Qt3DRender::QAbstractTexture::LinearMipMapLinear);
    texture->setMagnificationFilter(Qt3DRender::QAbstractTexture::Nearest);
    texture->setMaximumAnisotropy(4);
    texture->setGenerateMipMaps(true);
    return texture;
}

Qt3DRender::QAbstractTexture* makeTexture(const SurfacePicture& picture, Qt3DCore::QNode* parent) {
    return unfiltered(makeByteTexture(bytesOf(picture.samples), PixelKind::floats, picture.camera.widthPx,
                                      picture.camera.heightPx, parent));
}

Qt3DRender::QAbstractTexture* makeTexture(const SunDepthMap& map, Qt3DCore::QNode* parent) {
    return unfiltered(makeByteTexture(bytesOf(map.depth), PixelKind::depths, map.size, map.size, parent));
}

Qt3DRender::QAbstractTexture* makeTexture(const TracedView& view, Qt3DCore::QNode* parent) {
    return unfiltered(
        makeByteTexture(bytesOf(view.pixels), PixelKind::pairs, view.widthPx, view.heightPx, parent));
}

void replaceTexture(Qt3DRender::QAbstractTexture& texture, const TracedView& view) {
    replaceBytes(texture, bytesOf(view.pixels), PixelKind::pairs);
}

Qt3DRender::QAbstractTexture* makeTexture(const std::vector<GroundPicture::Pixel>& palette,
                                          Qt3DCore::QNode* parent) {
    return unfiltered(makeByteTexture(bytesOf(palette), PixelKind::bytes, int(palette.size()), 1, parent));
}

}  // namespace noonmark
