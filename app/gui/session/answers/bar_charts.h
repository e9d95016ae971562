#pragma once

#include <QWidget>
#include <vector>

#include "core/describe/answer_page.h"

namespace noonmark {

/// The charts of an answer, one below the other. A tooltip names the bar below the mouse with its value;
/// the context menu copies all values.
class BarCharts final : public QWidget {
    Q_OBJECT
public:
    explicit BarCharts(QWidget* parent = nullptr);

    void show(const std::vector<Bars>& charts);  ///< those without groups are left out; none: hides

private:
    std::vector<Bars> charts_;
};

}  // namespace noonmark
