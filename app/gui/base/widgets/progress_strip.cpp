#include "app/gui/base/widgets/progress_strip.h"

#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

#include "app/gui/base/jobs/job.h"
#include "app/gui/base/widgets/buttons.h"

namespace noonmark {

namespace {

constexpr int shortMs = 400;

}  // namespace

ProgressStrip::ProgressStrip(QBoxLayout::Direction direction, QWidget* parent)
    : QWidget(parent),
      label_(new QLabel),
      bar_(new QProgressBar),
      cancel_(pushButton(tr("Cancel"), "cancel", tr("Stop this job; the previous result stays"))) {
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
    connect(&wait_, &QTimer::timeout, this, &QWidget::show);
    hide();
}

void ProgressStrip::follow(JobSlot& slot, Jobs jobs, const QWidget* other) {
    connect(&slot, &JobSlot::started, this, [this, &slot, jobs, other](const Job& job, const QString& what) {
        begin(slot, jobs, other, job, what);
    });
    connect(&slot, &JobSlot::ended, this, [this, &slot] { finish(slot); });
    if (jobs == Jobs::whole) return;
    connect(cancel_, &QPushButton::clicked, &slot, [this, &slot] {
        if (shown_ == &slot) slot.cancel();
    });
}

void ProgressStrip::begin(const JobSlot& slot, Jobs jobs, const QWidget* other, const Job& job,
                          const QString& what) {
    if (jobs == Jobs::often && shown_ && shown_ != &slot) return;
    shown_ = &slot;
    cancel_->setVisible(jobs != Jobs::whole);
    label_->setText(what);
    bar_->setValue(0);
    connect(&job, &Job::progressed, this, [this, &slot, other, what](double fraction, const QString& stage) {
        if (shown_ != &slot) return;
        if (other) setVisible(!other->isVisible());
        bar_->setValue(int(fraction * 1000));
        label_->setText(QStringLiteral("%1: %2, %3 %").arg(what, stage).arg(int(fraction * 100)));
    });
    if (jobs == Jobs::often && !isVisible()) return wait_.start(shortMs);
    wait_.stop();
    setVisible(!other || !other->isVisible());
}

void ProgressStrip::finish(const JobSlot& slot) {
    if (shown_ != &slot) return;
    shown_ = nullptr;
    wait_.stop();
    hide();
}

}  // namespace noonmark
