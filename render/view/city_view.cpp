#include "render/view/city_view.h"

#include <QSurfaceFormat>
#include <QTimer>
#include <QVector2D>
#include <QVector4D>
#include <Qt3DCore/QEntity>
#include <Qt3DLogic/QFrameAction>
#include <Qt3DRender/QCamera>
#include <Qt3DRender/QLayer>
#include <Qt3DRender/QRenderCapture>
#include <Qt3DRender/QRenderSettings>
#include <algorithm>
#include <cmath>
#include <utility>

#include "render/scene/array_entity.h"
#include "render/scene/qt_vectors.h"
#include "render/scene/shader_material.h"
#include "render/view/camera_control.h"
#include "render/view/frame_graph.h"
#include "render/view/traced_city.h"

namespace noonmark {

namespace {

constexpr QColor lineColour{0xd6, 0x3c, 0x1e, 230};
constexpr QColor demolishedColour{0x4a, 0x4d, 0x57, 230};
constexpr double viewDeg = 40;
constexpr int restMs = 200;
constexpr double hazeDistances = 4;
constexpr int movingSpacingPx = 2;

/// The picture in which so many pixels a side are one: as makeExploredCamera() has it.
QSize sharedBy(const ViewLens& lens, int pixels) {
    const int height = std::max(1, int(std::ceil(lens.heightPx / pixels)));
    return {std::max(1, int(std::ceil(lens.widthPx * height / lens.heightPx))), height};
}

ViewLens inDevicePixels(ViewLens lens, double ratio) {
    lens.widthPx = std::round(lens.widthPx * ratio);
    lens.heightPx = std::round(lens.heightPx * ratio);
    return lens;
}

}  // namespace

CityView::CityView()
    : Qt3DWindow(nullptr, Qt3DRender::API::OpenGL),
      root_(new Qt3DCore::QEntity),
      blended_(new Qt3DRender::QLayer(root_)),
      sideLayers_{new Qt3DRender::QLayer(root_), new Qt3DRender::QLayer(root_)},
      displayed_(blended_, sideLayers_[0], root_),
      other_(blended_, sideLayers_[1], root_),
      lines_(lineColour, 2.5F, blended_, root_),
      regionLines_(lineColour, 1.3F, blended_, root_, GroundLines::Behind::hidden),
      demolished_(demolishedColour, 1.8F, blended_, root_),
      divider_(blended_, sideLayers_, root_),
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
    connect(rest_, &QTimer::timeout, this, &CityView::showEdges);
    names_->setSingleShot(true);
    names_->setInterval(restMs);
    connect(names_, &QTimer::timeout, this, [this] {
        restCamera();
        places_->layNames(pose_, lens());
        dome_->layNames(pose_, lens());
    });
    makeLayers();
    auto* coarse = new Qt3DRender::QLayer(root_);
    frames_ = std::make_unique<FrameGraph>(this, camera(),
                                           ViewLayers{overlay_->layer(), blended_, sideLayers_, coarse});
    displayed_.traced().setCoarse(coarse, frames_->coarsePicture());
    setActiveFrameGraph(frames_->root());
    followFrames();
    renderSettings()->setRenderPolicy(Qt3DRender::QRenderSettings::OnDemand);
    setRootEntity(root_);
    applyCamera();
}

CityView::~CityView() = default;

// A frame is traced once, however often the camera moved since the last one.
void CityView::followFrames() {
    auto* frame = new Qt3DLogic::QFrameAction;
    root_->addComponent(frame);
    connect(frame, &Qt3DLogic::QFrameAction::triggered, this, [this] {
        if (cameraMoved_) applyCamera();
    });
}

void CityView::makeLayers() {
    for (Qt3DRender::QLayer* side : sideLayers_) side->setRecursive(true);
    tiles_ = std::make_unique<ElementTiles>(blended_, root_);
    overlay_ = std::make_unique<OverlayBodies>(blended_, sideLayers_[0], root_);
    constexpr QColor markedColour{0x2f, 0x7d, 0xe0};  // as what is selected
    markedTrees_ = std::make_unique<CrownBodies>(blended_, sideLayers_[0], root_,
                                                 CrownColours{markedColour, markedColour});
    places_ = std::make_unique<PlaceMarks>(overlay_->layer(), blended_, root_);
    dome_ = std::make_unique<DomeMarks>(overlay_->layer(), blended_, root_);
    pointMarks_ = std::make_unique<PointMarks>(overlay_->layer(), blended_, root_);
    sectionMarks_ = std::make_unique<SectionMarks>(overlay_->layer(), blended_, root_);
    places_->onChange([this] { names_->start(); });
}

void CityView::showSection(const std::optional<SectionBox>& box) {
    if (box == section_) return;
    section_ = box;
    frames_->showSection(box);
    for (DrawnCity* city : {&displayed_, &other_}) city->showCut(box.has_value());
    cameraMoved_ = true;
    Q_EMIT sectionChanged();
}

