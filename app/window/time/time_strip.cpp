#include "app/window/time/time_strip.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>

#include "app/window/frame/qt_dates.h"
#include "app/window/widgets/push_button.h"

namespace noonmark {

namespace {

constexpr int minutesADay = 24 * 60;
constexpr int spanWidth = 166;
constexpr int wordsWidth = 240;

QSlider* slider(const char* name, const QString& tip, int last, int page) {
    auto* slider = new QSlider(Qt::Horizontal);
    slider->setObjectName(QString::fromLatin1(name));
    slider->setToolTip(tip);
    slider->setRange(0, last);
    slider->setPageStep(page);
    return slider;
}

QDate firstOfYear(CivilDate date) { return {int(date.year()), 1, 1}; }

}  // namespace

TimeStrip::TimeStrip(QWidget* parent)
    : QWidget(parent),
      span_(new QComboBox),
      date_(slider("lookDate",
                   tr("The date, in the year of the study. Arrows: a day; Page Up and Down: a month"), 364,
                   30)),
      time_(slider("lookTime", tr("The wall-clock time. Arrows: a minute; Page Up and Down: an hour"),
                   minutesADay - 1, 60)),
      words_(new QLabel),
      use_(pushButton(
          tr("Set as period"), "lookStudy",
          tr("Makes this day or moment the period of the study; Run then computes its figures and errors"))) {
    span_->setObjectName(QStringLiteral("lookSpan"));
    span_->addItems({tr("Whole period"), tr("One day"), tr("One moment")});
    span_->setToolTip(
        tr("Shows the whole study, or its shadow on one day or at one moment as the sliders move.\nUses "
           "horizons cached in steps of half a degree: shadows may be off by a quarter of a degree of the "
           "sun's path."));
    place();
    connectFields();
    showLook();
}

void TimeStrip::place() {
    words_->setObjectName(QStringLiteral("lookText"));
    span_->setFixedWidth(spanWidth);
    words_->setMinimumWidth(wordsWidth);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(12, 2, 12, 2);
    row->addWidget(span_, 0, Qt::AlignLeft);
    row->addWidget(date_, 2);
    row->addWidget(time_, 3);
    row->addWidget(words_);
    row->addWidget(use_);
}

void TimeStrip::connectFields() {
    connect(span_, &QComboBox::currentIndexChanged, this, &TimeStrip::take);
    connect(date_, &QSlider::valueChanged, this, &TimeStrip::take);
    connect(time_, &QSlider::valueChanged, this, &TimeStrip::take);
    connect(use_, &QPushButton::clicked, this, [this] { Q_EMIT taken(look_); });
}

void TimeStrip::setPeriod(const Period& period) {
    TimeLook look = firstLook(period);
    if (look.date.year() == look_.date.year()) look = look_;
    setLook(look);
}

void TimeStrip::setLook(const TimeLook& look) {
    look_ = look;
    showLook();
}

void TimeStrip::setAnswer(const TimeLook& of, const QString& words) {
    words_->setText(QStringLiteral("%1: %2").arg(describe(of), words));
}

void TimeStrip::take() {
    look_ = {LookSpan(span_->currentIndex()), civilOf(firstOfYear(look_.date).addDays(date_->value())),
             std::chrono::minutes(time_->value())};
    showLook();
    Q_EMIT lookChanged(look_);
}

void TimeStrip::showLook() {
    const QSignalBlocker span(span_), date(date_), time(time_);
    const QDate first = firstOfYear(look_.date);
    span_->setCurrentIndex(int(look_.span));
    date_->setMaximum(first.daysInYear() - 1);
    date_->setValue(int(first.daysTo(dateOf(look_.date))));
    time_->setValue(int(look_.at.count()));
    date_->setVisible(look_.span != LookSpan::period);
    time_->setVisible(look_.span == LookSpan::moment);
    words_->setVisible(look_.span != LookSpan::period);
    use_->setVisible(look_.span != LookSpan::period);
}

}  // namespace noonmark
