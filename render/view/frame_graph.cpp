#include "render/view/frame_graph.h"

#include <QOffscreenSurface>
#include <QWindow>
#include <Qt3DRender/QCamera>
#include <Qt3DRender/QCameraSelector>
#include <Qt3DRender/QClearBuffers>
#include <Qt3DRender/QClipPlane>
#include <Qt3DRender/QCullFace>
#include <Qt3DRender/QDepthTest>
#include <Qt3DRender/QFilterKey>
#include <Qt3DRender/QLayer>
#include <Qt3DRender/QLayerFilter>
#include <Qt3DRender/QNoDraw>
#include <Qt3DRender/QParameter>
#include <Qt3DRender/QRenderCapture>
#include <Qt3DRender/QRenderPassFilter>
#include <Qt3DRender/QRenderStateSet>
#include <Qt3DRender/QRenderSurfaceSelector>
#include <Qt3DRender/QRenderTarget>
#include <Qt3DRender/QRenderTargetOutput>
#include <Qt3DRender/QRenderTargetSelector>
#include <Qt3DRender/QScissorTest>
#include <Qt3DRender/QSubtreeEnabler>
#include <Qt3DRender/QTechniqueFilter>
#include <Qt3DRender/QTexture>
#include <Qt3DRender/QViewport>

#include "render/scene/qt_vectors.h"
#include "render/scene/shader_material.h"

