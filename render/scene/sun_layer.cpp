#include "render/scene/sun_layer.h"

#include <QVariant>
#include <QVector3D>
#include <QVector4D>

#include "render/scene/picture_texture.h"
#include "render/scene/shader_material.h"

namespace noonmark {

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

void SunLayer::layTexture(const SunDepthMap& map) {
    Qt3DRender::QAbstractTexture* texture = makeTexture(map, parent_);
    set("sunDepth", QVariant::fromValue(texture));
    delete texture_;
    texture_ = texture;
}

void SunLayer::show(const SunDepthMap& map) {
    layTexture(map);
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
