#pragma once

#include <QWidget>
#include <vector>

#include "scenarios/weights/score.h"

namespace noonmark {

/// Two bar charts over the months of a score: shadow area, and what each month adds to the score, both in m².
class MonthChart final : public QWidget {
    Q_OBJECT
public:
    explicit MonthChart(QWidget* parent = nullptr);

    void show(const std::vector<MonthFigures>& months);  ///< none: the charts hide
};

}  // namespace noonmark
