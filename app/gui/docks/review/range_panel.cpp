#include "app/gui/docks/review/range_panel.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <utility>

#include "app/gui/base/widgets/error_words.h"
#include "app/gui/docks/review/chart_widget.h"

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
                     tr("Shadow by month")});
    reading_->setObjectName(QStringLiteral("rangeReading"));
    reading_->setWordWrap(true);
    auto* row = new QHBoxLayout;
    row->addWidget(title_, 1);
    row->addWidget(what_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(6, 4, 6, 4);
    column->addLayout(row);
    column->addWidget(widget_, 1);
    column->addWidget(reading_);
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
    carpet_ = {};
    bars_ = makeMonthBars(answer_->study.places[review_], units_);
    resetReading();
    widget_->show([this](const Canvas& canvas, const QRectF& area) { paintBars(canvas, area, bars_); });
}

void RangePanel::setUnits(UnitSystem units) {
    if (std::exchange(units_, units) != units) draw();
}

void RangePanel::read(QPointF at) {
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
