#include "render/scene/picture_texture.h"

#include <Qt3DRender/QAbstractTextureImage>
#include <Qt3DRender/QTextureDataUpdate>
#include <Qt3DRender/QTextureImageData>
#include <Qt3DRender/QTextureImageDataGenerator>

#include "core/engines/depths/sun_depth_map.h"
#include "core/engines/ray/traced_view.h"

namespace noonmark {

namespace {

struct PixelFormat {
    Qt3DRender::QAbstractTexture::TextureFormat texture;
    QOpenGLTexture::PixelFormat pixel;
    QOpenGLTexture::PixelType type;
    int bytes;
};

PixelFormat formatOf(PixelKind kind) {
    using Texture = Qt3DRender::QAbstractTexture;
    if (kind == PixelKind::bytes)
        return {Texture::RGBA8_UNorm, QOpenGLTexture::RGBA, QOpenGLTexture::UInt8, 4};
    if (kind == PixelKind::depths) return {Texture::R32F, QOpenGLTexture::Red, QOpenGLTexture::Float32, 4};
    if (kind == PixelKind::pairs) return {Texture::RG32F, QOpenGLTexture::RG, QOpenGLTexture::Float32, 8};
    return {Texture::RGBA32F, QOpenGLTexture::RGBA, QOpenGLTexture::Float32, 16};
}

Qt3DRender::QTextureImageDataPtr imageOf(const QByteArray& bytes, PixelKind kind, int columns, int rows) {
    const PixelFormat format = formatOf(kind);
    auto data = Qt3DRender::QTextureImageDataPtr::create();
    data->setTarget(QOpenGLTexture::Target2D);
    data->setFormat(QOpenGLTexture::TextureFormat(format.texture));
    data->setPixelFormat(format.pixel);
    data->setPixelType(format.type);
    data->setWidth(columns);
    data->setHeight(rows);
    data->setDepth(1);
    data->setLayers(1);
    data->setFaces(1);
    data->setMipLevels(1);
    data->setData(bytes, format.bytes);
    return data;
}

// Supplies the pixels to Qt3D, which asks for them from its own thread. Two sources are equal if they share
// their bytes.
class PixelSource final : public Qt3DRender::QTextureImageDataGenerator {
public:
    PixelSource(QByteArray bytes, PixelKind kind, int columns, int rows)
        : bytes_(std::move(bytes)), kind_(kind), columns_(columns), rows_(rows) {}

    Qt3DRender::QTextureImageDataPtr operator()() override { return imageOf(bytes_, kind_, columns_, rows_); }

    QT3D_FUNCTOR(PixelSource)

    bool operator==(const QTextureImageDataGenerator& other) const override {
        const auto* source = Qt3DCore::functor_cast<PixelSource>(&other);
        return source && source->bytes_.constData() == bytes_.constData();
    }

private:
    QByteArray bytes_;
    PixelKind kind_;
    int columns_;
    int rows_;
};

class PixelImage final : public Qt3DRender::QAbstractTextureImage {
public:
    explicit PixelImage(QSharedPointer<PixelSource> source) : source_(std::move(source)) {
        notifyDataGeneratorChanged();
    }

protected:
    Qt3DRender::QTextureImageDataGeneratorPtr dataGenerator() const override { return source_; }

private:
    Qt3DRender::QTextureImageDataGeneratorPtr source_;
};

}  // namespace

Qt3DRender::QAbstractTexture* makeByteTexture(const QByteArray& pixels, PixelKind kind, int columns, int rows,
                                              Qt3DCore::QNode* parent) {
    auto* texture = new Qt3DRender::QTexture2D(parent);
    texture->setFormat(formatOf(kind).texture);
    texture->setSize(columns, rows);
    texture->setWrapMode(Qt3DRender::QTextureWrapMode(Qt3DRender::QTextureWrapMode::ClampToEdge));
    texture->addTextureImage(
        new PixelImage(QSharedPointer<PixelSource>::create(pixels, kind, columns, rows)));
    return texture;
}

void replaceBytes(Qt3DRender::QAbstractTexture& texture, const QByteArray& pixels, PixelKind kind) {
    Qt3DRender::QTextureDataUpdate update;
    update.setData(imageOf(pixels, kind, texture.width(), texture.height()));
    texture.updateData(update);
}

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

Qt3DRender::QAbstractTexture* makeDepthTexture(const std::vector<float>& depths, int size,
                                               Qt3DCore::QNode* parent) {
    return unfiltered(makeByteTexture(bytesOf(depths), PixelKind::depths, size, size, parent));
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
