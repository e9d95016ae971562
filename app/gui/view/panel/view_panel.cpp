#include "app/gui/view/panel/view_panel.h"

#include <QDragEnterEvent>
#include <QDropEvent>
#include <QGuiApplication>
#include <QMimeData>
#include <QTimer>
#include <QVBoxLayout>
#include <QWindow>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <limits>

#include "app/gui/base/files/file_dialogs.h"
#include "app/gui/base/layers/hover_text.h"
#include "app/gui/session/study/region_text.h"
#include "app/gui/view/panel/ground_layers.h"
#include "app/gui/view/panel/view_picture.h"
#include "app/gui/view/time/time_strip.h"
#include "app/report/sheets/study_text.h"
#include "core/city/map_context.h"
#include "core/receivers/place_names.h"

namespace noonmark {

namespace {

constexpr double straightDownDeg = 89;
constexpr int maxDrawnPx = 8192;         // a side of a picture; graphics cards of ten years ago draw that
constexpr double nominalHeightPx = 800;  // of a window: its texts and lines are as large in pictures
constexpr double frameWidthPx = 1100, minFrameScale = 0.5;
constexpr int messageGap = 8, maxMessageWidth = 900;

bool isInPlace(const Place& place, glm::dvec2 point) {
    return std::ranges::any_of(place.polygons, [&](const Footprint& polygon) {
        const Box2 box = bounds(polygon);
        return point.x >= double(box.low.x) && point.x <= double(box.high.x) &&
               point.y >= double(box.low.y) && point.y <= double(box.high.y) && contains(polygon, point);
    });
}

// Some window managers give the keys to the whole window at each click, away from the view inside it.
void takeKeys(QWindow& view) {
    if (QGuiApplication::focusWindow() != &view) view.requestActivate();
}

}  // namespace

// Time strip and legend side by side, or one above the other where that is too narrow.
class ViewPanel::Strips final : public QWidget {
public:
    Strips(TimeStrip& time, LegendStrip& legend) : row_(new QBoxLayout(QBoxLayout::LeftToRight, this)) {
        row_->setContentsMargins(0, 0, 0, 0);
        row_->setSpacing(0);
        row_->addWidget(&time, timeShare);
        row_->addWidget(&legend, legendShare);
        row_->setSizeConstraint(QLayout::SetNoConstraint);
        setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    }
    [[nodiscard]] QSize minimumSizeHint() const override {
        return {row_->direction() == QBoxLayout::LeftToRight ? minStripsWidth : row_->minimumSize().width(),
                row_->minimumSize().height()};
    }
    [[nodiscard]] QSize sizeHint() const override { return minimumSizeHint(); }

protected:
    void resizeEvent(QResizeEvent* event) override {
        QWidget::resizeEvent(event);
        const auto wanted = width() < minRowWidth ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight;
        if (row_->direction() == wanted) return;
        row_->setDirection(wanted);
        updateGeometry();
    }

private:
    static constexpr int timeShare = 2, legendShare = 3;
    static constexpr int minStripsWidth = 256;
    static constexpr int minRowWidth = 1200;  // with the words of both strips
    QBoxLayout* row_;
};

ViewPanel::ViewPanel(QWidget* parent)
    : QWidget(parent),
      column_(new QVBoxLayout(this)),
      view_(new CityView),
      container_(QWidget::createWindowContainer(view_, this)),
      navigator_(new ViewNavigator(*view_)),
      measureTool_(new MeasureTool(this)),
      label_(new CursorLabel(*view_, this)),
      polygons_(new PolygonDrawing(*view_, *navigator_, *label_, this)),
      section_(new SectionTool(*view_, *navigator_, *label_, this)),
      messages_(new MessageBar(this)),
      time_(new TimeStrip),
      legend_(new LegendStrip),
      strips_(new Strips(*time_, *legend_)),
      results_(std::make_unique<ResultLayer>(*view_, *legend_)),
      map_(std::make_unique<MapLayer>(*view_)) {
    container_->setMinimumSize(240, 160);
    container_->setFocusPolicy(Qt::StrongFocus);
    container_->setAccessibleName(tr("View of the city"));
    container_->setAccessibleDescription(tr("Arrow keys pan, plus and minus zoom; Ctrl+F1 lists all keys"));
    column_->setContentsMargins(0, 0, 0, 0);
    column_->setSpacing(0);
    // The view's own window would lie above anything else; the panel has none, or it would hide the start
    // page.
    messages_->setAttribute(Qt::WA_DontCreateNativeAncestors);
    messages_->setAttribute(Qt::WA_NativeWindow);
    messages_->installEventFilter(this);
    container_->installEventFilter(this);
    column_->addWidget(container_, 1);
    column_->addWidget(strips_);
    label_->setLeft([this] { return navigator_->pictureLeft(); });
    setAcceptDrops(true);
    view_->installEventFilter(this);  // the native window inside the container receives the drops
    connect(view_, &CityView::poseChanged, this, [this] {
        legend_->setHeading(view_->pose().headingDeg);
        legend_->setScale(1 / metresPerPixel(view_->pose(), view_->lens()));
    });
    for (auto signal :
         {&LegendStrip::measureChanged, &LegendStrip::changeScaleChanged, &LegendStrip::choiceChanged})
        connect(legend_, signal, this, [this] { results_->show(); });
    connect(navigator_, &ViewNavigator::hovered, this, &ViewPanel::describePixel);
    connect(navigator_, &ViewNavigator::left, this, [this] {
        label_->hide();
        view_->places().hover(std::nullopt);
        Q_EMIT hovered({});
    });
    view_->places().hideNamesWhere([this](const glm::dvec3& at) { return isHidden(at); });
    connectDrawing();
    connectNavigator();
    connectMeasuring();
}

QWidget* ViewPanel::takeStrips() {
    column_->removeWidget(strips_);
    return strips_;
}

// Over the top of the view, which keeps its size and its place under the cursor.
void ViewPanel::placeMessages() {
    const QRect room = container_->geometry() - covered_ - QMargins(messageGap, messageGap, messageGap, 0);
    const int width = std::clamp(room.width(), 0, maxMessageWidth);
    const int height = std::min(room.height(), messages_->heightForWidth(width));
    messages_->setGeometry(room.left() + (room.width() - width) / 2, room.top(), width, height);
    // Raised while hidden, it would have a window again after the panel's was closed; Qt loses one of the
    // two. The view's window may have come later, of which QWidget::raise() knows nothing.
    if (messages_->isVisible() && messages_->windowHandle() != nullptr) messages_->windowHandle()->raise();
}

void ViewPanel::setCovered(int left, int right) {
    covered_ = {left, 0, right, 0};
    placeMessages();
}

void ViewPanel::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    placeMessages();
}

