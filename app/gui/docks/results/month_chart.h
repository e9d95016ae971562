#pragma once

#include <QWidget>
#include <vector>

#include "scenarios/weights/score.h"

namespace noonmark {

/// Two bar charts of a score by month, both in m²: the shadow area, and the month's contribution to the
/// score.
class MonthChart final : public QWidget {
    Q_OBJECT
public:
    explicit MonthChart(QWidget* parent = nullptr);

    void show(const std::vector<MonthFigures>& months);  ///< none: hides the charts

private:
    std::vector<MonthFigures> months_;
};

}  // namespace noonmark
