#include "render/picture_texture.h"

#include <QByteArray>
#include <Qt3DRender/QAbstractTextureImage>
#include <Qt3DRender/QTextureImageData>
#include <Qt3DRender/QTextureImageDataGenerator>

namespace noonmark {

namespace {

using Pixel = GroundPicture::Pixel;

// Hands the pixels to Qt3D, which asks from its own thread. Two are the same when they share their bytes.
class PixelSource final : public Qt3DRender::QTextureImageDataGenerator {
public:
    PixelSource(QByteArray bytes, int columns, int rows)
        : bytes_(std::move(bytes)), columns_(columns), rows_(rows) {}

    Qt3DRender::QTextureImageDataPtr operator()() override {
        auto data = Qt3DRender::QTextureImageDataPtr::create();
        data->setTarget(QOpenGLTexture::Target2D);
        data->setFormat(QOpenGLTexture::RGBA8_UNorm);
        data->setPixelFormat(QOpenGLTexture::RGBA);
        data->setPixelType(QOpenGLTexture::UInt8);
        data->setWidth(columns_);
        data->setHeight(rows_);
        data->setDepth(1);
        data->setLayers(1);
        data->setFaces(1);
        data->setMipLevels(1);
        data->setData(bytes_, int(sizeof(Pixel)));
        return data;
    }

    QT3D_FUNCTOR(PixelSource)

    bool operator==(const QTextureImageDataGenerator& other) const override {
        const auto* source = Qt3DCore::functor_cast<PixelSource>(&other);
        return source && source->bytes_.constData() == bytes_.constData();
    }

private:
    QByteArray bytes_;
    int columns_;
    int rows_;
};

class PixelImage final : public Qt3DRender::QAbstractTextureImage {
public:
    explicit PixelImage(const GroundPicture& picture)
        : source_(QSharedPointer<PixelSource>::create(
              QByteArray(reinterpret_cast<const char*>(picture.pixels.data()),
                         qsizetype(picture.pixels.size() * sizeof(Pixel))),
              picture.grid.columns, picture.grid.rows)) {
        notifyDataGeneratorChanged();
    }

protected:
    Qt3DRender::QTextureImageDataGeneratorPtr dataGenerator() const override { return source_; }

private:
    Qt3DRender::QTextureImageDataGeneratorPtr source_;
};

}  // namespace

Qt3DRender::QAbstractTexture* textureOf(const GroundPicture& picture, Qt3DCore::QNode* parent) {
    auto* texture = new Qt3DRender::QTexture2D(parent);
    texture->setFormat(Qt3DRender::QAbstractTexture::RGBA8_UNorm);
    texture->setSize(picture.grid.columns, picture.grid.rows);
    texture->setMinificationFilter(Qt3DRender::QAbstractTexture::LinearMipMapLinear);
    texture->setMagnificationFilter(Qt3DRender::QAbstractTexture::Nearest);
    texture->setWrapMode(Qt3DRender::QTextureWrapMode(Qt3DRender::QTextureWrapMode::ClampToEdge));
    texture->setMaximumAnisotropy(4);
    texture->setGenerateMipMaps(true);
    texture->addTextureImage(new PixelImage(picture));
    return texture;
}

}  // namespace noonmark
