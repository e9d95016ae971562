#include "app/gui/frame/tour/tour.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QCoreApplication>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QPainter>
#include <QPushButton>
#include <QScrollArea>
#include <QSpinBox>
#include <QTabBar>
#include <QToolButton>
#include <QVBoxLayout>

#include "app/gui/session/workbench.h"
#include "app/gui/view/panel/view_panel.h"

namespace noonmark {

namespace {

constexpr int borderWidth = 3;
constexpr int gap = 10;
constexpr int textWidth = 300;
constexpr int barsPx = 70;  // menus and toolbar at the top, which the text must not cover

}  // namespace

TourFrame::TourFrame(QWidget* parent) : QWidget(parent) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    hide();
}

void TourFrame::put(const QRect& control) {
    setVisible(!control.isEmpty());
    if (control.isEmpty()) return;
    setGeometry(control.adjusted(-borderWidth, -borderWidth, borderWidth, borderWidth));
    raise();
}

void TourFrame::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(QColor(0xe0, 0x6c, 0x10), borderWidth));
    const qreal half = borderWidth / 2.0;
    painter.drawRoundedRect(QRectF(rect()).adjusted(half, half, -half, -half), 4, 4);
}

TourBubble::TourBubble(QMainWindow& window)
    : QFrame(&window, Qt::Tool | Qt::FramelessWindowHint),
      window_(window),
      title_(new QLabel),
      text_(new QLabel),
      show_(new QPushButton),
      end_(new QPushButton) {
    setObjectName(QStringLiteral("tourBubble"));
    setAttribute(Qt::WA_ShowWithoutActivating);  // the keyboard stays with the window
    setFrameShape(QFrame::StyledPanel);
    text_->setObjectName(QStringLiteral("tourText"));
    text_->setWordWrap(true);
    text_->setFixedWidth(textWidth);
    title_->setForegroundRole(QPalette::PlaceholderText);
    show_->setObjectName(QStringLiteral("tourShowMe"));
    end_->setObjectName(QStringLiteral("tourEnd"));
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(show_);
    buttons->addStretch(1);
    buttons->addWidget(end_);
    auto* column = new QVBoxLayout(this);
    column->addWidget(title_);
    column->addWidget(text_);
    column->addLayout(buttons);
    connect(show_, &QPushButton::clicked, this, &TourBubble::showMe);
    connect(end_, &QPushButton::clicked, this, &TourBubble::ended);
}

void TourBubble::present(const QString& title, const QString& text, NextButton nextButton) {
    const bool last = nextButton == NextButton::finish;
    title_->setText(title);
    text_->setText(text);
    show_->setVisible(!last);
    show_->setText(nextButton == NextButton::next ? tr("Next") : tr("Show me"));
    show_->setToolTip(nextButton == NextButton::next ? QString() : tr("Does this step for you"));
    end_->setText(last ? tr("Finish") : tr("End tour"));
    end_->setToolTip(last ? QString() : tr("Help > Guided tours starts it again"));
    adjustSize();
    show();
}

// Right of the control, else left, else below it, as of menus and tools; inside the window.
void TourBubble::put(const QRect& control) {
    const QRect room = window_.rect().adjusted(gap, gap, -gap, -gap);
    QPoint at = room.center() - rect().center();
    if (!control.isEmpty()) {
        at = {control.right() + gap, control.top()};
        if (at.x() + width() > room.right()) at.setX(control.left() - gap - width());
        const bool isInBars = control.bottom() < barsPx;
        if (at.x() < room.left() || isInBars) at = {control.left(), control.bottom() + gap};
    }
    at.setX(qBound(room.left(), at.x(), std::max(room.left(), room.right() - width())));
    at.setY(qBound(room.top(), at.y(), std::max(room.top(), room.bottom() - height())));
    const QPoint shown = window_.mapToGlobal(at);
    if (pos() != shown) move(shown);
}

namespace {

constexpr int watchMs = 100;

QString translateTour(const char* text) { return QCoreApplication::translate("Tour", text); }

}  // namespace

Tour::Tour(const TourPlan& plan, TourStage stage, QObject* parent)
    : QObject(parent),
      plan_(plan),
      stage_(stage),
      bubble_(new TourBubble(stage.window)),
      frame_(new TourFrame(&stage.window)) {
    watch_.setInterval(watchMs);
    connect(&watch_, &QTimer::timeout, this, &Tour::follow);
    connect(bubble_, &TourBubble::showMe, this, &Tour::showMe);
    connect(bubble_, &TourBubble::ended, this, &Tour::end);
}

Tour::~Tour() {
    delete bubble_;
    delete frame_;
}

