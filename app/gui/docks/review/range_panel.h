#pragma once

#include <QWidget>
#include <memory>

#include "app/gui/base/jobs/job_slot.h"
#include "app/gui/docks/review/review_days.h"
#include "app/report/charts/bar_chart.h"
#include "app/report/charts/carpet_chart.h"

class QComboBox;
class QLabel;

namespace noonmark {

class ChartWidget;

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
