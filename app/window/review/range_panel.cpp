#include "app/window/review/range_panel.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPixmap>
#include <QVBoxLayout>

#include "app/window/review/chart_widget.h"

namespace noonmark {

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
                     tr("Incremental by month")});
    reading_->setText(QString());
    auto* row = new QHBoxLayout;
    row->addWidget(title_, 1);
    row->addWidget(what_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(6, 4, 6, 4);
    column->addLayout(row);
    column->addWidget(widget_, 1);
    column->addWidget(reading_);
    connect(what_, &QComboBox::activated, this, &RangePanel::draw);
    connect(widget_, &ChartWidget::hovered, this, [this](QPointF at) {
        const auto cell = cellAt(at);
        reading_->setText(cell ? describeCell(carpet_, *cell) : QString());
    });
    connect(widget_, &ChartWidget::left, this,
            [this] { reading_->setText(tr("Click a day for its timeline.")); });
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
    title_->setText(QString::fromStdString(answer_->study.places[review_].name));
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
            widget_->show([why = QString::fromStdString(range.error().text())](
                              const Canvas& canvas, const QRectF& area) { paintNothing(canvas, area, why); });
        });
}

void RangePanel::draw() {
    if (!range_) return;
    if (what_->currentIndex() == barsIndex) return drawBars();
    carpet_ = makeCarpetChart(range_->days, CarpetQuantity(what_->currentIndex()),
                              std::max(carpetRowMin, range_->stepMinutes), range_->clock);
    reading_->setText(tr("Click a day for its timeline."));
    widget_->show([this](const Canvas& canvas, const QRectF& area) { paintCarpet(canvas, area, carpet_); });
}

void RangePanel::drawBars() {
    carpet_ = {};
    reading_->clear();
    const MonthBars bars{answer_->study.places[review_].totals.incrementalByMonthM2h, tr("m² h"),
                         tr("Incremental shadow by month")};
    widget_->show([bars](const Canvas& canvas, const QRectF& area) { paintMonthBars(canvas, area, bars); });
}

std::optional<CarpetCell> RangePanel::cellAt(QPointF at) const {
    QPixmap measure(1, 1);
    QPainter painter(&measure);
    return findCellAt(widget_->canvasOn(painter), widget_->area(), carpet_, at);
}

}  // namespace noonmark
