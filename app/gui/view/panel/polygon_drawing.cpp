#include "app/gui/view/panel/polygon_drawing.h"

#include <QGuiApplication>
#include <QRegularExpression>

#include "app/gui/base/looks/units.h"
#include "app/gui/base/widgets/cursor_label.h"
#include "app/gui/base/widgets/number_words.h"
#include "render/view/view_navigator.h"

namespace noonmark {

namespace {

bool wantsSquare() { return QGuiApplication::keyboardModifiers().testFlag(Qt::ShiftModifier); }

// Without the last corner and side, on which the next side would fold back.
std::vector<glm::dvec2> lineToSnapTo(const PolygonTool& tool) {
    std::vector<glm::dvec2> line;
    for (std::size_t i = 0; i + 1 < tool.points().size(); ++i) line.emplace_back(tool.points()[i]);
    return line;
}

// "24.6 m, 812 m²"; empty before there is a side.
QString describeDrawn(const PolygonTool& tool) {
    if (tool.sideM() == 0) return {};
    const QString side = describeLength(tool.sideM());
    return tool.areaM2() == 0 ? side : side + QStringLiteral(", ") + describeArea(tool.areaM2());
}

}  // namespace

PolygonDrawing::PolygonDrawing(CityView& view, ViewNavigator& navigator, CursorLabel& label, QObject* parent)
    : QObject(parent),
      navigator_(navigator),
      label_(label),
      snapping_(view),
      tools_{new PolygonTool(tr("region"), this), new PolygonTool(tr("lot"), this),
             new PolygonTool(tr("place"), this)},
      claim_(view, [this](int key) { return active() != nullptr && typed_.claims(key); }) {
    for (PolygonTool* tool : tools_) connectTool(tool);
    connect(&navigator_, &ViewNavigator::clicked, this, &PolygonDrawing::click);
    connect(&navigator_, &ViewNavigator::left, this, [this] { snapping_.clearMark(); });
    connect(&navigator_, &ViewNavigator::doubleClicked, this, [this] {
        if (PolygonTool* tool = active()) tool->finish();
    });
}

// Only one polygon is drawn at a time.
void PolygonDrawing::connectTool(PolygonTool* tool) {
    connect(tool, &PolygonTool::lineChanged, this, &PolygonDrawing::lineChanged);
    connect(tool, &PolygonTool::refused, this, &PolygonDrawing::refused);
    connect(tool, &PolygonTool::activeChanged, this, [this, tool](bool on) {
        for (PolygonTool* other : tools_)
            if (on && other != tool) other->cancel();
        typed_.clear();
        snap_.reset();
        snapping_.clearMark();
        Q_EMIT activeChanged(on);
    });
}

PolygonTool* PolygonDrawing::active() const {
    for (PolygonTool* tool : tools_)
        if (tool->active()) return tool;
    return nullptr;
}

void PolygonDrawing::cancel() {
    if (PolygonTool* tool = active()) tool->cancel();
}

std::optional<glm::dvec3> PolygonDrawing::groundAt(QPointF pixel) {
    auto ground = navigator_.groundAt(pixel);
    snap_.reset();
    if (!ground) snapping_.clearMark();
    if (!ground) return ground;
    snap_ = snapping_.find(*ground, lineToSnapTo(*active()));
    if (snap_) ground = glm::dvec3(snap_->point, ground->z);
    return ground;
}

// The polygon is finished after the click has reached everyone, who would take it for their own otherwise.
void PolygonDrawing::click(QPointF pixel) {
    PolygonTool* tool = active();
    const auto ground = tool != nullptr ? groundAt(pixel) : std::nullopt;
    if (!ground) return;
    if (tool->closesAt(glm::dvec2(*ground)))
        QMetaObject::invokeMethod(tool, &PolygonTool::finish, Qt::QueuedConnection);
    else
        tool->addPoint(*ground, wantsSquare());
}

void PolygonDrawing::hover(QPointF pixel) {
    PolygonTool* tool = active();
    const auto ground = tool != nullptr ? groundAt(pixel) : std::nullopt;
    if (!ground) return;
    pixel_ = pixel;
    tool->moveTo(*ground, wantsSquare());
    showLabel();
}

bool PolygonDrawing::key(int key) {
    PolygonTool* tool = active();
    if (tool == nullptr) return false;
    const TypedLength::Taken taken = tool->points().empty() ? TypedLength::Taken::no : typed_.take(key);
    if (taken == TypedLength::Taken::entered) takeTyped();
    if (taken == TypedLength::Taken::no) editKey(key);
    if (active() != nullptr) showLabel();
    return true;
}

void PolygonDrawing::editKey(int key) {
    PolygonTool* tool = active();
    if (key == Qt::Key_Return || key == Qt::Key_Enter) tool->finish();
    if (key == Qt::Key_Escape) tool->cancel();
    if (key == Qt::Key_Backspace) tool->removeLastPoint();
}

void PolygonDrawing::takeTyped() {
    const QString text = typed_.finish();
    const auto side = parseTypedSide(text, unitsInUse());
    if (side) return active()->addSide(side->lengthM, side->azimuthDeg);
    Q_EMIT refused({"This is not a length", text.toStdString(),
                    "Type it as 40, 40 m or 131' 3\", with an azimuth as 40<90"});
}

void PolygonDrawing::showLabel() { label_.show(pixel_, typed_.empty() ? describe() : describeTyped()); }

QString PolygonDrawing::describe() const {
    const PolygonTool& tool = *active();
    QString words = describeDrawn(tool);
    if (!snap_) return words;
    const QString snapped =
        tool.closesAt(snap_->point) ? tr("first corner: closes the outline") : describeSnap(snap_->kind);
    return words.isEmpty() ? snapped : words + QLatin1Char('\n') + snapped;
}

QString PolygonDrawing::describeTyped() const {
    const QStringList parts = typed_.withUnit().split(QRegularExpression(QStringLiteral("[<;]")));
    if (parts.size() == 1) return tr("Length: %1  (Enter)").arg(parts[0]);
    return tr("Length: %1, azimuth: %2° clockwise from north  (Enter)").arg(parts[0], parts[1]);
}

}  // namespace noonmark
