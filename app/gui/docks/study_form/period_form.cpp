#include "app/gui/docks/study_form/period_form.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <cmath>

#include "app/gui/base/widgets/folded_section.h"
#include "app/gui/base/widgets/number_fields.h"

namespace noonmark {

namespace {

std::chrono::minutes minutesOf(double hours) { return std::chrono::minutes(std::lround(hours * 60)); }
double hoursOf(std::chrono::minutes minutes) { return double(minutes.count()) / 60; }

}  // namespace

PeriodForm::PeriodForm(QWidget* parent) : QWidget(parent) {
    makeFields();
    placeFields();
    tell();
    show(Period{});
}

void PeriodForm::makeFields() {
    window_ = new QCheckBox(tr("From sunrise to sunset"));
    afterSunrise_ = numberField(0, 12, 2, 0.25, tr(" h"));
    beforeSunset_ = numberField(0, 12, 2, 0.25, tr(" h"));
    rule_ = new QComboBox;
    rule_->addItems({tr("first light of the disc (-0.833°)"), tr("middle of the disc (0°)")});
}

void PeriodForm::placeFields() {
    auto* form = new QFormLayout(this);
    form->setContentsMargins(0, 0, 0, 0);
    form->setFieldGrowthPolicy(QFormLayout::ExpandingFieldsGrow);
    rows_.addRows(*form, {"--start", "--days"});
    form->addRow(QString(), window_);
    form->addRow(tr("After sunrise"), afterSunrise_);
    form->addRow(tr("Before sunset"), beforeSunset_);
    rows_.addRows(*form, {"--from", "--hours"});
    auto* details = new QWidget;
    auto* more = new QFormLayout(details);
    more->setContentsMargins(12, 0, 0, 0);
    rows_.addRows(*more, {"--zone", "--step"});
    more->addRow(tr("Sunrise at"), rule_);
    rows_.addRows(*more, {"--no-refraction"});
    form->addRow(new FoldedSection(tr("Time zone and sun"), "periodDetails", details));
}

void PeriodForm::follow(QWidget* field, const char* name) {
    const auto changed = [this, name] {
        enableFields();
        if (!showing_) Q_EMIT edited(QString::fromLatin1(name));
    };
    if (auto* number = qobject_cast<QDoubleSpinBox*>(field))
        connect(number, &QDoubleSpinBox::valueChanged, this, changed);
    if (auto* box = qobject_cast<QCheckBox*>(field)) connect(box, &QCheckBox::toggled, this, changed);
    if (auto* combo = qobject_cast<QComboBox*>(field))
        connect(combo, &QComboBox::currentIndexChanged, this, changed);
}

void PeriodForm::tell() {
    const auto add = [this](QWidget* field, const char* name, const char* objectName, const QString& tip) {
        field->setObjectName(QString::fromLatin1(objectName));
        field->setToolTip(tip);
        follow(field, name);
    };
    const auto explain = [this](std::string_view flag, const QString& tip) {
        rows_.widget(flag)->setToolTip(tip);
    };
    rows_.widget("--start")->setObjectName(QStringLiteral("startDate"));
    rows_.widget("--no-refraction")->setObjectName(QStringLiteral("refraction"));
    explain("--start", tr("First day of the period, local date in the time zone"));
    explain("--from", tr("Wall-clock time at which each day's window begins, hours:minutes"));
    explain("--zone", tr("IANA time zone of the wall clock, daylight saving included.\nSet to that of the "
                         "nearest city when a file is opened: check it near borders."));
    explain("--no-refraction",
            tr("On: the air lifts the sun a little near the horizon (refraction).\nOff: the sun's geometric "
               "position, as some rules require"));
    for (const auto& [flag, step] : {std::pair{"--hours", 0.5}, std::pair{"--step", 1.0}})
        qobject_cast<QDoubleSpinBox*>(rows_.widget(flag))->setSingleStep(step);
    connect(&rows_, &FieldRows::edited, this, &PeriodForm::edited);
    add(window_, "solar window", "solarWindow", tr("Use sunrise and sunset instead of clock times"));
    add(afterSunrise_, "after sunrise", "afterSunrise",
        tr("The window begins this many hours after sunrise"));
    add(beforeSunset_, "before sunset", "beforeSunset", tr("The window ends this many hours before sunset"));
    add(rule_, "sunrise rule", "sunriseRule",
        tr("Which moment counts as sunrise and sunset: the altitude of the sun's centre"));
}

void PeriodForm::enableFields() {
    const bool solar = window_->isChecked();
    auto* form = static_cast<QFormLayout*>(layout());
    const auto setShown = [form](QWidget* field, bool shown) {
        field->setVisible(shown);
        form->labelForField(field)->setVisible(shown);
    };
    setShown(rows_.widget("--from"), !solar);
    setShown(rows_.widget("--hours"), !solar);
    setShown(afterSunrise_, solar);
    setShown(beforeSunset_, solar);
    rule_->setEnabled(solar);
}

Period PeriodForm::period() const {
    Period period;
    rows_.take(periodFields().of(period));
    if (window_->isChecked())
        period.window = SolarHours{minutesOf(afterSunrise_->value()), minutesOf(beforeSunset_->value()),
                                   SunriseRule(rule_->currentIndex())};
    return period;
}

void PeriodForm::show(const Period& period) {
    showing_ = true;
    rows_.show(periodFields().of(period));
    window_->setChecked(period.window.has_value());
    const SolarHours window = period.window.value_or(SolarHours{});
    afterSunrise_->setValue(hoursOf(window.afterSunrise));
    beforeSunset_->setValue(hoursOf(window.beforeSunset));
    rule_->setCurrentIndex(int(window.rule));
    showing_ = false;
    enableFields();
}

}  // namespace noonmark