void Tour::start() {
    enter(0);
    watch_.start();
}

void Tour::enter(std::size_t step) {
    step_ = step;
    before_ = takeTourSnapshot(stage_.workbench, stage_.review);
    control_ = std::make_unique<TourControl>(stage_.window, current(), [this] { drawPlace(); });
    connect(control_.get(), &TourControl::done, this, &Tour::takeDone, Qt::QueuedConnection);
    control_->reveal();
    const QString title =
        tr("%1 (%2 of %3)").arg(translateTour(plan_.title)).arg(step + 1).arg(plan_.steps.size());
    bubble_->present(title, translateTour(current().text), nextButton());
    follow();
}

TourBubble::NextButton Tour::nextButton() const {
    if (isLast()) return TourBubble::NextButton::finish;
    return current().task == TourTask::none ? TourBubble::NextButton::next : TourBubble::NextButton::showMe;
}

// Docks and controls may move, and results come when they are computed.
void Tour::follow() {
    frame_->put(control_->area());
    bubble_->put(control_->area());
    if (isReached(current().goal, before_, takeTourSnapshot(stage_.workbench, stage_.review)))
        enter(step_ + 1);
}

void Tour::takeDone() {
    // An answer of the step before may still be in the queue.
    if (sender() != control_.get() || current().task == TourTask::none) return;
    if (current().goal == TourGoal::task) enter(step_ + 1);
}

void Tour::showMe() {
    if (current().task != TourTask::none) return control_->showMe();
    if (!isLast()) enter(step_ + 1);
}

void Tour::end() {
    watch_.stop();
    frame_->hide();
    bubble_->hide();
    Q_EMIT ended();
}

// A lawn in the middle of the study's region, with the tool that the user has.
void Tour::drawPlace() {
    const Box2 box = bounds(stage_.workbench.document().settings().region);
    const auto corner = [&](float x, float y) {
        return glm::dvec3(box.low.x + x * (box.high.x - box.low.x), box.low.y + y * (box.high.y - box.low.y),
                          0);
    };
    PolygonTool& tool = stage_.panel.placeTool();
    tool.begin();
    for (const auto& [x, y] : {std::pair{0.4F, 0.35F}, {0.6F, 0.35F}, {0.6F, 0.5F}, {0.4F, 0.5F}})
        tool.addPoint(corner(x, y));
    tool.finish();
}

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
    const auto emitDone = [this] { Q_EMIT done(); };
    if (action_ != nullptr) connect(action_, &QAction::triggered, this, emitDone, Qt::QueuedConnection);
    if (auto* dock = qobject_cast<QDockWidget*>(widget_))
        connect(
            dock, &QDockWidget::visibilityChanged, this,
            [this](bool visible) {
                if (visible) Q_EMIT done();
            },
            Qt::QueuedConnection);
    if (auto* button = qobject_cast<QAbstractButton*>(widget_))
        connect(button, &QAbstractButton::clicked, this, emitDone, Qt::QueuedConnection);
    if (auto* whole = qobject_cast<QSpinBox*>(widget_))
        connect(whole, &QSpinBox::valueChanged, this, emitDone, Qt::QueuedConnection);
    if (auto* number = qobject_cast<QDoubleSpinBox*>(widget_))
        connect(number, &QDoubleSpinBox::valueChanged, this, emitDone, Qt::QueuedConnection);
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
    if (action_ != nullptr) return areaOf(*action_);
    if (const auto* dock = qobject_cast<QDockWidget*>(widget_)) {
        if (dock->isHidden()) return areaOf(*dock->toggleViewAction());
        if (const QRect tab = findTabBehind(*dock, window_); !tab.isEmpty()) return tab;
    }
    if (widget_ == nullptr || !widget_->isVisible()) return {};
    return inWindow(*widget_, widget_->rect(), window_);
}

// Its button in the toolbar, else the menu that has it.
QRect TourControl::areaOf(const QAction& action) const {
    for (const QToolButton* button : window_.findChildren<QToolButton*>())
        if (button->defaultAction() == &action && button->isVisible())
            return inWindow(*button, button->rect(), window_);
    const QMenuBar& bar = *window_.menuBar();
    for (QAction* entry : bar.actions())
        if (entry->menu() != nullptr && holds(*entry->menu(), &action))
            return inWindow(bar, bar.actionGeometry(entry), window_);
    return {};
}

void TourControl::reveal() {
    // A step that asks for a dock leaves it to the user.
    if (widget_ == nullptr || step_.task == TourTask::show) return;
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
    if (step_.task == TourTask::draw) return draw_();
    if (step_.task == TourTask::choose) return choose();
    if (step_.task == TourTask::set) return set();
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