void ViewPanel::setBare(bool bare) {
    for (QWidget* strip : {static_cast<QWidget*>(time_), static_cast<QWidget*>(legend_)})
        strip->setHidden(bare);
}

void ViewPanel::connectNavigator() {
    connect(navigator_, &ViewNavigator::rightClicked, this, [this](QPointF pixel) {
        if (PolygonTool* tool = polygons_->active()) return tool->finish();
        Q_EMIT menuRequested(pixel);
    });
    connect(navigator_, &ViewNavigator::keyPressed, this, &ViewPanel::toolKey);
}

void ViewPanel::connectDrawing() {
    connect(polygons_, &PolygonDrawing::lineChanged, this, &ViewPanel::showLines);
    connect(polygons_, &PolygonDrawing::refused, messages_, &MessageBar::showError);
    connect(polygons_, &PolygonDrawing::activeChanged, this, [this](bool active) {
        if (active) measureTool_->end();
        showCrossCursor(active);
    });
}

void ViewPanel::showCrossCursor(bool cross) {
    if (cross)
        view_->setCursor(Qt::CrossCursor);
    else
        view_->unsetCursor();
    label_->hide();
}

bool ViewPanel::drawing() const { return polygons_->active() != nullptr || measureTool_->active(); }

void ViewPanel::connectMeasuring() {
    connect(measureTool_, &MeasureTool::lineChanged, this, &ViewPanel::showLines);
    connect(measureTool_, &MeasureTool::activeChanged, this, [this](bool active) {
        if (active) polygons_->cancel();
        showCrossCursor(active);
    });
    connect(navigator_, &ViewNavigator::clicked, this, [this](QPointF pixel) { measure(pixel, true); });
    connect(navigator_, &ViewNavigator::doubleClicked, this, [this] {
        if (measureTool_->active()) finishMeasuring();
    });
}

