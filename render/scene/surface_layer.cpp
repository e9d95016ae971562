#include "render/scene/surface_layer.h"

#include <QVariant>
#include <QVector3D>
#include <cmath>
#include <glm/trigonometric.hpp>

#include "render/scene/picture_texture.h"
#include "render/scene/qt_vectors.h"
#include "render/scene/shader_material.h"

namespace noonmark {

namespace {

void includeSamples(const std::vector<ShaderMaterial*>& materials, bool included) {
    for (ShaderMaterial* material : materials) material->include(QStringLiteral("EXPLORED"), included);
}

}  // namespace

SurfaceLayer::SurfaceLayer(std::vector<ShaderMaterial*> materials, Qt3DCore::QNode* parent)
    : materials_(std::move(materials)), parent_(parent) {
    setPalette({{0, 0, 0, 255}});
    clear();
}

void SurfaceLayer::set(const char* uniform, const QVariant& value) {
    for (ShaderMaterial* material : materials_) material->set(QString::fromLatin1(uniform), value);
}

void SurfaceLayer::setPalette(const std::vector<GroundPicture::Pixel>& colours) {
    Qt3DRender::QAbstractTexture* texture = makeTexture(colours, parent_);
    set("palette", QVariant::fromValue(texture));
    delete palette_;
    palette_ = texture;
}

void SurfaceLayer::show(const SurfacePicture& picture) {
    Qt3DRender::QAbstractTexture* texture = makeTexture(picture, parent_);
    set("samples", QVariant::fromValue(texture));
    delete samples_;
    samples_ = texture;
    const PixelCamera& camera = picture.camera;
    set("samplesEye", toVector(camera.eye));
    set("samplesForward", toVector(camera.forward));
    set("samplesRight", toVector(camera.right));
    set("samplesUp", toVector(camera.up));
    set("samplesScale", float(samplesPerMetre(camera, 1)));
    set("samplesParallel", camera.heightM > 0 ? 1.0F : 0.0F);
    set("soFar", picture.soFar ? 1.0F : 0.0F);
    includeSamples(materials_, true);
}

void SurfaceLayer::clear() {
    SurfacePicture nothing;
    nothing.samples = {{0, 0, 0, -1}};
    show(nothing);
    includeSamples(materials_, false);
}

}  // namespace noonmark
