#pragma once

#include <QWidget>

#include "core/review/rule/rule.h"
#include "core/sun/period.h"

class QComboBox;
class QMenu;
class QPushButton;

namespace noonmark {

class PeriodForm;

/// When: days that are asked for often, the days and hours of a rule, and the fields of a period.
class WhenForm final : public QWidget {
    Q_OBJECT
public:
    explicit WhenForm(QWidget* parent = nullptr);

    void show(const Period& period);       ///< without a signal
    void setLatitude(double latitudeDeg);  ///< decides the growing season
    /// The rules whose days and hours are offered; those that no period can state are left out.
    void setRules(const std::vector<Rule>& rules);

Q_SIGNALS:
    void edited(noonmark::Period period, QString field);  ///< the name of the field: "start date"

private:
    void fillPresets();
    void showPreset();
    void fillRules();
    void addDays(QMenu& menu, const Rule& rule);

    QComboBox* presets_;
    QPushButton* ofRule_;
    QMenu* rulesMenu_;
    PeriodForm* period_;
    std::vector<Rule> rules_;
    double latitudeDeg_ = 0;
};

}  // namespace noonmark
