#include "render/view/city_view.h"

#include <QSurfaceFormat>
#include <QTimer>
#include <QVector2D>
#include <QVector4D>
#include <Qt3DCore/QEntity>
#include <Qt3DRender/QCamera>
#include <Qt3DRender/QCameraSelector>
#include <Qt3DRender/QClearBuffers>
#include <Qt3DRender/QClipPlane>
#include <Qt3DRender/QCullFace>
#include <Qt3DRender/QDepthTest>
#include <Qt3DRender/QFilterKey>
#include <Qt3DRender/QLayer>
#include <Qt3DRender/QLayerFilter>
#include <Qt3DRender/QParameter>
#include <Qt3DRender/QRenderCapture>
#include <Qt3DRender/QRenderPassFilter>
#include <Qt3DRender/QRenderSettings>
#include <Qt3DRender/QRenderStateSet>
#include <Qt3DRender/QRenderSurfaceSelector>
#include <Qt3DRender/QTechniqueFilter>
#include <Qt3DRender/QViewport>
#include <algorithm>

#include "render/scene/picture_texture.h"
#include "render/scene/shader_material.h"
#include "render/view/camera_control.h"
#include "render/view/software_drawing.h"

namespace noonmark {

namespace {

constexpr QColor background{0xf3, 0xf5, 0xf7};
constexpr QColor groundColour{0xd8, 0xdb, 0xdf};
constexpr QColor buildingColour{0xf7, 0xf5, 0xf1};
constexpr QColor edgeColour{0x3a, 0x40, 0x4a};
constexpr QColor lineColour{0xd6, 0x3c, 0x1e};
constexpr double viewDeg = 40;
constexpr std::size_t mostEdgesInMotion = 150'000;
constexpr std::size_t mostEdgesBySoftware = 20'000;
constexpr int restMs = 200;
// Without a section box.
const SectionBox everything{glm::dvec3(-1e9), glm::dvec3(1e9)};

QVector3D vectorOf(const glm::dvec3& v) { return {float(v.x), float(v.y), float(v.z)}; }
QVector3D vectorOf(const QColor& c) { return {float(c.redF()), float(c.greenF()), float(c.blueF())}; }

Qt3DRender::QTechniqueFilter* forwardFilter(Qt3DCore::QNode* parent) {
    auto* filter = new Qt3DRender::QTechniqueFilter(parent);
    auto* key = new Qt3DRender::QFilterKey(filter);
    key->setName(QStringLiteral("renderingStyle"));
    key->setValue(QStringLiteral("forward"));
    filter->addMatch(key);
    return filter;
}

GroundPicture noPicture() {
    GroundPicture nothing;
    nothing.grid = {0, 0, 1, 1, 1};
    nothing.pixels.resize(1);
    return nothing;
}

// Puts a picture onto a material, as the uniforms `name` and `name`Box. `texture` is replaced by the new one;
// the old one is deleted.
void layAs(const QString& name, const GroundPicture& given, ShaderMaterial& material,
           Qt3DCore::QNode*& texture, Qt3DCore::QNode* parent) {
    const GroundPicture picture = fitPicture(given);
    const Grid& grid = picture.grid;
    Qt3DCore::QNode* const previous = texture;
    Qt3DRender::QAbstractTexture* made = makeTexture(picture, parent);
    texture = made;
    material.set(name, QVariant::fromValue(made));
    material.set(name + QStringLiteral("Box"),
                 QVector4D(float(grid.westM), float(grid.southM), float(grid.eastM() - grid.westM),
                           float(grid.northM() - grid.southM)));
    material.include(name.toUpper(), true);
    delete previous;
}

void lay(const GroundPicture& picture, bool soFar, ShaderMaterial& material, Qt3DCore::QNode*& texture,
         Qt3DCore::QNode* parent) {
    layAs(QStringLiteral("picture"), picture, material, texture, parent);
    material.set(QStringLiteral("pictureSoFar"), soFar ? 1.0F : 0.0F);
}

}  // namespace

CityView::CityView()
    : Qt3DWindow(nullptr, Qt3DRender::API::OpenGL),
      root_(new Qt3DCore::QEntity),
      blended_(new Qt3DRender::QLayer(root_)),
      rest_(new QTimer(this)),
      names_(new QTimer(this)) {
    // A processor has no time for four samples per pixel.
    if (drawsInSoftware()) {
        QSurfaceFormat plain = format();
        plain.setSamples(0);
        setFormat(plain);
    }
    rest_->setSingleShot(true);
    rest_->setInterval(restMs);
    connect(rest_, &QTimer::timeout, this, [this] { showEdges(true); });
    names_->setSingleShot(true);
    names_->setInterval(restMs);
    connect(names_, &QTimer::timeout, this, [this] { places_->layNames(pose_, lens()); });
    makeMaterials();
    makeFrameGraph();
    renderSettings()->setRenderPolicy(Qt3DRender::QRenderSettings::OnDemand);
    setRootEntity(root_);
    applyCamera();
}

CityView::~CityView() = default;

void CityView::makeFrameGraph() {
    auto* surface = new Qt3DRender::QRenderSurfaceSelector;
    surface->setSurface(this);
    Qt3DRender::QTechniqueFilter* forward = forwardFilter(surface);
    auto* selector = new Qt3DRender::QCameraSelector(new Qt3DRender::QViewport(forward));
    selector->setCamera(this->camera());
    makeClipping(*forward, selector);
    Qt3DRender::QFrameGraphNode* camera = clipping_;
    auto* clear =
        new Qt3DRender::QClearBuffers(drawn(false, false, passes(ShaderMaterial::depthPass, camera)));
    clear->setBuffers(Qt3DRender::QClearBuffers::ColorDepthBuffer);
    clear->setClearColor(background);
    Qt3DRender::QFrameGraphNode* colour = passes(ShaderMaterial::colourPass, camera);
    drawn(false, false, colour);
    drawn(false, true, colour);
    drawn(true, false, colour);
    capture_ = new Qt3DRender::QRenderCapture(drawn(true, true, colour));
    setActiveFrameGraph(surface);
}

// The states replace those that Qt3D sets by itself.
void CityView::makeClipping(Qt3DRender::QTechniqueFilter& forward, Qt3DRender::QFrameGraphNode* parent) {
    clipping_ = new Qt3DRender::QRenderStateSet(parent);
    auto* nearest = new Qt3DRender::QDepthTest;
    nearest->setDepthFunction(Qt3DRender::QDepthTest::Less);
    clipping_->addRenderState(nearest);
    auto* fromOutside = new Qt3DRender::QCullFace;
    fromOutside->setMode(Qt3DRender::QCullFace::Back);
    clipping_->addRenderState(fromOutside);
    sectionLow_ = new Qt3DRender::QParameter(QStringLiteral("sectionLow"), vectorOf(everything.lowM));
    sectionHigh_ = new Qt3DRender::QParameter(QStringLiteral("sectionHigh"), vectorOf(everything.highM));
    for (Qt3DRender::QParameter* side : {sectionLow_, sectionHigh_}) forward.addParameter(side);
}

namespace {

// Six planes of clipping cost time at every vertex, so they are there only with a section box.
void setClipPlanes(Qt3DRender::QRenderStateSet& states, bool wanted) {
    for (Qt3DRender::QRenderState* state : states.renderStates())
        if (auto* plane = qobject_cast<Qt3DRender::QClipPlane*>(state)) {
            states.removeRenderState(plane);
            delete plane;
        }
    for (int plane = 0; wanted && plane < 6; ++plane) {
        auto* clip = new Qt3DRender::QClipPlane(&states);
        clip->setPlaneIndex(plane);
        states.addRenderState(clip);
    }
}

}  // namespace

void CityView::showSection(const std::optional<SectionBox>& box) {
    if (box == section_) return;
    if (section_.has_value() != box.has_value()) setClipPlanes(*clipping_, box.has_value());
    section_ = box;
    showCut();
    const SectionBox drawn = box.value_or(everything);
    sectionLow_->setValue(vectorOf(drawn.lowM));
    sectionHigh_->setValue(vectorOf(drawn.highM));
    Q_EMIT sectionChanged();
}

// The insides of buildings, where a section box cuts them open.
void CityView::showCut() {
    for (BuildingBodies* bodies : {city_.get(), added_.get()})
        if (bodies) bodies->showCut(facesShown_ && section_);
}

// Only the passes of materials with this value of the key "pass".
Qt3DRender::QFrameGraphNode* CityView::passes(const char* pass, Qt3DRender::QFrameGraphNode* parent) {
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
Qt3DRender::QLayerFilter* CityView::drawn(bool overlay, bool blended, Qt3DRender::QFrameGraphNode* parent) {
    for (const auto& [layer, wanted] : {std::pair(overlay_->layer(), overlay), {blended_, blended}}) {
        auto* filter = new Qt3DRender::QLayerFilter(parent);
        filter->setFilterMode(wanted ? Qt3DRender::QLayerFilter::AcceptAnyMatchingLayers
                                     : Qt3DRender::QLayerFilter::DiscardAnyMatchingLayers);
        filter->addLayer(layer);
        parent = filter;
    }
    return static_cast<Qt3DRender::QLayerFilter*>(parent);
}

void CityView::makeMaterials() {
    const auto made = [this](const char* name) {
        return new ShaderMaterial(QString::fromLatin1(name), root_);
    };
    building_ = made("building");
    building_->set(QStringLiteral("baseColour"), vectorOf(buildingColour));
    building_->set(QStringLiteral("haze"), vectorOf(background));
    cut_ = made("cut");
    cut_->fromBehind();
    edge_ = made("edge");
    edge_->set(QStringLiteral("edgeColour"), vectorOf(edgeColour));
    edge_->blend();
    ground_ = made("ground");
    ground_->set(QStringLiteral("groundColour"), vectorOf(groundColour));
    ground_->set(QStringLiteral("haze"), vectorOf(background));
    for (ShaderMaterial* material : {building_, ground_}) material->drawDepthFirst();
    ribbon_ = made("ribbon");
    ribbon_->set(QStringLiteral("lineColour"), QVector4D(vectorOf(lineColour), 0.9F));
    ribbon_->set(QStringLiteral("widthPx"), 2.5F);
    ribbon_->blend();
    ribbon_->alwaysVisible();
    ribbon_->bothSides();
    clearPicture();
    clearMap();
    surfaces_ = std::make_unique<SurfaceLayer>(std::vector{building_, ground_}, root_);
    sun_ = std::make_unique<SunLayer>(std::vector{building_, ground_}, root_);
    tiles_ = std::make_unique<ElementTiles>(blended_, root_);
    overlay_ = std::make_unique<OverlayBodies>(blended_, root_);
    places_ = std::make_unique<PlaceMarks>(overlay_->layer(), blended_, root_);
    sectionMarks_ = std::make_unique<SectionMarks>(overlay_->layer(), blended_, root_);
    places_->onChange([this] { names_->start(); });
}

Qt3DCore::QEntity* CityView::add(Qt3DRender::QGeometryRenderer* geometry, ShaderMaterial* material,
                                 Qt3DRender::QLayer* layer) {
    auto* entity = new Qt3DCore::QEntity(root_);
    entity->addComponent(geometry);
    entity->addComponent(material);
    if (layer) entity->addComponent(layer);
    return entity;
}

void CityView::showGround(const CityArrays& arrays) {
    delete groundEntity_;
    auto* ground = new ArrayGeometry(Qt3DRender::QGeometryRenderer::Triangles);
    ground->addPoints(QStringLiteral("vertexPosition"), arrays.groundPoints);
    ground->setIndices(arrays.groundTriangles);
    groundEntity_ = add(ground, ground_);
}

void CityView::showCity(std::shared_ptr<const CityArrays> arrays) {
    showLines({});
    clearPicture();
    surfaces_->clear();
    tiles_->clear();
    added_.reset();
    bounds_ = arrays->bounds;
    showGround(*arrays);
    manyEdges_ = arrays->edges.size() > (drawsInSoftware() ? mostEdgesBySoftware : mostEdgesInMotion);
    city_ = std::make_unique<BuildingBodies>(std::move(arrays), *building_, *cut_, *edge_, blended_, root_);
    city_->showFaces(facesShown_);
    showCut();
    setPose(wholeCity(bounds_, lens()));
}

void CityView::showChanges(const ArrayDifference& changes) {
    if (!city_) return;
    city_->leaveOut(changes.gone);
    added_ = std::make_unique<BuildingBodies>(
        std::make_shared<const CityArrays>(makeBuildingArrays(changes.added)), *building_, *cut_, *edge_,
        blended_, root_);
    added_->showFaces(facesShown_);
    showCut();
    bounds_ = city_->arrays()->bounds;
    for (const auto& building : changes.added.buildings) {
        bounds_.topM = std::max(bounds_.topM, topM(*building));
        bounds_.box.add(noonmark::bounds(*building));
    }
    applyCamera();
}

std::shared_ptr<const CityArrays> CityView::arrays() const { return city_ ? city_->arrays() : nullptr; }

void CityView::showFaces(bool shown) {
    facesShown_ = shown;
    showEdges(true);
    for (BuildingBodies* bodies : {city_.get(), added_.get()})
        if (bodies) bodies->showFaces(shown);
    showCut();
}

void CityView::showPicture(const GroundPicture& picture, bool soFar) {
    lay(picture, soFar, *ground_, texture_, root_);
    building_->include(QStringLiteral("PICTURE"), false);  // the texture stays until the next picture
}

void CityView::showRoofPicture(const GroundPicture& picture) {
    lay(picture, false, *building_, roofTexture_, root_);
}

void CityView::showMap(const GroundPicture& picture) {
    layAs(QStringLiteral("map"), picture, *ground_, mapTexture_, root_);
}

void CityView::clearMap() {
    showMap(noPicture());
    ground_->include(QStringLiteral("MAP"), false);
}

void CityView::clearPicture() {
    showPicture(noPicture());
    ground_->include(QStringLiteral("PICTURE"), false);
}

void CityView::showLines(const std::vector<GroundLine>& lines) {
    delete lines_;
    lines_ = nullptr;
    if (!lines.empty()) lines_ = add(makeOutlineGeometry(lines), ribbon_, blended_);
}

void CityView::setPose(const CameraPose& pose) {
    pose_ = pose;
    applyCamera();
    // In software rendering lines cost most, so a large city hides them while the camera moves.
    if (manyEdges_ && facesShown_) {
        showEdges(false);
        rest_->start();
    }
    Q_EMIT poseChanged();
}

void CityView::showEdges(bool shown) {
    rest_->stop();
    if (city_) city_->showEdges(shown);
}

ViewLens CityView::lens() const {
    return {viewDeg, double(std::max(1, width())), double(std::max(1, height()))};
}

void CityView::applyCamera() {
    const ClipRange clip = computeClipRange(pose_, bounds_);
    const ViewLens view = lens();
    const bool parallel = pose_.isParallel();
    const auto halfHeightM = float(metresPerPixel(pose_, view) * view.heightPx / 2);
    const auto aspect = float(view.widthPx / view.heightPx);
    if (parallel)
        camera()->lens()->setOrthographicProjection(-halfHeightM * aspect, halfHeightM * aspect, -halfHeightM,
                                                    halfHeightM, float(clip.nearM), float(clip.farM));
    else
        camera()->lens()->setPerspectiveProjection(float(viewDeg), aspect, float(clip.nearM),
                                                   float(clip.farM));
    // Nothing is far away in a parallel projection.
    const auto haze = parallel ? 1e9F : float(5 * bounds_.radiusM());
    for (ShaderMaterial* material : {building_, edge_, ground_})
        material->set(QStringLiteral("hazeDistance"), haze);
    camera()->setPosition(vectorOf(computeEye(pose_)));
    camera()->setViewCenter(vectorOf(pose_.target));
    camera()->setUpVector(vectorOf(computeUp(pose_)));
    ribbon_->set(QStringLiteral("viewSize"), QVector2D(float(view.widthPx), float(view.heightPx)));
    overlay_->setLens(pose_, view);
    places_->setLens(view);
    tiles_->setLens(view);
    sectionMarks_->setLens(pose_, view);
    names_->start();
}

void CityView::resizeEvent(QResizeEvent* event) {
    Qt3DWindow::resizeEvent(event);
    applyCamera();
    Q_EMIT poseChanged();
}

// After another window covered this one, only a new frame restores the picture. A frame is drawn only after a
// change, so this sets a property that no shader reads.
void CityView::exposeEvent(QExposeEvent* event) {
    Qt3DWindow::exposeEvent(event);
    exposed_ = !exposed_;
    ground_->set(QStringLiteral("exposed"), exposed_ ? 1.0F : 0.0F);
}

void CityView::capture(std::function<void(QImage)> done) {
    showEdges(true);
    places_->layNames(pose_, lens());
    Qt3DRender::QRenderCaptureReply* reply = capture_->requestCapture();
    connect(reply, &Qt3DRender::QRenderCaptureReply::completed, this, [reply, done = std::move(done)] {
        const QImage image = reply->image();
        reply->deleteLater();
        done(image);
    });
}

}  // namespace noonmark