namespace noonmark {

namespace {

// Without a section box.
const SectionBox everything{glm::dvec3(-1e9), glm::dvec3(1e9)};

Qt3DRender::QTechniqueFilter* forwardFilter(Qt3DCore::QNode* parent) {
    auto* filter = new Qt3DRender::QTechniqueFilter(parent);
    auto* key = new Qt3DRender::QFilterKey(filter);
    key->setName(QStringLiteral("renderingStyle"));
    key->setValue(QStringLiteral("forward"));
    filter->addMatch(key);
    return filter;
}

Qt3DRender::QLayerFilter* filterLayer(Qt3DRender::QLayer* layer, bool wanted,
                                      Qt3DRender::QFrameGraphNode* parent) {
    auto* filter = new Qt3DRender::QLayerFilter(parent);
    filter->setFilterMode(wanted ? Qt3DRender::QLayerFilter::AcceptAnyMatchingLayers
                                 : Qt3DRender::QLayerFilter::DiscardAnyMatchingLayers);
    filter->addLayer(layer);
    return filter;
}

// The states replace those that Qt3D sets by itself.
Qt3DRender::QRenderStateSet* makeStates(Qt3DRender::QFrameGraphNode* parent) {
    auto* states = new Qt3DRender::QRenderStateSet(parent);
    auto* nearest = new Qt3DRender::QDepthTest;
    nearest->setDepthFunction(Qt3DRender::QDepthTest::Less);
    states->addRenderState(nearest);
    auto* fromOutside = new Qt3DRender::QCullFace;
    fromOutside->setMode(Qt3DRender::QCullFace::Back);
    states->addRenderState(fromOutside);
    return states;
}

template <class State>
void removeStates(Qt3DRender::QRenderStateSet& states) {
    for (Qt3DRender::QRenderState* state : states.renderStates())
        if (auto* found = qobject_cast<State*>(state)) {
            states.removeRenderState(found);
            delete found;
        }
}

// Six planes of clipping cost time at every vertex, so they are there only with a section box.
void setClipPlanes(Qt3DRender::QRenderStateSet& states, bool wanted) {
    removeStates<Qt3DRender::QClipPlane>(states);
    for (int plane = 0; wanted && plane < 6; ++plane) {
        auto* clip = new Qt3DRender::QClipPlane(&states);
        clip->setPlaneIndex(plane);
        states.addRenderState(clip);
    }
}

// Draws only these columns of the window.
void setScissors(Qt3DRender::QRenderStateSet& states, bool wanted, const SideColumns& columns, int heightPx) {
    removeStates<Qt3DRender::QScissorTest>(states);
    if (!wanted) return;
    auto* scissors = new Qt3DRender::QScissorTest(&states);
    scissors->setLeft(columns.first);
    scissors->setBottom(0);
    scissors->setWidth(columns.last - columns.first);
    scissors->setHeight(heightPx);
    states.addRenderState(scissors);
}

Qt3DRender::QRenderSurfaceSelector* makeSurface(QWindow* window) {
    auto* selector = new Qt3DRender::QRenderSurfaceSelector;
    selector->setSurface(window);
    return selector;
}

Qt3DRender::QAbstractTexture* addOutput(Qt3DRender::QRenderTarget& target,
                                        Qt3DRender::QRenderTargetOutput::AttachmentPoint point,
                                        Qt3DRender::QAbstractTexture::TextureFormat format, QSize size) {
    auto* output = new Qt3DRender::QRenderTargetOutput(&target);
    auto* texture = new Qt3DRender::QTexture2D(output);
    texture->setFormat(format);
    texture->setSize(size.width(), size.height());
    texture->setGenerateMipMaps(false);
    output->setAttachmentPoint(point);
    output->setTexture(texture);
    target.addOutput(output);
    return texture;
}

Qt3DRender::QRenderTarget* makePicture(QSize size, Qt3DCore::QNode* parent) {
    auto* target = new Qt3DRender::QRenderTarget(parent);
    addOutput(*target, Qt3DRender::QRenderTargetOutput::Color0, Qt3DRender::QAbstractTexture::RGBA8_UNorm,
              size);
    addOutput(*target, Qt3DRender::QRenderTargetOutput::DepthStencil, Qt3DRender::QAbstractTexture::D24S8,
              size);
    return target;
}

}  // namespace

FrameGraph::FrameGraph(QWindow* surface, Qt3DRender::QCamera* camera, const ViewLayers& layers)
    : window_(surface),
      surface_(makeSurface(surface)),
      coarseEnabler_(new Qt3DRender::QSubtreeEnabler(surface_)),
      root_(new Qt3DRender::QRenderTargetSelector(surface_)),
      layers_(layers),
      sectionLow_(new Qt3DRender::QParameter(QStringLiteral("sectionLow"), toVector(everything.lowM), root_)),
      sectionHigh_(
          new Qt3DRender::QParameter(QStringLiteral("sectionHigh"), toVector(everything.highM), root_)) {
    makeCoarse(camera);
    clearAll();
    sides_ = {makeSide(camera, layers.sides[1]), makeSide(camera, layers.sides[0])};
    makeCapture();
    setSides({}, {});
}

FrameGraph::~FrameGraph() = default;

Qt3DRender::QFrameGraphNode* FrameGraph::root() const { return surface_; }

void FrameGraph::drawInto(const std::optional<QSize>& picture) {
    Qt3DRender::QRenderTarget* const before = picture_;
    picture_ = picture ? makePicture(*picture, root_) : nullptr;
    if (picture && !offscreen_) {
        offscreen_ = std::make_unique<QOffscreenSurface>();
        offscreen_->setFormat(window_->format());
        offscreen_->create();
    }
    root_->setTarget(picture_);
    surface_->setExternalRenderTargetSize(picture.value_or(QSize()));
    surface_->setSurface(picture ? static_cast<QObject*>(offscreen_.get()) : window_);
    surface_->setSurfacePixelRatio(picture ? 1.0F : float(window_->devicePixelRatio()));
    delete before;
}

// Each pixel is coloured once and has its depth written, so nothing is cleared or compared.
void FrameGraph::makeCoarse(Qt3DRender::QCamera* camera) {
    coarseEnabler_->setEnabled(false);
    auto* selector = new Qt3DRender::QRenderTargetSelector(coarseEnabler_);
    auto* target = new Qt3DRender::QRenderTarget(selector);
    using Output = Qt3DRender::QRenderTargetOutput;
    using Texture = Qt3DRender::QAbstractTexture;
    coarse_.colour = addOutput(*target, Output::Color0, Texture::RGBA8_UNorm, {1, 1});
    coarse_.depth = addOutput(*target, Output::Depth, Texture::D32F, {1, 1});
    selector->setTarget(target);
    auto* viewport = new Qt3DRender::QViewport(forwardFilter(selector));
    auto* eye = new Qt3DRender::QCameraSelector(viewport);
    eye->setCamera(camera);
    auto* states = new Qt3DRender::QRenderStateSet(eye);
    auto* always = new Qt3DRender::QDepthTest;
    always->setDepthFunction(Qt3DRender::QDepthTest::Always);
    states->addRenderState(always);
    filterLayer(layers_.coarse, true, passes(ShaderMaterial::colourPass, states));
}

void FrameGraph::drawCoarse(const std::optional<QSize>& size) {
    coarseEnabler_->setEnabled(size.has_value());
    if (!size) return;
    for (Qt3DRender::QAbstractTexture* texture : {coarse_.colour, coarse_.depth})
        texture->setSize(size->width(), size->height());
}

void FrameGraph::clearAll() {
    auto* clear = new Qt3DRender::QClearBuffers(root_);
    // Software drawing clears all three together several times faster than without the stencil.
    clear->setBuffers(Qt3DRender::QClearBuffers::ColorDepthStencilBuffer);
    clear->setClearColor(backgroundColour);
    new Qt3DRender::QNoDraw(clear);
}

// Last, and drawing nothing itself: no node has its layer.
void FrameGraph::makeCapture() {
    auto* none = new Qt3DRender::QLayer(root_);
    capture_ = new Qt3DRender::QRenderCapture(filterLayer(none, true, root_));
}

FrameGraph::Side FrameGraph::makeSide(Qt3DRender::QCamera* camera, Qt3DRender::QLayer* hidden) {
    auto* enabler = new Qt3DRender::QSubtreeEnabler(root_);
    Qt3DRender::QTechniqueFilter* forward = forwardFilter(enabler);
    for (Qt3DRender::QParameter* side : {sectionLow_, sectionHigh_}) forward->addParameter(side);
    auto* viewport = new Qt3DRender::QViewport(forward);
    auto* selector = new Qt3DRender::QCameraSelector(viewport);
    selector->setCamera(camera);
    Qt3DRender::QRenderStateSet* states = makeStates(selector);
    drawSide(filterLayer(layers_.coarse, false, filterLayer(hidden, false, states)));
    return {enabler, viewport, states};
}

void FrameGraph::drawSide(Qt3DRender::QFrameGraphNode* side) {
    draw(false, false, passes(ShaderMaterial::depthPass, side));
    Qt3DRender::QFrameGraphNode* colour = passes(ShaderMaterial::colourPass, side);
    draw(false, false, colour);
    draw(false, true, colour);
    draw(true, false, colour);
    draw(true, true, colour);
}

// Only the passes of materials with this value of the key "pass".
Qt3DRender::QFrameGraphNode* FrameGraph::passes(const char* pass, Qt3DRender::QFrameGraphNode* parent) {
    auto* filter = new Qt3DRender::QRenderPassFilter(parent);
    auto* key = new Qt3DRender::QFilterKey(filter);
    key->setName(QStringLiteral("pass"));
    key->setValue(QString::fromLatin1(pass));
    filter->addMatch(key);
    return filter;
}

// One branch of the frame graph: the city or the overlay, and within it the faces or the blended nodes.
// Within a branch Qt3D draws in an order of its own, which varies between cities. Blended nodes do not write
// depth, so faces drawn later would cover them.
void FrameGraph::draw(bool overlay, bool blended, Qt3DRender::QFrameGraphNode* parent) {
    filterLayer(layers_.blended, blended, filterLayer(layers_.overlay, overlay, parent));
}

void FrameGraph::showSection(const std::optional<SectionBox>& box) {
    if (clipped_ != box.has_value())
        for (const Side& side : sides_) setClipPlanes(*side.states, box.has_value());
    clipped_ = box.has_value();
    const SectionBox drawn = box.value_or(everything);
    sectionLow_->setValue(toVector(drawn.lowM));
    sectionHigh_->setValue(toVector(drawn.highM));
}

void FrameGraph::setSides(const ViewSides& sides, QSize size) {
    sides_[1].enabler->setEnabled(sides.layout != SideLayout::one);
    for (int i = 0; i < 2; ++i) {
        const Side& side = sides_[std::size_t(i)];
        const bool beside = sides.layout == SideLayout::beside;
        side.viewport->setNormalizedRect(beside ? QRectF(i == 0 ? 0.5 : 0.0, 0, 0.5, 1) : QRectF(0, 0, 1, 1));
        setScissors(*side.states, sides.layout != SideLayout::one, columnsOf(sides, i, size.width()),
                    size.height());
    }
}

}  // namespace noonmark
