#include "app/window/progress_strip.h"

#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

#include "app/window/job.h"
#include "app/window/push_button.h"

namespace noonmark {

ProgressStrip::ProgressStrip(QBoxLayout::Direction direction, QWidget* parent)
    : QWidget(parent),
      label_(new QLabel),
      bar_(new QProgressBar),
      cancel_(pushButton(tr("Cancel"), "cancel", tr("Stop this work; what was there before stays"))) {
    connect(cancel_, &QPushButton::clicked, this, &ProgressStrip::cancelRequested);
    bar_->setRange(0, 1000);
    bar_->setTextVisible(false);
    bar_->setMinimumWidth(120);
    bar_->setMaximumHeight(14);
    auto* layout = new QBoxLayout(direction, this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(label_);
    layout->addWidget(bar_);
    layout->addWidget(cancel_);
    hide();
}

void ProgressStrip::follow(const Job& job, const QString& what, bool cancellable) {
    cancel_->setVisible(cancellable);
    label_->setText(what);
    bar_->setValue(0);
    connect(&job, &Job::progressed, this, [this, what](double fraction, const QString& stage) {
        bar_->setValue(int(fraction * 1000));
        label_->setText(QStringLiteral("%1: %2, %3 %").arg(what, stage).arg(int(fraction * 100)));
    });
    show();
}

void ProgressStrip::finish() { hide(); }

}  // namespace noonmark
