#include "app/gui/tools/editing/lot_editing.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "app/gui/base/widgets/error_text.h"
#include "app/gui/base/widgets/number_text.h"
#include "scenarios/massing/lot_edits.h"

namespace noonmark {

namespace {

constexpr double handleReachPx = 9;
constexpr double edgeReachPx = 6;
constexpr double markAboveGroundM = 0.3;  // as the lines of lots

glm::dvec3 liftedOnto(const City& city, glm::dvec2 point) {
    return {point, double(groundAt(city, point)) + markAboveGroundM};
}

glm::dvec2 corner(const Footprint& lot, std::size_t i) { return glm::dvec2(lot.outer[i % lot.outer.size()]); }

glm::dvec2 middle(const Footprint& lot, std::size_t edge) {
    return (corner(lot, edge) + corner(lot, edge + 1)) / 2.0;
}

double distanceToSegment(glm::dvec2 point, glm::dvec2 a, glm::dvec2 b) {
    const glm::dvec2 side = b - a;
    const double square = glm::dot(side, side);
    const double along = square > 0 ? std::clamp(glm::dot(point - a, side) / square, 0.0, 1.0) : 0;
    return glm::distance(point, a + along * side);
}

// The nearest of all handles of one kind, if it is within reach.
template <class Distance>
std::optional<LotHandle> nearestOf(LotHandle::Kind kind, std::size_t count, double reachPx,
                                   const Distance& distancePx) {
    std::optional<LotHandle> nearest;
    for (std::size_t i = 0; i < count; ++i) {
        const std::optional<double> far = distancePx(i);
        if (!far || *far > reachPx) continue;
        reachPx = *far;
        nearest = LotHandle{kind, i};
    }
    return nearest;
}

}  // namespace

std::optional<LotHandle> findLotHandle(const Footprint& lot, const City& city, QPointF pixel,
                                       const CameraPose& pose, const ViewLens& lens) {
    const glm::dvec2 here(pixel.x(), pixel.y());
    const std::size_t count = lot.outer.size();
    const auto onScreen = [&](glm::dvec2 point) { return pixelOf(pose, lens, liftedOnto(city, point)); };
    const auto farFrom = [&](glm::dvec2 point) -> std::optional<double> {
        const auto there = onScreen(point);
        return there ? std::optional(glm::distance(*there, here)) : std::nullopt;
    };
    using Kind = LotHandle::Kind;
    auto found =
        nearestOf(Kind::corner, count, handleReachPx, [&](std::size_t i) { return farFrom(corner(lot, i)); });
    if (!found)
        found = nearestOf(Kind::middle, count, handleReachPx,
                          [&](std::size_t i) { return farFrom(middle(lot, i)); });
    if (found) return found;
    return nearestOf(Kind::edge, count, edgeReachPx, [&](std::size_t i) -> std::optional<double> {
        const auto a = onScreen(corner(lot, i)), b = onScreen(corner(lot, i + 1));
        return a && b ? std::optional(distanceToSegment(here, *a, *b)) : std::nullopt;
    });
}

std::vector<PointMarks::Mark> makeLotMarks(const Footprint& lot, const City& city,
                                           std::optional<std::size_t> selectedCorner) {
    using Shape = PointMarks::Shape;
    std::vector<PointMarks::Mark> marks;
    for (std::size_t i = 0; i < lot.outer.size(); ++i)
        marks.push_back({Shape::middle, liftedOnto(city, middle(lot, i))});
    for (std::size_t i = 0; i < lot.outer.size(); ++i)
        marks.push_back(
            {i == selectedCorner ? Shape::selectedCorner : Shape::corner, liftedOnto(city, corner(lot, i))});
    return marks;
}

namespace {

constexpr double minDragPx = 4;  // as for a drag of the camera

std::optional<std::size_t> findCornerAt(const Footprint& lot, glm::vec2 at) {
    const auto found = std::ranges::find(lot.outer, at);
    if (found == lot.outer.end()) return std::nullopt;
    return std::size_t(found - lot.outer.begin());
}

}  // namespace

LotEditing::LotEditing(EditContext& context, QObject* parent)
    : QObject(parent),
      context_(context),
      claim_(context.panel.view(), [this](int key) { return active() && key == Qt::Key_Delete; }) {
    next_.setSingleShot(true);
    next_.setInterval(0);
    connect(&next_, &QTimer::timeout, this, &LotEditing::follow);
    context_.panel.navigator().addTarget(*this);
}

LotEditing::~LotEditing() { context_.panel.navigator().removeTarget(*this); }

void LotEditing::begin(const NamedLot& lot) {
    end();
    lot_ = lot;
    lotsChanged();
}

void LotEditing::end() {
    if (!lot_) return;
    lot_.reset();
    selected_.reset();
    drag_.reset();
    next_.stop();
    context_.panel.view().unsetCursor();
    context_.panel.cursorLabel().hide();
    context_.panel.snapping().clearMark();
    lotsChanged();
}

// Points of the lot that is edited do not hold it back.
void LotEditing::lotsChanged() {
    std::vector<Footprint> others;
    std::optional<NamedLot> mine;
    for (const NamedLot& lot : context_.lots)
        if (lot_ && lot.name == lot_->name)
            mine = lot;
        else
            others.push_back(lot.outline);
    context_.panel.snapping().setLots(std::move(others));
    if (!lot_) return show();
    if (!mine) return end();
    if (drag_) return;
    if (selected_ && mine->outline != lot_->outline)
        selected_ = findCornerAt(mine->outline, lot_->outline.outer[*selected_]);
    lot_ = mine;
    show();
}

void LotEditing::show() {
    PointMarks& marks = context_.panel.view().pointMarks();
    const bool shown = lot_ && context_.city;
    marks.show(shown ? makeLotMarks(lot_->outline, context_.city->city(), selected_)
                     : std::vector<PointMarks::Mark>());
    Q_EMIT shapeChanged();
}

std::optional<LotHandle> LotEditing::handleAt(QPointF pixel) const {
    if (!lot_ || !context_.city) return std::nullopt;
    const CityView& view = context_.panel.view();
    return findLotHandle(lot_->outline, context_.city->city(), pixel, view.pose(), view.lens());
}

void LotEditing::hover(QPointF pixel) {
    if (!active() || drag_) return;
    if (handleAt(pixel))
        context_.panel.view().setCursor(Qt::SizeAllCursor);
    else
        context_.panel.view().unsetCursor();
}

bool LotEditing::grab(QPointF pixel) {
    const auto handle = handleAt(pixel);
    const auto ground = handle ? context_.panel.navigator().groundAt(pixel) : std::nullopt;
    if (!ground) return false;
    drag_ = Drag{*handle, *lot_, pixel, glm::dvec2(*ground), false, {}};
    selected_ = handle->kind == LotHandle::Kind::corner ? std::optional(handle->index) : std::nullopt;
    show();
    return true;
}

void LotEditing::dragTo(QPointF pixel) {
    pixel_ = pixel;
    if (!next_.isActive()) next_.start();
}

void LotEditing::follow() {
    if (!drag_) return;
    const QPointF far = pixel_ - drag_->fromPx;
    if (!drag_->moved && std::hypot(far.x(), far.y()) < minDragPx) return;
    drag_->moved = true;
    const auto ground = context_.panel.navigator().groundAt(pixel_);
    if (!ground) return;
    const auto snap = context_.panel.snapping().find(*ground);
    const auto outline = dragged(*drag_, snap ? snap->point : glm::dvec2(*ground), snap.has_value());
    drag_->error = outline ? std::nullopt : std::optional(outline.error());
    if (outline) lot_->outline = *outline;
    if (outline && selected_)
        selected_ = findCornerAt(*outline, glm::vec2(snap ? snap->point : glm::dvec2(*ground)));
    show();
    showSnap(snap);
}

// A snapped point is one that the edge then leads through; else the edge moves as the cursor did.
Result<Footprint> LotEditing::dragged(const Drag& drag, glm::dvec2 to, bool snapped) const {
    const Footprint& outline = drag.before.outline;
    const std::size_t index = drag.handle.index;
    if (drag.handle.kind == LotHandle::Kind::corner) return moveCorner(outline, index, to);
    const glm::dvec2 from = snapped ? glm::dvec2(outline.outer[index]) : drag.from;
    return moveEdge(outline, index, glm::dot(to - from, outwardOf(outline, index)));
}

void LotEditing::showSnap(const std::optional<Snap>& snap) {
    QString words = drag_->error ? describeError(*drag_->error) : describeArea(area(lot_->outline));
    if (snap && !drag_->error) words += QLatin1Char('\n') + describeSnap(snap->kind);
    context_.panel.cursorLabel().show(pixel_, words);
}

void LotEditing::drop() {
    if (next_.isActive()) {
        next_.stop();
        follow();
    }
    if (!drag_) return;
    const Drag done = *std::exchange(drag_, std::nullopt);
    context_.panel.cursorLabel().hide();
    context_.panel.snapping().clearMark();
    release(done);
}

// Where the drag ended in an outline that is refused, the lot is again as before.
void LotEditing::release(const Drag& drag) {
    const QString name = QString::fromStdString(lot_->name);
    if (!drag.moved && drag.handle.kind == LotHandle::Kind::middle)
        return take(insertCorner(drag.before.outline, drag.handle.index), tr("add a corner to %1").arg(name));
    if (!drag.moved) return;
    if (!drag.error && lot_->outline != drag.before.outline)
        return Q_EMIT changed(*lot_, drag.handle.kind == LotHandle::Kind::corner
                                         ? tr("move a corner of %1").arg(name)
                                         : tr("move a side of %1").arg(name));
    lot_ = drag.before;
    if (selected_) selected_ = drag.handle.index;
    show();
    if (drag.error) Q_EMIT failed(*drag.error);
}

void LotEditing::take(Result<Footprint> outline, const QString& what) {
    if (!outline) return Q_EMIT failed(outline.error());
    NamedLot next = *lot_;
    next.outline = *std::move(outline);
    Q_EMIT changed(next, what);
}

void LotEditing::removeSelected() {
    if (!selected_)
        return Q_EMIT failed({QT_TRANSLATE_NOOP("Error", "No corner is selected"),
                              {},
                              QT_TRANSLATE_NOOP("Error", "Click a corner of the lot, then press Delete")});
    const std::size_t corner = *std::exchange(selected_, std::nullopt);
    take(removeCorner(lot_->outline, corner),
         tr("remove a corner of %1").arg(QString::fromStdString(lot_->name)));
}

void LotEditing::revert() {
    lot_ = std::exchange(drag_, std::nullopt)->before;
    next_.stop();
    context_.panel.cursorLabel().hide();
    context_.panel.snapping().clearMark();
    selected_.reset();
    show();
}

// Esc takes a drag back, or else ends the tool.
bool LotEditing::key(int key) {
    if (!active()) return false;
    if (key == Qt::Key_Escape && drag_)
        revert();
    else if (key == Qt::Key_Escape || key == Qt::Key_Return || key == Qt::Key_Enter)
        end();
    else if (!drag_ && (key == Qt::Key_Delete || key == Qt::Key_Backspace))
        removeSelected();
    else
        return false;
    return true;
}

}  // namespace noonmark
