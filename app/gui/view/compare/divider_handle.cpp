#include "app/gui/view/compare/divider_handle.h"

#include <algorithm>
#include <cmath>

namespace noonmark {

namespace {

constexpr double reachPx = 8;
constexpr double minShare = 0.02;  // so that the divider can be found again

}  // namespace

DividerHandle::DividerHandle(CityView& view, ViewNavigator& navigator, QObject* parent)
    : QObject(parent), view_(view), navigator_(navigator) {
    navigator_.addTarget(*this);
    connect(&navigator_, &ViewNavigator::hovered, this, &DividerHandle::showCursor);
}

DividerHandle::~DividerHandle() { navigator_.removeTarget(*this); }

void DividerHandle::setActive(bool active) {
    active_ = active;
    if (!active) restoreCursor();
}

bool DividerHandle::isAt(QPointF pixel) const {
    return active_ && std::abs(pixel.x() - view_.sides().divider * view_.width()) <= reachPx;
}

bool DividerHandle::grab(QPointF pixel) { return isAt(pixel); }

void DividerHandle::dragTo(QPointF pixel) {
    ViewSides sides = view_.sides();
    sides.divider = std::clamp(pixel.x() / std::max(1, view_.width()), minShare, 1 - minShare);
    view_.setSides(sides);
}

// Tools have cursors of their own, which return.
void DividerHandle::showCursor(QPointF pixel) {
    if (!isAt(pixel)) return restoreCursor();
    if (before_) return;
    before_ = view_.cursor();
    view_.setCursor(Qt::SplitHCursor);
}

void DividerHandle::restoreCursor() {
    if (before_) view_.setCursor(*before_);
    before_.reset();
}

}  // namespace noonmark
