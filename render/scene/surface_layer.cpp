#include "render/scene/surface_layer.h"

#include <QVariant>
#include <QVector3D>
#include <QVector4D>
#include <cmath>
#include <glm/trigonometric.hpp>
#include <utility>

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

namespace {

QVector4D numbersOf(const glm::dvec4& v) { return {float(v.x), float(v.y), float(v.z), float(v.w)}; }

SunDepthMap noMap() {
    SunDepthMap nothing;
    nothing.size = 1;
    nothing.depth = {-1e30F};
    return nothing;
}

void includeSun(const std::vector<ShaderMaterial*>& materials, bool included) {
    for (ShaderMaterial* material : materials) material->include(QStringLiteral("SUNLIT"), included);
}

}  // namespace

SunLayer::SunLayer(std::vector<ShaderMaterial*> materials, Qt3DCore::QNode* parent)
    : materials_(std::move(materials)), parent_(parent) {
    show(noMap());
    clear();
}

void SunLayer::set(const char* uniform, const QVariant& value) {
    for (ShaderMaterial* material : materials_) material->set(QString::fromLatin1(uniform), value);
}

void SunLayer::layDepths(const QString& uniform, const std::vector<float>& depths, int size) {
    Qt3DRender::QAbstractTexture* texture = makeDepthTexture(depths, size, parent_);
    for (ShaderMaterial* material : materials_) material->set(uniform, QVariant::fromValue(texture));
    delete std::exchange(textures_[uniform], texture);
}

void SunLayer::layCrowns(const QString& uniform, const std::vector<float>& depths, int size) {
    if (!depths.empty()) layDepths(uniform, depths, size);
    for (ShaderMaterial* material : materials_) material->include(uniform.toUpper(), !depths.empty());
}

void SunLayer::show(const SunDepthMap& map) {
    layDepths(QStringLiteral("sunDepth"), map.depth, map.size);
    layCrowns(QStringLiteral("crownDepth"), map.crowns, map.size);
    layCrowns(QStringLiteral("bareCrownDepth"), map.bareCrowns, map.size);
    set("sunDirection", QVector3D(float(map.towardsSun.x), float(map.towardsSun.y), float(map.towardsSun.z)));
    set("sunColumn", numbersOf(map.column));
    set("sunRow", numbersOf(map.row));
    set("sunHeight", numbersOf(map.height));
    set("sunTexel", float(map.texelM));
    includeSun(materials_, true);
    shown_ = true;
}

void SunLayer::clear() {
    includeSun(materials_, false);
    shown_ = false;
}

}  // namespace noonmark
