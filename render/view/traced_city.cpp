#include "render/view/traced_city.h"

#include <QByteArray>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QVector2D>
#include <QVector3D>
#include <algorithm>
#include <array>
#include <iterator>

#include "core/city/building_heights.h"
#include "render/scene/array_entity.h"
#include "render/scene/picture_texture.h"
#include "render/scene/qt_vectors.h"
#include "render/scene/shader_material.h"
#include "render/view/explored_view.h"
#include "render/view/frame_graph.h"

namespace noonmark {

namespace {

QByteArray askRenderer() {
    QOffscreenSurface surface;
    surface.create();
    QOpenGLContext context;
    if (!context.create() || !context.makeCurrent(&surface)) return {};
    const auto* name = reinterpret_cast<const char*>(context.functions()->glGetString(GL_RENDERER));
    const QByteArray renderer(name);
    context.doneCurrent();
    return renderer.toLower();
}

}  // namespace

bool drawsInSoftware() {
    static const bool software = [] {
        const QByteArray renderer = askRenderer();
        constexpr std::array<const char*, 4> names{"llvmpipe", "softpipe", "swiftshader", "software"};
        return std::ranges::any_of(names, [&](const char* name) { return renderer.contains(name); });
    }();
    return software;
}

namespace {

// A triangle that covers the picture.
ArrayGeometry* makeWholePicture() {
    auto* geometry = new ArrayGeometry(Qt3DRender::QGeometryRenderer::Triangles);
    geometry->addPoints(QStringLiteral("vertexPosition"), {{-1, -1, 0}, {3, -1, 0}, {-1, 3, 0}});
    geometry->setIndices({0, 1, 2});
    return geometry;
}

Qt3DCore::QEntity* makePixels(ShaderMaterial& material, Qt3DRender::QLayer* side, Qt3DCore::QEntity* parent) {
    Qt3DCore::QEntity* entity = makeArrayEntity(makeWholePicture(), material, parent, side);
    entity->setEnabled(false);
    return entity;
}

PixelCamera makeTracedCamera(const TracedCity::Picture& picture) {
    PixelCamera camera = makeExploredCamera(picture.pose, picture.lens, picture.spacingPx);
    if (const auto& section = picture.section)
        camera.section = VisibleBox{glm::vec3(section->lowM), glm::vec3(section->highM)};
    return camera;
}

// OpenGL's depth buffer, from 0 at the near to 1 at the far plane: x + y / depth; x + y * depth if parallel.
QVector2D depthScale(const CameraPose& pose, const ClipRange& clip) {
    const double range = clip.farM - clip.nearM;
    if (pose.isParallel()) return {float(-clip.nearM / range), float(1 / range)};
    return {float(clip.farM / range), float(-clip.farM * clip.nearM / range)};
}

}  // namespace

TracedCity::TracedCity(Qt3DRender::QLayer* side, Qt3DCore::QEntity* parent)
    : parent_(parent),
      side_(side),
      material_(new ShaderMaterial(QStringLiteral("traced"), parent)),
      pixels_(makePixels(*material_, side, parent)) {
    const CrownColours trees;
    set("evergreenColour", toVector(trees.evergreen));
    set("leafyColour", toVector(trees.leafy));
    set("trunkColour", toVector(trees.trunk));
    set("branchColour", toVector(trees.branches));
}

void TracedCity::setScene(RayScene scene, Buildings buildings, Ground ground) {
    scene_ = std::move(scene);
    buildings_ = std::move(buildings);
    ground_ = std::move(ground);
    hidden_.clear();
    proposed_.clear();
    for (const auto& building : buildings_) proposed_.push_back(isProposal(*building) ? 1 : 0);
}

void TracedCity::clear() {
    show(false);
    scene_.reset();
    crowns_.reset();
    buildings_.clear();
}

bool TracedCity::showOnly(std::vector<const Building*> shown) {
    std::ranges::sort(shown);
    hidden_.assign(buildings_.size(), 0);
    std::size_t seen = 0;
    for (std::size_t i = 0; i < buildings_.size(); ++i) {
        hidden_[i] = std::ranges::binary_search(shown, buildings_[i].get()) ? 0 : 1;
        seen += 1U - hidden_[i];
    }
    return seen == shown.size();
}

void TracedCity::setCoarse(Qt3DRender::QLayer* layer, const CoarsePicture& picture) {
    coarsePixels_ = makePixels(*material_, layer, parent_);
    copyMaterial_ = new ShaderMaterial(QStringLiteral("traced"), QStringLiteral("coarse"), parent_);
    copyMaterial_->set(QStringLiteral("coarseColour"), QVariant::fromValue(picture.colour));
    copyMaterial_->set(QStringLiteral("coarseDepth"), QVariant::fromValue(picture.depth));
    copy_ = makePixels(*copyMaterial_, side_, parent_);
}

void TracedCity::show(bool shown) {
    shown_ = shown;
    showPixels();
}

void TracedCity::showPixels() {
    pixels_->setEnabled(shown_ && !isCoarse_);
    for (Qt3DCore::QEntity* entity : {coarsePixels_, copy_})
        if (entity) entity->setEnabled(shown_ && isCoarse_);
}

void TracedCity::setSun(const std::optional<glm::vec3>& towardsSun) {
    towardsSun_ = towardsSun;
    material_->include(QStringLiteral("SUNLIT"), towardsSun.has_value());
    if (towardsSun) set("sunDirection", toVector(glm::dvec3(*towardsSun)));
}

void TracedCity::trace(const Picture& picture) {
    if (!scene_ || picture.columns.last <= picture.columns.first) return;
    const CameraPose& pose = picture.pose;
    const PixelCamera camera = makeTracedCamera(picture);
    std::vector<TracedTrees> trees;
    if (crowns_ && picture.treeDay > 0) trees = listTraced(*crowns_, picture.treeDay);
    traceView(*scene_, camera,
              {.groundM = ground_.levelM,
               .terrain = ground_.terrain.get(),
               .nearM = float(picture.clip.nearM),
               .farM = float(picture.clip.farM),
               .firstColumn = picture.columns.first,
               .lastColumn = picture.columns.last,
               .hidden = hidden_,
               .marked = proposed_,
               .towardsSun = towardsSun_,
               .trees = trees},
              view_);
    const double pixel = 1 / samplesPerMetre(camera, 1);
    set("tracedEye", toVector(camera.eye));
    set("tracedForward", toVector(camera.forward));
    set("tracedRight", toVector(camera.right * pixel));
    set("tracedUp", toVector(camera.up * pixel));
    set("tracedClip", depthScale(pose, picture.clip));
    set("tracedParallel", pose.isParallel() ? 1.0F : 0.0F);
    set("tracedLeft", float(picture.leftPx));
    set("tracedSpacing", picture.isCoarse ? 1.0F : float(picture.spacingPx));
    if (copyMaterial_) copyMaterial_->set(QStringLiteral("coarseSpacing"), float(picture.spacingPx));
    isCoarse_ = picture.isCoarse;
    showPixels();
    layTexture();
}

void TracedCity::set(const char* uniform, const QVariant& value) {
    material_->set(QString::fromLatin1(uniform), value);
}

void TracedCity::layTexture() {
    if (texture_ && texture_->width() == view_.widthPx && texture_->height() == view_.heightPx)
        return replaceTexture(*texture_, view_);
    Qt3DRender::QAbstractTexture* made = makeTexture(view_, parent_);
    set("traced", QVariant::fromValue(made));
    delete texture_;
    texture_ = made;
}

}  // namespace noonmark
