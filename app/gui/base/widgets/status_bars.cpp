#include "app/gui/base/widgets/status_bars.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QMouseEvent>
#include <QProgressBar>
#include <QPushButton>
#include <QToolButton>
#include <algorithm>
#include <utility>

#include "app/gui/base/jobs/job.h"
#include "app/gui/base/looks/theme.h"
#include "app/gui/base/widgets/buttons.h"
#include "app/gui/base/widgets/error_text.h"
#include "app/gui/base/widgets/number_text.h"

namespace noonmark {

namespace {

constexpr int noteMs = 12000;

QString firstLine(const QString& text) { return text.section(QLatin1Char('\n'), 0, 0); }

}  // namespace

MessageBar::MessageBar(QWidget* parent)
    : QFrame(parent),
      label_(new QLabel),
      more_(new QToolButton),
      remedy_{new QPushButton, {}},
      other_{new QPushButton, {}},
      leave_(new QTimer(this)) {
    setObjectName(QStringLiteral("messageBar"));
    label_->setWordWrap(true);
    label_->setTextFormat(Qt::PlainText);
    label_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    label_->installEventFilter(this);
    more_->setObjectName(QStringLiteral("messageMore"));
    more_->setAutoRaise(true);
    more_->setToolTip(tr("Shows or hides the other lines of this message"));
    connect(more_, &QToolButton::clicked, this, [this] { unfold(!unfolded_); });
    auto* close = new QToolButton;
    close->setText(QStringLiteral("\u2715"));
    close->setAutoRaise(true);
    close->setToolTip(tr("Close this message"));
    connect(close, &QToolButton::clicked, this, &QWidget::hide);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(10, 5, 5, 5);
    row->addWidget(label_, 1);
    row->addWidget(more_, 0, Qt::AlignTop);
    add(remedy_, "remedy", *row);
    add(other_, "otherRemedy", *row);
    row->addWidget(close, 0, Qt::AlignTop);
    leave_->setSingleShot(true);
    leave_->setInterval(noteMs);
    connect(leave_, &QTimer::timeout, this, &QWidget::hide);
    hide();
    followTheme(*this, [this] { paintColours(); });
}

bool MessageBar::eventFilter(QObject* watched, QEvent* event) {
    if (watched == label_ && event->type() == QEvent::MouseButtonRelease)
        closeByClick(*static_cast<QMouseEvent*>(event));
    return QFrame::eventFilter(watched, event);
}

void MessageBar::mouseReleaseEvent(QMouseEvent* event) { closeByClick(*event); }

// Not one that ends a selection of the text or opens its menu; what offers a remedy waits for its buttons.
void MessageBar::closeByClick(const QMouseEvent& event) {
    const bool offers = remedy_.button->isVisible() || other_.button->isVisible();
    if (event.button() == Qt::LeftButton && !label_->hasSelectedText() && !offers) hide();
}

void MessageBar::showError(const Error& error) {
    isError_ = true;
    show(describeError(error));
    unfold(true);
}

void MessageBar::add(Remedy& remedy, const char* name, QHBoxLayout& row) {
    remedy.button->setObjectName(QString::fromLatin1(name));
    row.addWidget(remedy.button, 0, Qt::AlignTop);
    connect(remedy.button, &QPushButton::clicked, this, [this, &remedy] {
        hide();
        if (const auto chosen = std::exchange(remedy.chosen, nullptr)) chosen();
    });
}

void MessageBar::offer(Remedy& remedy, const QString& text, std::function<void()> done) {
    remedy.chosen = std::move(done);
    remedy.button->setText(text);
    remedy.button->show();
}

void MessageBar::offer(const QString& remedy, std::function<void()> done) {
    offer(remedy_, remedy, std::move(done));
}

void MessageBar::offerSecond(const QString& remedy, std::function<void()> done) {
    offer(other_, remedy, std::move(done));
}

void MessageBar::showNote(const QString& text) {
    isError_ = false;
    show(text);
    leave_->start();
}

void MessageBar::showHelp(const QString& text) {
    isError_ = false;
    show(text);
}

void MessageBar::dismiss() {
    if (remedy_.button->isHidden()) hide();
}

QString MessageBar::text() const { return isHidden() ? QString() : text_; }

// Of several lines only the first is shown, so that a message takes no more of the view than it must.
void MessageBar::unfold(bool all) {
    const auto others = text_.count(QLatin1Char('\n'));
    unfolded_ = all;
    label_->setText(all ? text_ : firstLine(text_));
    const QString more = tr("%1 more line(s)", "", pluralNumber(quint64(others)));
    more_->setText(all ? tr("Less") : more.arg(formatCount(quint64(others))));
    more_->setVisible(others > 0);
}

void MessageBar::paintColours() {
    const NoteColours colours = isError_ ? errorColours(themeInUse()) : noteColours(themeInUse());
    setStyleSheet(QStringLiteral("#messageBar { background: %1; border: 1px solid %2; border-radius: 4px; } "
                                 "#messageBar QLabel, #messageBar QToolButton { color: %3; border: none; }")
                      .arg(colours.background.name(), colours.border.name(), colours.text.name()));
}

void MessageBar::show(const QString& text) {
    leave_->stop();
    text_ = text;
    paintColours();
    unfold(false);
    for (const Remedy* remedy : {&remedy_, &other_}) remedy->button->hide();
    QFrame::show();
}

namespace {

constexpr int shortMs = 400;

}  // namespace

ProgressStrip::ProgressStrip(QBoxLayout::Direction direction, QWidget* parent)
    : QWidget(parent),
      label_(new QLabel),
      bar_(new QProgressBar),
      cancel_(pushButton(tr("Cancel"), "cancel", tr("Stop this job; the previous result stays"))) {
    label_->setWordWrap(direction == QBoxLayout::TopToBottom);
    bar_->setRange(0, 1000);
    bar_->setTextVisible(false);
    bar_->setMinimumWidth(120);
    bar_->setMaximumHeight(14);
    auto* layout = new QBoxLayout(direction, this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(label_);
    layout->addWidget(bar_);
    layout->addWidget(cancel_);
    wait_.setSingleShot(true);
    connect(&wait_, &QTimer::timeout, this, &ProgressStrip::showLast);
    hide();
}

void ProgressStrip::follow(JobSlot& slot, Jobs jobs, const QWidget* other) {
    connect(&slot, &JobSlot::started, this, [this, &slot, jobs, other](const Job& job, const QString& what) {
        begin({&slot, jobs, other, what, tr("starting")}, job);
    });
    connect(&slot, &JobSlot::ended, this, [this, &slot] { finish(slot); });
    if (jobs == Jobs::whole) return;
    connect(cancel_, &QPushButton::clicked, &slot, [this, &slot] {
        if (!running_.empty() && running_.back().slot == &slot) slot.cancel();
    });
}

void ProgressStrip::begin(Running now, const Job& job) {
    const JobSlot& slot = *now.slot;
    std::erase_if(running_, [&](const Running& one) { return one.slot == &slot; });
    connect(&job, &Job::progressed, this, [this, &slot](double fraction, const QString& stage) {
        take(slot, fraction, translated(stage.toStdString()));
    });
    const bool isFirst = running_.empty();
    const bool waits = now.jobs == Jobs::often;
    running_.insert(waits ? running_.begin() : running_.end(), std::move(now));
    if (waits && isFirst && !isVisible()) return wait_.start(shortMs);
    showLast();
}

void ProgressStrip::take(const JobSlot& slot, double fraction, const QString& stage) {
    const auto one = std::ranges::find(running_, &slot, &Running::slot);
    if (one == running_.end()) return;
    one->fraction = fraction;
    one->stage = stage;
    if (!wait_.isActive()) showLast();
}

void ProgressStrip::finish(const JobSlot& slot) {
    std::erase_if(running_, [&](const Running& one) { return one.slot == &slot; });
    showLast();
}

// A dock behind another tab counts as visible for Qt, but lies outside of the window.
bool ProgressStrip::isSeen(const QWidget& widget) {
    return widget.isVisible() && !widget.visibleRegion().isEmpty();
}

void ProgressStrip::showLast() {
    wait_.stop();
    if (running_.empty()) return hide();
    const Running& last = running_.back();
    cancel_->setVisible(last.jobs != Jobs::whole);
    const auto textAt = [&](int percent) { return QStringLiteral("%1, %2 %").arg(last.what).arg(percent); };
    label_->setText(textAt(int(last.fraction * 100)));
    if (!label_->wordWrap()) label_->setMinimumWidth(label_->fontMetrics().horizontalAdvance(textAt(100)));
    setToolTip(last.stage);
    bar_->setValue(int(last.fraction * bar_->maximum()));
    setVisible(!last.other || !isSeen(*last.other));
}

}  // namespace noonmark