void CityView::setRays(RayScene scene, const std::vector<std::shared_ptr<const Building>>& buildings) {
    displayed_.setRays(std::move(scene), buildings);
    reportTraced();
    moving_ = isTraced();  // the first picture compiles what the first movement needs
    refresh();
}

void CityView::showOther(const ArrayDifference& changes, std::optional<RayScene> rays,
                         const std::vector<std::shared_ptr<const Building>>& buildings) {
    if (other_.arrays() != arrays()) other_.showCity(arrays());
    other_.showChanges(changes);
    if (rays) other_.setRays(*std::move(rays), buildings);
    refresh();
}

// A picture by rays waits for the next frame.
void CityView::refresh() { isTraced() ? void(cameraMoved_ = true) : applyCamera(); }

void CityView::clearRays() {
    for (DrawnCity* city : {&displayed_, &other_}) city->clearRays();
    reportTraced();
}

void CityView::reportTraced() {
    if (std::exchange(traced_, isTraced()) != isTraced()) Q_EMIT tracedChanged();
}

void CityView::showTracedSun(const std::optional<glm::dvec3>& towardsSun) {
    for (DrawnCity* city : {&displayed_, &other_}) city->setTracedSun(towardsSun);
    cameraMoved_ = true;
}

void CityView::showCity(std::shared_ptr<const CityArrays> arrays) {
    showLines({});
    showDemolished({});
    pointMarks_->show({});
    pointMarks_->showSnap({});
    tiles_->clear();
    other_.clear();
    setSides({});
    displayed_.showCity(std::move(arrays));
    reportTraced();
    setPose(wholeCity(mainBounds(), lens()));
}

void CityView::showChanges(const ArrayDifference& changes) {
    displayed_.showChanges(changes);
    refresh();
}

void CityView::setSides(const ViewSides& sides) {
    if (sides == sides_) return;
    const bool otherLens = std::exchange(sides_, sides).layout != sides.layout;
    cameraMoved_ = true;
    applySides();
    if (otherLens) Q_EMIT poseChanged();
}

void CityView::applySides() {
    frames_->setSides(sides_, (drawnSize() * drawnRatio()).toSize());
    divider_.show(sides_, int(std::lround(drawnSize().width())));
}

double CityView::sideOffset(QPointF position) const {
    const bool right = sides_.layout == SideLayout::beside && position.x() >= width() / 2.0;
    return right ? width() / 2.0 : 0;
}

void CityView::showTrees(std::shared_ptr<const Trees> trees, std::shared_ptr<const CrownRays> rays) {
    displayed_.showTrees(std::move(trees), std::move(rays));
    refresh();
}

void CityView::setTreeDay(int dayOfYear) {
    if (dayOfYear == displayed_.crowns().day()) return;
    for (DrawnCity* city : {&displayed_, &other_}) city->crowns().setDay(dayOfYear);
    refresh();
}

void CityView::setTreesVisible(bool visible) {
    for (DrawnCity* city : {&displayed_, &other_}) city->crowns().setVisible(visible);
    refresh();
    Q_EMIT treesToggled();
}

void CityView::showFaces(bool shown) {
    for (DrawnCity* city : {&displayed_, &other_}) city->showFaces(shown);
    rest_->stop();
    reportTraced();
    cameraMoved_ = true;
}

void CityView::showMap(const GroundPicture& picture) {
    for (DrawnCity* city : {&displayed_, &other_}) city->showMap(picture);
}

void CityView::clearMap() {
    for (DrawnCity* city : {&displayed_, &other_}) city->clearMap();
}

void CityView::showFinerMap(const GroundPicture& picture) {
    for (DrawnCity* city : {&displayed_, &other_}) city->showFinerMap(picture);
}

void CityView::clearFinerMap() {
    for (DrawnCity* city : {&displayed_, &other_}) city->clearFinerMap();
}

void CityView::showLines(const std::vector<GroundLine>& lines) { lines_.show(lines); }

void CityView::showRegion(const std::vector<GroundLine>& lines) { regionLines_.show(lines); }

void CityView::showDemolished(const std::vector<GroundLine>& lines) { demolished_.show(lines); }

void CityView::setPose(const CameraPose& pose) {
    moving_ = isTraced() && pose != pose_;
    pose_ = pose;
    refresh();
    if (displayed_.hideEdges() | other_.hideEdges()) rest_->start();
    Q_EMIT poseChanged();
}

void CityView::restCamera() {
    if (std::exchange(moving_, false)) applyCamera();
}

void CityView::showEdges() {
    rest_->stop();
    for (DrawnCity* city : {&displayed_, &other_}) city->showEdges();
}

// Device-independent pixels.
QSizeF CityView::drawnSize() const {
    return picture_ ? QSizeF(picture_->pixels) / picture_->ratio : QSizeF(width(), height());
}

double CityView::drawnRatio() const { return picture_ ? picture_->ratio : devicePixelRatio(); }

ViewLens CityView::lens() const {
    const QSizeF size = drawnSize();
    const double sideWidth =
        sides_.layout == SideLayout::beside ? std::floor(size.width() / 2) : size.width();
    return {viewDeg, std::max(1.0, sideWidth), std::max(1.0, size.height())};
}

