#pragma once

#include <QWidget>
#include <functional>
#include <memory>
#include <optional>

#include "app/gui/base/jobs/job.h"
#include "app/gui/docks/review/review_cache.h"
#include "app/report/charts/bar_chart.h"
#include "app/report/charts/carpet_chart.h"
#include "app/report/charts/timeline_chart.h"
#include "app/report/maps/style.h"

class QDateEdit;
class QLabel;
class QComboBox;

namespace noonmark {

/// A widget that shows a chart of app/report/charts and reports where the mouse is on it.
class ChartWidget final : public QWidget {
    Q_OBJECT
public:
    using Paint = std::function<void(const Canvas&, const QRectF&)>;
    explicit ChartWidget(QWidget* parent = nullptr);

    void show(Paint paint);              ///< replaces the chart
    [[nodiscard]] QRectF area() const;   ///< in which the chart is painted
    [[nodiscard]] double point() const;  ///< as in Canvas

    [[nodiscard]] QSize sizeHint() const override { return {420, 190}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {240, 120}; }

Q_SIGNALS:
    void hovered(QPointF at);
    void left();
    void clicked(QPointF at);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    Paint paint_;
    std::optional<double> cursor_;  ///< the mouse's column, for the vertical line
};

/// The timeline of a place on one day: area in shadow against time in the baseline and in the scenario, and
/// the incremental shadow. Computed in a job when it is shown.
class DayPanel final : public QWidget {
    Q_OBJECT
public:
    explicit DayPanel(QWidget* parent = nullptr);

    /// `review`: index in the answer's study. The chart before stays until the new one is ready.
    void show(std::shared_ptr<const ReviewAnswer> answer, std::size_t review, CivilDate day);
    void setUnits(UnitSystem units);
    void clear(const QString& why);
    [[nodiscard]] const TimelineChart& chart() const { return chart_; }
    [[nodiscard]] JobSlot& working() { return working_; }

private:
    void compute();
    void take(Result<ReviewDay> day);
    void draw();
    void read(QPointF at);

    std::shared_ptr<const ReviewAnswer> answer_;
    std::size_t review_ = 0;
    UnitSystem units_ = UnitSystem::metric;
    std::optional<ReviewDay> shown_;
    TimelineChart chart_;  ///< of shown_
    QString times_;
    QLabel* title_;
    QLabel* reading_;
    QDateEdit* day_;
    ChartWidget* widget_;
    JobSlot working_;
};

/// The shaded share of a place by hour and day of a rule's range, or bars of its shadow by month. Computed in
/// a job while it is visible.
class RangePanel final : public QWidget {
    Q_OBJECT
public:
    explicit RangePanel(QWidget* parent = nullptr);

    void show(std::shared_ptr<const ReviewAnswer> answer, std::size_t review);
    void clear(const QString& why);
    void setUnits(UnitSystem units);
    [[nodiscard]] const CarpetChart& carpet() const { return carpet_; }
    [[nodiscard]] const BarChart& bars() const { return bars_; }
    [[nodiscard]] JobSlot& working() { return working_; }

Q_SIGNALS:
    void dayChosen(noonmark::CivilDate day);

protected:
    void showEvent(QShowEvent* event) override;

private:
    void compute();
    void draw();
    void drawBars();
    void read(QPointF at);
    void resetReading();
    [[nodiscard]] std::optional<CarpetCell> cellAt(QPointF at) const;

    std::shared_ptr<const ReviewAnswer> answer_;
    std::size_t review_ = 0;
    std::optional<ReviewRange> range_;  ///< of answer_ and review_; none: not computed yet
    UnitSystem units_ = UnitSystem::metric;
    CarpetChart carpet_;  ///< empty while bars are shown
    BarChart bars_;       ///< empty while a carpet is shown
    QLabel* title_;
    QLabel* reading_;
    QComboBox* what_;
    ChartWidget* widget_;
    JobSlot working_;
};

}  // namespace noonmark
