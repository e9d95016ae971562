#include "app/gui/docks/review/chart_panels.h"

#include <QComboBox>
#include <QDateEdit>
#include <QHBoxLayout>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <utility>

#include "app/gui/base/looks/theme.h"
#include "app/gui/base/widgets/error_text.h"
#include "app/gui/base/widgets/number_text.h"
#include "app/gui/session/study/region_text.h"
#include "app/report/charts/chart_axes.h"
#include "app/report/maps/sheet_text.h"

namespace noonmark {

namespace {

constexpr double pointsPerInch = 72;

// The title with a control beside it, the chart, and the text of what the mouse points at.
void placeChart(QWidget& panel, QLabel* title, QWidget* control, ChartWidget* chart, QLabel* reading) {
    auto* row = new QHBoxLayout;
    row->addWidget(title, 1);
    row->addWidget(control);
    auto* column = new QVBoxLayout(&panel);
    column->setContentsMargins(6, 4, 6, 4);
    column->addLayout(row);
    column->addWidget(chart, 1);
    column->addWidget(reading);
}

}  // namespace

ChartWidget::ChartWidget(QWidget* parent) : QWidget(parent) {
    setMouseTracking(true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void ChartWidget::show(Paint paint) {
    paint_ = std::move(paint);
    update();
}

double ChartWidget::point() const { return logicalDpiY() / pointsPerInch; }

QRectF ChartWidget::area() const { return QRectF(rect()).adjusted(2, 4, -4, -2); }

void ChartWidget::paintEvent(QPaintEvent* /*event*/) {
    const SheetScope words;
    QPainter painter(this);
    const Inks inks = inksOf(themeInUse());
    painter.fillRect(rect(), inks.paper);
    if (paint_) paint_({painter, point(), inks}, area());
    const QRectF plot = plotIn(area(), point());
    if (!paint_ || !cursor_ || *cursor_ < plot.left() || *cursor_ > plot.right()) return;
    painter.setPen(QPen(inks.quiet, 1, Qt::DotLine));
    painter.drawLine(QPointF(*cursor_, plot.top()), QPointF(*cursor_, plot.bottom()));
}

void ChartWidget::mouseMoveEvent(QMouseEvent* event) {
    cursor_ = event->position().x();
    update();
    Q_EMIT hovered(event->position());
}

void ChartWidget::mousePressEvent(QMouseEvent* event) { Q_EMIT clicked(event->position()); }

void ChartWidget::leaveEvent(QEvent* /*event*/) {
    cursor_.reset();
    update();
    Q_EMIT left();
}

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
    day_->setKeyboardTracking(false);
    day_->setToolTip(tr("Any day, in the hours of the rule"));
    placeChart(*this, title_, day_, widget_, reading_);
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
    title_->setText(placeName(answer_->study.places[review_].name));
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
    const SheetScope words;
    chart_ = makeTimelineChart(shown_->day, shown_->stepMinutes, shown_->clock, units_);
    times_ = tr("%1 (%2).")
                 .arg(describeIncremental(shown_->day, shown_->clock, units_),
                      QString::fromStdString(shown_->clock.text()));
    reading_->setText(times_);
    widget_->show([this](const Canvas& canvas, const QRectF& area) { paintTimeline(canvas, area, chart_); });
}

void DayPanel::read(QPointF at) {
    const SheetScope words;
    const auto sample = findSampleAt(widget_->area(), widget_->point(), chart_, at);
    reading_->setText(sample ? describeSample(chart_, *sample) : times_);
}

namespace {

constexpr int barsIndex = 3;  // of the list; those before are CarpetQuantity
constexpr double carpetRowMin = 10;

}  // namespace

RangePanel::RangePanel(QWidget* parent)
    : QWidget(parent),
      title_(new QLabel),
      reading_(new QLabel),
      what_(new QComboBox),
      widget_(new ChartWidget) {
    title_->setTextFormat(Qt::PlainText);
    title_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    what_->setObjectName(QStringLiteral("rangeQuantity"));
    what_->addItems({tr("Incremental shadow"), tr("Shadow in the scenario"), tr("Shadow in the baseline"),
                     tr("Shadow by month")});
    reading_->setObjectName(QStringLiteral("rangeReading"));
    reading_->setWordWrap(true);
    placeChart(*this, title_, what_, widget_, reading_);
    connect(what_, &QComboBox::activated, this, &RangePanel::draw);
    connect(widget_, &ChartWidget::hovered, this, &RangePanel::read);
    connect(widget_, &ChartWidget::left, this, &RangePanel::resetReading);
    connect(widget_, &ChartWidget::clicked, this, [this](QPointF at) {
        if (const auto cell = cellAt(at)) Q_EMIT dayChosen(carpet_.days[cell->day]);
    });
    clear({});
}

void RangePanel::clear(const QString& why) {
    working_.drop();
    answer_.reset();
    range_.reset();
    carpet_ = {};
    bars_ = {};
    title_->clear();
    reading_->clear();
    widget_->show([why](const Canvas& canvas, const QRectF& area) { paintNothing(canvas, area, why); });
}

void RangePanel::show(std::shared_ptr<const ReviewAnswer> answer, std::size_t review) {
    if (hasFewDays(answer->question.rule))
        return clear(
            tr("This rule is about single days. Rules about a range of days, such as "
               "san-francisco-295, have a chart by hour and day of the year."));
    if (answer == answer_ && review == review_) return;
    clear(tr("Computing..."));
    answer_ = std::move(answer);
    review_ = review;
    title_->setText(placeName(answer_->study.places[review_].name));
    if (isVisible()) compute();
}

void RangePanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    if (answer_ && !range_ && !working_.busy()) compute();
}

void RangePanel::compute() {
    working_.start<ReviewRange>(
        tr("Chart of the range"),
        [answer = answer_, review = review_](Progress& progress, std::stop_token stop) {
            return computeReviewRange(*answer, review, progress, std::move(stop));
        },
        [this](Result<ReviewRange> range) {
            if (range) {
                range_ = *std::move(range);
                return draw();
            }
            widget_->show([why = describeError(range.error())](const Canvas& canvas, const QRectF& area) {
                paintNothing(canvas, area, why);
            });
        });
}

void RangePanel::draw() {
    if (!range_) return;
    if (what_->currentIndex() == barsIndex) return drawBars();
    bars_ = {};
    carpet_ =
        makeCarpetChart(range_->days, CarpetQuantity(what_->currentIndex()), carpetRowMin, range_->clock);
    resetReading();
    widget_->show([this](const Canvas& canvas, const QRectF& area) { paintCarpet(canvas, area, carpet_); });
}

void RangePanel::drawBars() {
    const SheetScope words;
    carpet_ = {};
    bars_ = makeMonthBars(answer_->study.places[review_], units_);
    resetReading();
    widget_->show([this](const Canvas& canvas, const QRectF& area) { paintBars(canvas, area, bars_); });
}

void RangePanel::setUnits(UnitSystem units) {
    if (std::exchange(units_, units) != units) draw();
}

void RangePanel::read(QPointF at) {
    const SheetScope words;
    if (const auto cell = cellAt(at)) return reading_->setText(describeCell(carpet_, *cell));
    const auto group = findGroupAt(widget_->area(), widget_->point(), bars_, at);
    group ? reading_->setText(describeGroup(bars_, *group)) : resetReading();
}

void RangePanel::resetReading() {
    if (!range_) return reading_->clear();
    const bool mirrored = answer_->question.rule.days.mirrored;
    if (bars_.groups.empty())
        reading_->setText(tr("Click a day for its timeline."));
    else
        reading_->setText(mirrored ? tr("Area × hours in shadow; each month counts twice, for both halves of "
                                        "the year.")
                                   : tr("Area × hours in shadow."));
}

std::optional<CarpetCell> RangePanel::cellAt(QPointF at) const {
    return findCellAt(widget_->area(), widget_->point(), carpet_, at);
}

}  // namespace noonmark