// Points lie on roofs, walls and ground as the view shows them.
void ViewPanel::measure(QPointF pixel, bool clicked) {
    const auto pick = measureTool_->active() ? navigator_->pickAt(pixel) : std::nullopt;
    if (!pick) return;
    clicked ? measureTool_->addPoint(pick->position) : measureTool_->moveTo(pick->position);
    label_->show(pixel, describeMeasured());
}

QString ViewPanel::describeMeasured() const {
    return describeMeasures(measureLine(measureTool_->line()), units_);
}

bool ViewPanel::measureKey(int key) {
    if (!measureTool_->active()) return false;
    if (key == Qt::Key_Backspace) measureTool_->removeLastPoint();
    if (key == Qt::Key_Escape) measureTool_->end();
    if (key == Qt::Key_Return || key == Qt::Key_Enter) finishMeasuring();
    return true;
}

// The figures stay in the message bar when the line is gone.
void ViewPanel::finishMeasuring() {
    const QString words = describeMeasured();
    measureTool_->end();
    if (!words.isEmpty()) messages_->showNote(words);
}

void ViewPanel::toolKey(int key) {
    if (!measureKey(key) && !polygons_->key(key)) Q_EMIT keyPressed(key);
}

void ViewPanel::showCity(std::shared_ptr<const OpenCity> city) {
    city_ = std::move(city);
    navigator_->setScene(city_->picker);
    polygons_->snapping().setCity(city_);
    if (view_->arrays() != city_->arrays) {
        polygons_->cancel();
        measureTool_->end();
        view_->showCity(city_->arrays);
    }
    const ArrayDifference changes = computeDifference(*city_->arrays, city_->city());
    view_->showChanges(changes);
    view_->showDemolished(makeDemolishedLines(*city_->arrays, changes, city_->city()));
    if (const auto& rays = city_->picker.scene()) view_->setRays(*rays, city_->city().buildings);
    view_->showTrees(city_->city().trees, city_->crowns);
    results_->forget();
    map_->showCity(city_->city());
    showLines();  // on its ground
    markPlaces();
}

void ViewPanel::showPlaces(const std::vector<Place>& places) {
    if (places == places_) return;
    places_ = places;
    markPlaces();
}

void ViewPanel::highlightPlace(const std::string& name) {
    highlighted_ = name;
    const auto found = std::ranges::find(places_, name, &Place::name);
    view_->places().highlight(found == places_.end() ? std::nullopt
                                                     : std::optional(std::size_t(found - places_.begin())));
}

// A place gets its name at the middle of its largest polygon.
void ViewPanel::markPlaces() {
    if (!city_) return;
    placeMarks_.clear();
    for (const Place& place : places_) {
        const auto largest = std::ranges::max_element(place.polygons, {},
                                                      [](const Footprint& polygon) { return area(polygon); });
        const glm::dvec2 at = findMarkPoint(*largest);
        placeMarks_.push_back({placeName(place.name),
                               {at.x, at.y, double(groundAt(city_->city(), at))},
                               area(*largest),
                               hasOwnName(place),
                               makeGroundLines({place.name, place.polygons}, city_->city())});
    }
    showMarks();
}

// Of the region after those of places, whose indices stay.
void ViewPanel::showMarks() {
    if (!city_) return;
    std::vector<PlaceMarks::Mark> marks = placeMarks_;
    if (auto region = markRegion()) marks.push_back(*std::move(region));
    view_->places().show(std::move(marks));
    highlightPlace(highlighted_);
}

