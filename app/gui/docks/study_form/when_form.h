#pragma once

#include <QString>
#include <QWidget>
#include <array>
#include <optional>

#include "app/gui/base/widgets/field_rows.h"
#include "core/review/rule/rule.h"
#include "core/sun/period.h"
#include "core/sun/period_fields.h"

class QCheckBox;
class QComboBox;
class QMenu;
class QPushButton;

namespace noonmark {

/// Fields for a Period: dates, hours, time zone, apparent or geometric sun.
class PeriodForm final : public QWidget {
    Q_OBJECT
public:
    explicit PeriodForm(QWidget* parent = nullptr);

    [[nodiscard]] Period period() const;
    void show(const Period& period);  ///< without a signal

Q_SIGNALS:
    void edited(QString field);  ///< the name of the field: "start date"

private:
    void placeFields();
    void explainFields();
    void enableFields();

    FieldRows rows_{periodFields().rows()};
    FieldRows solar_{solarHoursFields().rows()};  ///< of the hours from sunrise to sunset
    QCheckBox* window_;
    bool showing_ = false;
};

/// Days that planners ask for most.
enum class PeriodPreset { today, march, june, december, growingSeason, year, own };

/// In the order of the list; `own` is the last.
inline constexpr std::array allPeriodPresets{
    PeriodPreset::today,         PeriodPreset::march, PeriodPreset::june, PeriodPreset::december,
    PeriodPreset::growingSeason, PeriodPreset::year,  PeriodPreset::own};

/// "21 March"; the growing season with its months, which depend on the hemisphere.
QString nameOf(PeriodPreset preset, double latitudeDeg);

/// `period` with the days of the preset, in the year of the period; hours and all else stay. The growing
/// season is April to October, south of the equator October to April. `own` changes nothing.
Period withPresetDays(PeriodPreset preset, Period period, CivilDate today, double latitudeDeg);

/// The preset whose days the period has; the first of several, `own` if none.
PeriodPreset presetOf(const Period& period, CivilDate today, double latitudeDeg);

/// The hours and step of a rule on one of its fixed days, in the year and zone of `period`. Nothing where a
/// study's period cannot state them: hours between bounds of several kinds, a clock other than the wall
/// clock, steps that begin on full hours, or sun above a lowest altitude only.
std::optional<Period> periodOf(const Rule& rule, std::chrono::month_day day, const Period& period);

/// The same for a rule about a range of days, every one of which counts once.
std::optional<Period> periodOf(const Rule& rule, const Period& period);

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
