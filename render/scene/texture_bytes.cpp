#include "render/scene/texture_bytes.h"

#include <Qt3DRender/QAbstractTextureImage>
#include <Qt3DRender/QTextureImageData>
#include <Qt3DRender/QTextureImageDataGenerator>

namespace noonmark {

namespace {

int bytesAPixel(PixelKind kind) { return kind == PixelKind::bytes ? 4 : 16; }

// Supplies the pixels to Qt3D, which asks for them from its own thread. Two sources are equal if they share
// their bytes.
class PixelSource final : public Qt3DRender::QTextureImageDataGenerator {
public:
    PixelSource(QByteArray bytes, PixelKind kind, int columns, int rows)
        : bytes_(std::move(bytes)), kind_(kind), columns_(columns), rows_(rows) {}

    Qt3DRender::QTextureImageDataPtr operator()() override {
        const bool bytes = kind_ == PixelKind::bytes;
        auto data = Qt3DRender::QTextureImageDataPtr::create();
        data->setTarget(QOpenGLTexture::Target2D);
        data->setFormat(bytes ? QOpenGLTexture::RGBA8_UNorm : QOpenGLTexture::RGBA32F);
        data->setPixelFormat(QOpenGLTexture::RGBA);
        data->setPixelType(bytes ? QOpenGLTexture::UInt8 : QOpenGLTexture::Float32);
        data->setWidth(columns_);
        data->setHeight(rows_);
        data->setDepth(1);
        data->setLayers(1);
        data->setFaces(1);
        data->setMipLevels(1);
        data->setData(bytes_, bytesAPixel(kind_));
        return data;
    }

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
    texture->setFormat(kind == PixelKind::bytes ? Qt3DRender::QAbstractTexture::RGBA8_UNorm
                                                : Qt3DRender::QAbstractTexture::RGBA32F);
    texture->setSize(columns, rows);
    texture->setWrapMode(Qt3DRender::QTextureWrapMode(Qt3DRender::QTextureWrapMode::ClampToEdge));
    texture->addTextureImage(
        new PixelImage(QSharedPointer<PixelSource>::create(pixels, kind, columns, rows)));
    return texture;
}

}  // namespace noonmark
