#include "app/gui/view/panel/point_input.h"

#include <QGuiApplication>
#include <QKeyEvent>
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <utility>

#include "app/gui/base/looks/units.h"

namespace noonmark {

namespace {

constexpr double widestM = 500;

std::vector<Box2> boxesOf(const std::vector<std::shared_ptr<const Building>>& buildings) {
    std::vector<Box2> boxes;
    boxes.reserve(buildings.size());
    for (const auto& building : buildings) boxes.push_back(bounds(*building));
    return boxes;
}

bool meets(const Box2& a, const Box2& b) {
    return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}

// The nearest corner and the nearest point of an edge, of all that are added.
class NearestPoint {
public:
    NearestPoint(glm::dvec2 cursor, const SnapReach& reach)
        : cursor_(cursor),
          reach_(reach),
          box_{glm::vec2(cursor - reach.halfBoxM()), glm::vec2(cursor + reach.halfBoxM())} {}

    [[nodiscard]] const Box2& box() const { return box_; }

    void add(const Footprint& footprint) {
        if (!meets(bounds(footprint), box_)) return;
        add(footprint.outer);
        for (const Ring& hole : footprint.holes) add(hole);
    }
    void addEdge(glm::dvec2 a, glm::dvec2 b) {
        const glm::dvec2 side = onScreen(b - a), fromA = onScreen(cursor_ - a);
        const double square = glm::dot(side, side);
        const double along = square > 0 ? std::clamp(glm::dot(fromA, side) / square, 0.0, 1.0) : 0;
        offer(edge_, {SnapKind::edge, a + along * (b - a)});
    }
    void addCorner(glm::dvec2 at) { offer(corner_, {SnapKind::corner, at}); }
    [[nodiscard]] std::optional<Snap> found() const { return corner_.snap ? corner_.snap : edge_.snap; }

private:
    struct Nearest {
        std::optional<Snap> snap;
        double distancePx = 0;
    };
    [[nodiscard]] glm::dvec2 onScreen(glm::dvec2 byM) const { return reach_.pixelsPerMetre * byM; }
    void add(const Ring& ring) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            addCorner(glm::dvec2(ring[i]));
            addEdge(glm::dvec2(ring[i]), glm::dvec2(ring[(i + 1) % ring.size()]));
        }
    }
    void offer(Nearest& nearest, const Snap& snap) {
        const double distancePx = glm::length(onScreen(snap.point - cursor_));
        if (distancePx > reach_.reachPx || (nearest.snap && distancePx >= nearest.distancePx)) return;
        nearest = {snap, distancePx};
    }

    glm::dvec2 cursor_;
    SnapReach reach_;
    Box2 box_;
    Nearest corner_, edge_;
};

// Parts above the ground only where a building has no others: their corners lie in the air.
void addOutlines(NearestPoint& nearest, const Building& building) {
    const bool stands =
        std::ranges::any_of(building.parts, [](const Part& part) { return !part.isOverhanging; });
    for (const Part& part : building.parts)
        if (!stands || !part.isOverhanging) nearest.add(part.footprint);
}

}  // namespace

// The rows of the inverse are the half axes of the ellipse on the ground that is a circle on the screen.
glm::dvec2 SnapReach::halfBoxM() const {
    if (glm::determinant(pixelsPerMetre) == 0) return glm::dvec2(widestM);
    const glm::dmat2 back = glm::transpose(glm::inverse(pixelsPerMetre));
    return glm::min(reachPx * glm::dvec2(glm::length(back[0]), glm::length(back[1])), glm::dvec2(widestM));
}

SnapTargets::SnapTargets(const City& city) : buildings_(city.buildings), boxes_(boxesOf(city.buildings)) {}

std::optional<Snap> SnapTargets::find(glm::dvec2 cursor, const SnapReach& reach,
                                      std::span<const glm::dvec2> line) const {
    NearestPoint nearest(cursor, reach);
    for (const std::size_t i : boxes_.findMeeting(nearest.box())) addOutlines(nearest, *buildings_[i]);
    for (const Footprint& lot : lots_) nearest.add(lot);
    for (std::size_t i = 0; i < line.size(); ++i) {
        nearest.addCorner(line[i]);
        if (i > 0) nearest.addEdge(line[i - 1], line[i]);
    }
    return nearest.found();
}

namespace {

constexpr double markLiftM = 0.3;  // as lines on the ground

bool controlIsDown() { return QGuiApplication::keyboardModifiers().testFlag(Qt::ControlModifier); }

PointMarks::Mark markOf(const Snap& snap, const City& city) {
    const auto shape =
        snap.kind == SnapKind::corner ? PointMarks::Shape::snappedCorner : PointMarks::Shape::snappedEdge;
    return {shape, {snap.point, double(groundAt(city, snap.point)) + markLiftM}};
}

}  // namespace

