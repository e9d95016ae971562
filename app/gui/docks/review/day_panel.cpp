#include "app/gui/docks/review/day_panel.h"

#include <QDateEdit>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <utility>

#include "app/gui/base/widgets/error_words.h"
#include "app/gui/base/widgets/qt_dates.h"
#include "app/gui/docks/review/chart_widget.h"

namespace noonmark {

DayPanel::DayPanel(QWidget* parent)
    : QWidget(parent),
      title_(new QLabel),
      reading_(new QLabel),
      day_(new QDateEdit),
      widget_(new ChartWidget) {
    title_->setTextFormat(Qt::PlainText);
    title_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    reading_->setObjectName(QStringLiteral("timelineReading"));
    reading_->setWordWrap(true);
    day_->setObjectName(QStringLiteral("timelineDay"));
    day_->setDisplayFormat(dayOfYear());
    day_->setCalendarPopup(true);
    day_->setToolTip(tr("Any day, in the hours of the rule"));
    auto* row = new QHBoxLayout;
    row->addWidget(title_, 1);
    row->addWidget(day_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(6, 4, 6, 4);
    column->addLayout(row);
    column->addWidget(widget_, 1);
    column->addWidget(reading_);
    connect(day_, &QDateEdit::dateChanged, this, &DayPanel::compute);
    connect(widget_, &ChartWidget::hovered, this, &DayPanel::read);
    connect(widget_, &ChartWidget::left, this, [this] { reading_->setText(times_); });
    clear({});
}

void DayPanel::clear(const QString& why) {
    working_.drop();
    answer_.reset();
    shown_.reset();
    chart_ = {};
    times_.clear();
    title_->clear();
    reading_->clear();
    day_->hide();
    widget_->show([why](const Canvas& canvas, const QRectF& area) { paintNothing(canvas, area, why); });
}

void DayPanel::show(std::shared_ptr<const ReviewAnswer> answer, std::size_t review, CivilDate day) {
    answer_ = std::move(answer);
    review_ = review;
    const QSignalBlocker block(day_);
    day_->setDate(dateOf(day));
    day_->show();
    compute();
}

void DayPanel::compute() {
    if (!answer_) return;
    title_->setText(QString::fromStdString(answer_->study.places[review_].name));
    working_.start<ReviewDay>(
        tr("Timeline"),
        [answer = answer_, review = review_, day = civilOf(day_->date())](Progress& progress,
                                                                          std::stop_token stop) {
            return computeReviewDay(*answer, review, day, progress, std::move(stop));
        },
        [this](Result<ReviewDay> day) { take(std::move(day)); });
}

void DayPanel::take(Result<ReviewDay> day) {
    if (day) {
        shown_ = *std::move(day);
        return draw();
    }
    if (isCancelled(day.error())) return;
    shown_.reset();
    chart_ = {};
    times_.clear();
    reading_->clear();
    widget_->show([why = describeError(day.error())](const Canvas& canvas, const QRectF& area) {
        paintNothing(canvas, area, why);
    });
}

void DayPanel::setUnits(UnitSystem units) {
    if (std::exchange(units_, units) != units && shown_) draw();
}

void DayPanel::draw() {
    chart_ = makeTimelineChart(shown_->day, shown_->stepMinutes, shown_->clock, units_);
    times_ = tr("%1 (%2).")
                 .arg(describeIncremental(shown_->day, shown_->clock, units_),
                      QString::fromStdString(shown_->clock.text()));
    reading_->setText(times_);
    widget_->show([this](const Canvas& canvas, const QRectF& area) { paintTimeline(canvas, area, chart_); });
}

void DayPanel::read(QPointF at) {
    const auto sample = findSampleAt(widget_->area(), widget_->point(), chart_, at);
    reading_->setText(sample ? describeSample(chart_, *sample) : times_);
}

}  // namespace noonmark
