#include "app/gui/docks/study_form/period_form.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>

#include "app/gui/base/widgets/folded_section.h"

namespace noonmark {

PeriodForm::PeriodForm(QWidget* parent)
    : QWidget(parent), window_(new QCheckBox(tr("From sunrise to sunset"))) {
    placeFields();
    tell();
    show(Period{});
}

void PeriodForm::placeFields() {
    auto* form = new QFormLayout(this);
    form->setContentsMargins(0, 0, 0, 0);
    form->setFieldGrowthPolicy(QFormLayout::ExpandingFieldsGrow);
    rows_.addRows(*form, {"--start", "--days"});
    form->addRow(QString(), window_);
    solar_.addRows(*form, {"--after-sunrise", "--before-sunset"});
    rows_.addRows(*form, {"--from", "--hours"});
    auto* details = new QWidget;
    auto* more = new QFormLayout(details);
    more->setContentsMargins(12, 0, 0, 0);
    rows_.addRows(*more, {"--zone", "--step"});
    solar_.addRows(*more, {"--sunrise-rule"});
    rows_.addRows(*more, {"--no-refraction"});
    form->addRow(new FoldedSection(tr("Time zone and sun"), "periodDetails", details));
}

void PeriodForm::tell() {
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
    for (const char* flag : {"--after-sunrise", "--before-sunset"})
        qobject_cast<QDoubleSpinBox*>(solar_.widget(flag))->setSingleStep(0.25);
    for (const FieldRows* rows : {&rows_, &solar_})
        connect(rows, &FieldRows::edited, this, &PeriodForm::edited);
    window_->setObjectName(QStringLiteral("solarWindow"));
    window_->setToolTip(tr("Use sunrise and sunset instead of clock times"));
    connect(window_, &QCheckBox::toggled, this, [this] {
        enableFields();
        if (!showing_) Q_EMIT edited(QStringLiteral("solar window"));
    });
}

void PeriodForm::enableFields() {
    const bool solar = window_->isChecked();
    auto* form = static_cast<QFormLayout*>(layout());
    const auto setShown = [form](QWidget* field, bool shown) {
        field->setVisible(shown);
        form->labelForField(field)->setVisible(shown);
    };
    for (const char* flag : {"--from", "--hours"}) setShown(rows_.widget(flag), !solar);
    for (const char* flag : {"--after-sunrise", "--before-sunset"}) setShown(solar_.widget(flag), solar);
    solar_.widget("--sunrise-rule")->setEnabled(solar);
}

Period PeriodForm::period() const {
    Period period;
    rows_.take(periodFields().of(period));
    if (!window_->isChecked()) return period;
    solar_.take(solarHoursFields().of(period.window.emplace()));
    return period;
}

void PeriodForm::show(const Period& period) {
    showing_ = true;
    rows_.show(periodFields().of(period));
    window_->setChecked(period.window.has_value());
    solar_.show(solarHoursFields().of(period.window.value_or(SolarHours{})));
    showing_ = false;
    enableFields();
}

}  // namespace noonmark
