#pragma once

#include <QWidget>
#include <memory>

#include "app/gui/base/jobs/job_slot.h"
#include "app/gui/docks/review/review_days.h"
#include "app/report/charts/timeline_chart.h"

class QDateEdit;
class QLabel;

namespace noonmark {

class ChartWidget;

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

}  // namespace noonmark