void CityView::applyCamera() {
    const ViewBounds bounds = drawnBounds();
    const ClipRange clip = computeClipRange(pose_, bounds);
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
    // Nothing is far away in a parallel projection, and what the camera looks at never fades.
    const auto haze =
        parallel ? 1e9F : float(std::max(5 * mainBounds().radiusM(), hazeDistances * pose_.distanceM));
    for (DrawnCity* city : {&displayed_, &other_}) city->setHaze(haze);
    camera()->setPosition(toVector(computeEye(pose_)));
    camera()->setViewCenter(toVector(pose_.target));
    camera()->setUpVector(toVector(computeUp(pose_)));
    for (GroundLines* lines : {&lines_, &regionLines_, &demolished_})
        lines->setViewSize({float(view.widthPx), float(view.heightPx)});
    overlay_->setLens(pose_, view);
    places_->setLens(view);
    pointMarks_->setViewSize({float(view.widthPx), float(view.heightPx)});
    dome_->setLens(pose_, view);
    tiles_->setLens(view);
    sectionMarks_->setLens(pose_, view);
    names_->start();
    cameraMoved_ = false;
    trace(clip);
}

ViewBounds CityView::mainBounds() const {
    ViewBounds bounds = displayed_.bounds();
    if (const auto drawn = arrays(); drawn && !drawn->mainPart.box.empty()) bounds.box = drawn->mainPart.box;
    return bounds;
}

ViewBounds CityView::drawnBounds() const {
    ViewBounds bounds = displayed_.bounds();
    if (sides_.layout == SideLayout::one) return bounds;
    bounds.topM = std::max(bounds.topM, other_.bounds().topM);
    if (!other_.bounds().box.empty()) bounds.box.add(other_.bounds().box);
    return bounds;
}

void CityView::trace(const ClipRange& clip) {
    const ViewLens view = inDevicePixels(lens(), drawnRatio());
    const int windowPx = int(std::lround(drawnSize().width() * drawnRatio()));
    const bool beside = sides_.layout == SideLayout::beside;
    // Two sides share pixels only where both begin at one.
    const bool isCoarse = moving_ && isTraced() && sides_.layout == SideLayout::one && !picture_;
    const int spacing = isCoarse ? movingSpacingPx : 1;
    frames_->drawCoarse(isCoarse ? std::optional(sharedBy(view, spacing)) : std::nullopt);
    for (int side = 0; side < (sides_.layout == SideLayout::one ? 1 : 2); ++side) {
        const SideColumns columns = columnsOf(sides_, side, windowPx);
        DrawnCity& city = side == 0 ? displayed_ : other_;
        if (!city.isTraced()) continue;
        const SideColumns own = beside ? SideColumns{0, int(view.widthPx)} : columns;
        city.traced().trace({pose_, view, clip, section_, own, beside ? columns.first : 0, spacing, isCoarse,
                             treeDayOf(city)});
    }
}

void CityView::resizeEvent(QResizeEvent* event) {
    Qt3DWindow::resizeEvent(event);
    applySides();
    applyCamera();
    Q_EMIT poseChanged();
}

// After another window covered this one, only a new frame restores the picture. A frame is drawn only after a
// change, so this sets a property that no shader reads.
void CityView::exposeEvent(QExposeEvent* event) {
    Qt3DWindow::exposeEvent(event);
    displayed_.redraw();
}

void CityView::setPicture(const std::optional<PictureSize>& picture) {
    if (picture == picture_) return;
    picture_ = picture;
    frames_->drawInto(picture ? std::optional(picture->pixels) : std::nullopt);
    applySides();
    cameraMoved_ = true;
    if (!picture) displayed_.redraw();
}

void CityView::capture(std::function<void(QImage)> done) {
    showEdges();
    restCamera();
    if (cameraMoved_) applyCamera();
    places_->layNames(pose_, lens());
    dome_->layNames(pose_, lens());
    requestPicture(std::move(done));
}

// A frame that is left out, as where another window covers the view at that moment, takes its request with
// it: it is made again until a picture comes.
void CityView::requestPicture(std::function<void(QImage)> done) {
    constexpr int patienceMs = 1500, patienceForLargeMs = 20'000;
    using Reply = Qt3DRender::QRenderCaptureReply;
    Reply* reply = frames_->capture()->requestCapture();
    auto* late = new QTimer(reply);
    late->setSingleShot(true);
    connect(reply, &Reply::completed, this, [reply, late, done] {
        late->stop();
        const QImage image = reply->image();
        reply->deleteLater();
        done(image);
    });
    connect(late, &QTimer::timeout, this, [this, reply, done] {
        disconnect(reply, nullptr, this, nullptr);
        reply->deleteLater();
        displayed_.redraw();
        requestPicture(done);
    });
    late->start(picture_ ? patienceForLargeMs : patienceMs);
}

}  // namespace noonmark