// Its name stands on its northernmost side, before those of places.
std::optional<PlaceMarks::Mark> ViewPanel::markRegion() const {
    if (!regionShown_ || region_.polygons.empty()) return std::nullopt;
    const Ring& ring = region_.polygons.front().outer;
    glm::dvec2 at{0, std::numeric_limits<double>::lowest()};
    for (std::size_t i = 0; i < ring.size(); ++i)
        if (const glm::dvec2 middle = (glm::dvec2(ring[i]) + glm::dvec2(ring[(i + 1) % ring.size()])) * 0.5;
            middle.y > at.y)
            at = middle;
    constexpr double firstM2 = 1e12;
    return PlaceMarks::Mark{
        tr("Region"), {at.x, at.y, double(groundAt(city_->city(), at))}, firstM2, true, {}};
}

// A name stays where only low things, or what is on the place itself, lie before it.
bool ViewPanel::isHidden(const glm::dvec3& at) const {
    constexpr double nearM = 15;
    const auto pixel = pixelOf(view_->pose(), view_->lens(), at);
    const auto seen = pixel ? navigator_->pickAt({pixel->x, pixel->y}) : std::nullopt;
    const glm::dvec3 forward = computeForward(view_->pose());
    return seen && seen->building && glm::dot(at - seen->position, forward) > nearM;
}

// The smallest of the places there, as it lies in the others.
void ViewPanel::hoverPlace(const std::optional<Pick>& pick) {
    std::optional<std::size_t> smallest;
    double minM2 = std::numeric_limits<double>::max();
    for (std::size_t i = 0; pick && !pick->building && i < places_.size(); ++i)
        if (isInPlace(places_[i], glm::dvec2(pick->position)))
            if (const double areaM2 = area(places_[i]); areaM2 < minM2) {
                smallest = i;
                minM2 = areaM2;
            }
    view_->places().hover(smallest);
}

void ViewPanel::showRegion(const Region& region) {
    if (region == region_) return;
    region_ = region;
    showLines();
    showMarks();
}

void ViewPanel::setRegionShown(bool shown) {
    if (shown == regionShown_) return;
    regionShown_ = shown;
    showLines();
    showMarks();
}

void ViewPanel::showLines() {
    if (!city_) return;
    const bool isFree = !measureTool_->active() && polygons_->active() == nullptr;
    view_->showRegion(regionShown_ && isFree ? makeGroundLines(region_, city_->city())
                                             : std::vector<GroundLine>());
    if (measureTool_->active()) {
        const std::vector<glm::dvec3> line = measureTool_->line();
        return view_->showLines({GroundLine{{line.begin(), line.end()}, false}});
    }
    if (const PolygonTool* tool = polygons_->active())
        return view_->showLines({makeGroundLine(tool->line(), city_->city(), true)});
    view_->showLines({});
}

// `pixel`: of the picture under the mouse.
bool ViewPanel::isOnOtherSide(QPointF pixel) const {
    const SideColumns other = columnsOf(view_->sides(), 1, view_->width());
    const double column = pixel.x() + navigator_->pictureLeft();
    return other.first <= column && column < other.last;
}

void ViewPanel::describePixel(QPointF pixel) {
    if (!city_) return;
    polygons_->hover(pixel);
    measure(pixel, false);
    const auto pick = navigator_->pickAt(pixel);
    hoverPlace(pick);
    Q_EMIT hovered(pick ? hoverText(*pick, city_->city(), results_->minutesAt(*pick, isOnOtherSide(pixel)))
                        : QString());
}

Region ViewPanel::visibleGround() const {
    return noonmark::visibleGround(view_->pose(), view_->lens(), view_->viewBounds());
}

