#include "app/gui/frame/tour/tour_control.h"

#include <QAbstractButton>
#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QScrollArea>
#include <QSpinBox>
#include <QTabBar>
#include <QToolButton>

namespace noonmark {

namespace {

QRect inWindow(const QWidget& widget, const QRect& area, const QMainWindow& window) {
    return {widget.mapTo(&window, area.topLeft()), area.size()};
}

// The index that a step asks for: by the entry's data, else a number.
int wantedIndex(const QComboBox& list, const char* value) {
    const int byData = list.findData(QString::fromLatin1(value));
    return byData >= 0 ? byData : QByteArray(value).toInt();
}

bool holds(const QMenu& menu, const QAction* action) {
    for (const QAction* entry : menu.actions())
        if (entry == action || (entry->menu() != nullptr && holds(*entry->menu(), action))) return true;
    return false;
}

// Entries of menus belong to objects that are no children of the window.
QAction* findEntry(const QWidget& menu, const QString& name) {
    for (QAction* entry : menu.actions()) {
        if (entry->objectName() == name) return entry;
        if (entry->menu() == nullptr) continue;
        if (QAction* found = findEntry(*entry->menu(), name)) return found;
    }
    return nullptr;
}

// The tab of a dock that lies behind others. Qt keeps such docks visible, outside of the window.
QRect findTabBehind(const QDockWidget& dock, const QMainWindow& window) {
    for (const QTabBar* bar : window.findChildren<QTabBar*>())
        for (int tab = 0; tab < bar->count(); ++tab)
            if (bar->tabText(tab) == dock.windowTitle() && tab != bar->currentIndex() && bar->isVisible())
                return inWindow(*bar, bar->tabRect(tab), window);
    return {};
}

}  // namespace

TourControl::TourControl(QMainWindow& window, const TourStep& step, std::function<void()> draw)
    : window_(window), step_(step), draw_(std::move(draw)) {
    const QString name = QString::fromLatin1(step.control);
    widget_ = window.findChild<QWidget*>(name);
    if (widget_ == nullptr) action_ = findEntry(*window.menuBar(), name);
    watch();
}

void TourControl::watch() {
    const auto tell = [this] { Q_EMIT done(); };
    if (action_ != nullptr) connect(action_, &QAction::triggered, this, tell, Qt::QueuedConnection);
    if (auto* dock = qobject_cast<QDockWidget*>(widget_))
        connect(
            dock, &QDockWidget::visibilityChanged, this,
            [this](bool visible) {
                if (visible) Q_EMIT done();
            },
            Qt::QueuedConnection);
    if (auto* button = qobject_cast<QAbstractButton*>(widget_))
        connect(button, &QAbstractButton::clicked, this, tell, Qt::QueuedConnection);
    if (auto* whole = qobject_cast<QSpinBox*>(widget_))
        connect(whole, &QSpinBox::valueChanged, this, tell, Qt::QueuedConnection);
    if (auto* number = qobject_cast<QDoubleSpinBox*>(widget_))
        connect(number, &QDoubleSpinBox::valueChanged, this, tell, Qt::QueuedConnection);
    watchList();
}

void TourControl::watchList() {
    auto* list = qobject_cast<QComboBox*>(widget_);
    if (list == nullptr) return;
    connect(
        list, &QComboBox::activated, this,
        [this, list](int chosen) {
            if (chosen == wantedIndex(*list, step_.value)) Q_EMIT done();
        },
        Qt::QueuedConnection);
}

QRect TourControl::area() const {
    if (action_ != nullptr) return actionArea();
    if (const auto* dock = qobject_cast<QDockWidget*>(widget_))
        if (const QRect tab = findTabBehind(*dock, window_); !tab.isEmpty()) return tab;
    if (widget_ == nullptr || !widget_->isVisible()) return {};
    return inWindow(*widget_, widget_->rect(), window_);
}

// Its button in the toolbar, else the menu that has it.
QRect TourControl::actionArea() const {
    for (const QToolButton* button : window_.findChildren<QToolButton*>())
        if (button->defaultAction() == action_ && button->isVisible())
            return inWindow(*button, button->rect(), window_);
    const QMenuBar& bar = *window_.menuBar();
    for (QAction* entry : bar.actions())
        if (entry->menu() != nullptr && holds(*entry->menu(), action_))
            return inWindow(bar, bar.actionGeometry(entry), window_);
    return {};
}

void TourControl::reveal() {
    // A step that asks for a dock leaves it to the user.
    if (widget_ == nullptr || step_.deed == TourDeed::show) return;
    for (QWidget* around = widget_->parentWidget(); around != nullptr; around = around->parentWidget()) {
        if (auto* dock = qobject_cast<QDockWidget*>(around)) {
            dock->show();
            dock->raise();
        }
        if (auto* scroll = qobject_cast<QScrollArea*>(around)) scroll->ensureWidgetVisible(widget_);
    }
}

void TourControl::showMe() {
    reveal();
    if (step_.deed == TourDeed::draw) return draw_();
    if (step_.deed == TourDeed::choose) return choose();
    if (step_.deed == TourDeed::set) return set();
    if (action_ != nullptr) return action_->trigger();
    if (auto* button = qobject_cast<QAbstractButton*>(widget_)) return button->animateClick();
    if (auto* dock = qobject_cast<QDockWidget*>(widget_)) {
        dock->show();
        dock->raise();
        Q_EMIT done();  // it may have been in front already
    }
}

void TourControl::choose() {
    auto* list = qobject_cast<QComboBox*>(widget_);
    if (list == nullptr) return;
    list->setCurrentIndex(wantedIndex(*list, step_.value));
    Q_EMIT list->activated(list->currentIndex());
}

void TourControl::set() {
    const double value = QByteArray(step_.value).toDouble();
    if (auto* whole = qobject_cast<QSpinBox*>(widget_)) whole->setValue(int(value));
    if (auto* number = qobject_cast<QDoubleSpinBox*>(widget_)) number->setValue(value);
    Q_EMIT done();  // it may have had that value already
}

}  // namespace noonmark
