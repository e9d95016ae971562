#include "app/gui/tools/editing/move_tool.h"

#include <cmath>

#include "app/gui/tools/massing/figure_words.h"
#include "app/gui/view/panel/view_panel.h"

namespace noonmark {

namespace {

constexpr double stepM = 0.1;

double roundToStep(double metres) { return std::round(metres / stepM) * stepM; }

}  // namespace

MoveTool::MoveTool(ViewPanel& panel, QObject* parent) : QObject(parent), panel_(panel) {
    next_.setSingleShot(true);
    next_.setInterval(0);
    connect(&next_, &QTimer::timeout, this, &MoveTool::follow);
    panel.navigator().addTarget(*this);
}

MoveTool::~MoveTool() { panel_.navigator().removeTarget(*this); }

void MoveTool::begin(std::uint32_t building) {
    building_ = building;
    panel_.view().setCursor(Qt::SizeAllCursor);
    Q_EMIT began();
}

void MoveTool::end() {
    if (!building_) return;
    building_.reset();
    from_.reset();
    next_.stop();
    panel_.view().unsetCursor();
    panel_.cursorLabel().hide();
}

bool MoveTool::grab(QPointF pixel) {
    const auto pick = building_ ? panel_.navigator().pickAt(pixel) : std::nullopt;
    if (!pick || pick->building != building_) return false;
    from_ = pick->position;
    byM_ = {0, 0};
    return true;
}

void MoveTool::dragTo(QPointF pixel) {
    pixel_ = pixel;
    if (!next_.isActive()) next_.start();
}

// Moves in the horizontal plane through the grabbed point, which so stays under the cursor.
void MoveTool::follow() {
    if (!from_) return;
    const CityView& view = panel_.view();
    const auto there =
        findPlaneHit(makeRayThrough(view.pose(), view.lens(), {pixel_.x(), pixel_.y()}), from_->z);
    if (!there) return;
    byM_ = {roundToStep(there->x - from_->x), roundToStep(there->y - from_->y)};
    panel_.cursorLabel().show(pixel_, describeMove(byM_));
    Q_EMIT dragged(byM_);
}

// A drag that Esc or another city ended has no effect.
void MoveTool::drop() {
    if (!from_) return;
    if (next_.isActive()) follow();
    next_.stop();
    from_.reset();
    panel_.cursorLabel().hide();
    Q_EMIT dropped(byM_);
}

}  // namespace noonmark