PictureFrame ViewPanel::pictureFrame(const QString& title, const QString& when) const {
    PictureFrame frame{.title = title,
                       .when = when,
                       .legend = legend_->legend(),
                       .buildings = buildingPatches_,
                       .note = legend_->note()};
    if (city_)
        frame.credit =
            describeData(joinAttribution(city_->loaded.read.attribution, city_->city().context.get()));
    if (!comparison_.isEmpty())
        frame.note = frame.note.isEmpty() ? comparison_ : tr("%1. %2").arg(comparison_, frame.note);
    const CameraPose pose = view_->pose();
    frame.headingDeg = pose.headingDeg;
    frame.fromAbove = pose.pitchDeg >= straightDownDeg;
    return frame;
}

void ViewPanel::takePicture(const QString& title, const QString& when, std::function<void(QImage)> done) {
    const double heightM = metresPerPixel(view_->pose(), view_->lens()) * view_->lens().heightPx;
    view_->overlay().showEditing(false);
    view_->capture([this, frame = pictureFrame(title, when), heightM,
                    done = std::move(done)](const QImage& image) mutable {
        view_->overlay().showEditing(true);
        frame.pixelsPerM = image.height() / heightM;
        done(viewPicture(image, frame));
    });
}

void ViewPanel::takePicture(const Picture& picture, std::function<void(QImage)> done) {
    const QSize size = picture.size;
    const double scale = std::max(minFrameScale, size.width() / frameWidthPx);
    const int around = picture.framed ? heightOfFrame(size.width(), picture.frame, scale) : 0;
    const QSize drawn(size.width(), std::max(size.height() - around, size.height() / 4));
    const bool twice = picture.smooth && std::max(drawn.width(), drawn.height()) * 2 <= maxDrawnPx;
    const int finer = twice ? 2 : 1;
    view_->setPicture(PictureSize{drawn * finer, drawn.height() * finer / nominalHeightPx});
    const double heightM = metresPerPixel(view_->pose(), view_->lens()) * view_->lens().heightPx;
    view_->overlay().showEditing(false);
    view_->capture([this, picture, drawn, scale, heightM, done = std::move(done)](QImage image) {
        view_->overlay().showEditing(true);
        if (!picture.moreFollow) endPictures();
        image.reinterpretAsFormat(QImage::Format_RGBX8888);  // translucent lines left their mark in alpha
        image = image.convertToFormat(QImage::Format_RGB888)
                    .scaled(drawn, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
        PictureFrame frame = picture.frame;
        frame.pixelsPerM = image.height() / heightM;
        done(picture.framed ? viewPicture(image, frame, scale) : image);
    });
}

bool ViewPanel::eventFilter(QObject* watched, QEvent* event) {
    if (watched == messages_ && (event->type() == QEvent::Show || event->type() == QEvent::LayoutRequest))
        placeMessages();
    // A strip above the view moves it.
    if (watched == container_ && (event->type() == QEvent::Move || event->type() == QEvent::Resize))
        placeMessages();
    if (watched == messages_ || watched == container_) return QWidget::eventFilter(watched, event);
    if (event->type() == QEvent::DragEnter || event->type() == QEvent::DragMove) {
        dragEnterEvent(static_cast<QDragEnterEvent*>(event));
        return true;
    }
    if (event->type() == QEvent::Drop) {
        dropEvent(static_cast<QDropEvent*>(event));
        return true;
    }
    // Its window comes on top of a message that was there before it.
    if (event->type() == QEvent::Expose) QTimer::singleShot(0, messages_, [this] { placeMessages(); });
    if (event->type() == QEvent::MouseButtonRelease) takeKeys(*view_);
    return QWidget::eventFilter(watched, event);
}

void ViewPanel::dragEnterEvent(QDragEnterEvent* event) {
    if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void ViewPanel::dropEvent(QDropEvent* event) {
    const QStringList files = listDroppedFiles(*event->mimeData());
    event->acceptProposedAction();
    const QPointF pixel = event->position() - QPointF(view_->sideOffset(event->position()), 0);
    if (!files.isEmpty()) Q_EMIT filesDropped(files, pixel);
}

}  // namespace noonmark