SnapReach computeSnapReach(const CameraPose& pose, const ViewLens& lens, const glm::dvec3& ground) {
    constexpr double stepM = 0.01;
    SnapReach reach;
    const auto here = pixelOf(pose, lens, ground);
    const auto east = pixelOf(pose, lens, ground + glm::dvec3(stepM, 0, 0));
    const auto north = pixelOf(pose, lens, ground + glm::dvec3(0, stepM, 0));
    if (here && east && north)
        reach.pixelsPerMetre = glm::dmat2((*east - *here) / stepM, (*north - *here) / stepM);
    return reach;
}

QString describeSnap(SnapKind kind) {
    return kind == SnapKind::corner ? QObject::tr("corner") : QObject::tr("edge");
}

void Snapping::setCity(std::shared_ptr<const OpenCity> city) {
    city_ = std::move(city);
    targets_.reset();
}

void Snapping::setLots(std::vector<Footprint> lots) {
    lots_ = std::move(lots);
    if (targets_) targets_->setLots(lots_);
}

std::optional<Snap> Snapping::find(const glm::dvec3& ground, std::span<const glm::dvec2> line) {
    std::optional<Snap> snap;
    if (city_ && !controlIsDown()) {
        if (!targets_) targets_.emplace(city_->city()).setLots(lots_);
        snap = targets_->find(glm::dvec2(ground), computeSnapReach(view_.pose(), view_.lens(), ground), line);
    }
    view_.pointMarks().showSnap(snap ? std::optional(markOf(*snap, city_->city())) : std::nullopt);
    return snap;
}

void Snapping::clearMark() { view_.pointMarks().showSnap(std::nullopt); }

ShortcutClaim::ShortcutClaim(QObject& view, std::function<bool(int)> claims) : claims_(std::move(claims)) {
    view.installEventFilter(this);
}

// Accepting the event that Qt sends before it looks for a shortcut makes the key an ordinary one.
bool ShortcutClaim::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::ShortcutOverride) return QObject::eventFilter(watched, event);
    const auto& key = static_cast<QKeyEvent&>(*event);
    const bool plain = !(key.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier));
    if (!plain || !claims_(key.key())) return QObject::eventFilter(watched, event);
    event->accept();
    return true;
}

namespace {

bool isDigit(int key) { return key >= Qt::Key_0 && key <= Qt::Key_9; }

bool isPoint(int key) { return key == Qt::Key_Period || key == Qt::Key_Comma; }

bool isEnter(int key) { return key == Qt::Key_Return || key == Qt::Key_Enter; }

bool isAngleMark(QChar c) { return c == QLatin1Char('<') || c == QLatin1Char(';'); }

qsizetype findAngleMark(const QString& text) {
    return std::ranges::find_if(text, isAngleMark) - text.begin();
}

}  // namespace

// Units and marks of feet, inches, metres, centimetres and millimetres; the mark of an angle only once.
bool TypedLength::canFollow(int key) const {
    if (key > 0xff) return false;
    const QChar c(key);
    if (QStringLiteral("'\"/ FTINCM").contains(c)) return true;
    return form_ == Form::lengthAndAzimuth && isAngleMark(c) && findAngleMark(text_) == text_.size();
}

TypedLength::Taken TypedLength::take(int key) {
    if (isDigit(key) || isPoint(key) || (!empty() && canFollow(key)))
        text_ += isPoint(key) ? QLatin1Char('.') : QChar(key).toLower();
    else if (empty())
        return Taken::no;
    else if (key == Qt::Key_Backspace)
        text_.chop(1);
    else if (key == Qt::Key_Escape)
        clear();
    else
        return isEnter(key) ? Taken::entered : Taken::no;
    return Taken::changed;
}

bool TypedLength::claims(int key) const {
    return !empty() && (isDigit(key) || isPoint(key) || canFollow(key) || isEnter(key) ||
                        key == Qt::Key_Backspace || key == Qt::Key_Escape);
}

QString TypedLength::finish() { return std::exchange(text_, {}); }

QString TypedLength::withUnit() const {
    const QString length = text_.left(findAngleMark(text_));
    const bool isNumber = !length.isEmpty() && std::ranges::none_of(length, [](QChar c) {
        return !c.isDigit() && c != QLatin1Char('.');
    });
    if (!isNumber) return text_;
    const QString unit = unitsInUse() == UnitSystem::imperial ? QStringLiteral(" ft") : QStringLiteral(" m");
    return length + unit + text_.mid(length.size());
}

std::optional<TypedSide> parseTypedSide(const QString& text, UnitSystem units) {
    const qsizetype mark = findAngleMark(text);
    const auto length = parseLength(text.left(mark).toStdString(), units);
    if (!length || *length <= 0) return std::nullopt;
    if (mark == text.size()) return TypedSide{*length, {}};
    bool isNumber = false;
    const double degrees = text.mid(mark + 1).toDouble(&isNumber);
    if (!isNumber || !std::isfinite(degrees)) return std::nullopt;
    return TypedSide{*length, degrees};
}

}  // namespace noonmark
