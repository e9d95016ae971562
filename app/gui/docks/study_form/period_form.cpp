#include "app/gui/docks/study_form/period_form.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCompleter>
#include <QDateEdit>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QTimeEdit>
#include <cmath>

#include "app/gui/base/widgets/folded_section.h"
#include "app/gui/base/widgets/number_fields.h"
#include "app/gui/base/widgets/qt_dates.h"

namespace noonmark {

namespace {

std::chrono::minutes minutesOf(double hours) { return std::chrono::minutes(std::lround(hours * 60)); }
double hoursOf(std::chrono::minutes minutes) { return double(minutes.count()) / 60; }

QComboBox* zoneField() {
    auto* zone = new QComboBox;
    zone->setEditable(true);
    zone->setInsertPolicy(QComboBox::NoInsert);
    for (const std::string& name : zoneNames()) zone->addItem(QString::fromStdString(name));
    zone->completer()->setCompletionMode(QCompleter::PopupCompletion);
    zone->completer()->setFilterMode(Qt::MatchContains);
    zone->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    zone->setMinimumContentsLength(14);
    return zone;
}

}  // namespace

PeriodForm::PeriodForm(QWidget* parent) : QWidget(parent) {
    makeFields();
    placeFields();
    tell();
    show(Period{});
}

void PeriodForm::makeFields() {
    start_ = new QDateEdit;
    start_->setCalendarPopup(true);
    start_->setDisplayFormat(QStringLiteral("yyyy-MM-dd"));
    start_->setDateRange(QDate(1900, 1, 2), QDate(2099, 12, 30));
    from_ = new QTimeEdit;
    from_->setDisplayFormat(QStringLiteral("HH:mm"));
    zone_ = zoneField();
    window_ = new QCheckBox(tr("From sunrise to sunset"));
    afterSunrise_ = numberField(0, 12, 2, 0.25, tr(" h"));
    beforeSunset_ = numberField(0, 12, 2, 0.25, tr(" h"));
    rule_ = new QComboBox;
    rule_->addItems({tr("first light of the disc (-0.833°)"), tr("middle of the disc (0°)")});
    refraction_ = new QCheckBox(tr("Sun as seen through the air"));
}

void PeriodForm::placeFields() {
    auto* form = new QFormLayout(this);
    form->setContentsMargins(0, 0, 0, 0);
    form->setFieldGrowthPolicy(QFormLayout::ExpandingFieldsGrow);
    form->addRow(tr("First day"), start_);
    rows_.addRows(*form, {"--days"});
    form->addRow(QString(), window_);
    form->addRow(tr("After sunrise"), afterSunrise_);
    form->addRow(tr("Before sunset"), beforeSunset_);
    form->addRow(tr("From"), from_);
    rows_.addRows(*form, {"--hours"});
    auto* details = new QWidget;
    auto* more = new QFormLayout(details);
    more->setContentsMargins(12, 0, 0, 0);
    more->addRow(tr("Time zone"), zone_);
    rows_.addRows(*more, {"--step"});
    more->addRow(tr("Sunrise at"), rule_);
    more->addRow(QString(), refraction_);
    form->addRow(new FoldedSection(tr("Time zone and sun"), "periodDetails", details));
}

void PeriodForm::follow(QWidget* field, const char* name) {
    const auto changed = [this, name] {
        enableFields();
        if (!showing_) Q_EMIT edited(QString::fromLatin1(name));
    };
    if (auto* date = qobject_cast<QDateTimeEdit*>(field))
        connect(date, &QDateTimeEdit::dateTimeChanged, this, changed);
    if (auto* number = qobject_cast<QDoubleSpinBox*>(field))
        connect(number, &QDoubleSpinBox::valueChanged, this, changed);
    if (auto* box = qobject_cast<QCheckBox*>(field)) connect(box, &QCheckBox::toggled, this, changed);
    if (auto* combo = qobject_cast<QComboBox*>(field)) {
        connect(combo, &QComboBox::currentIndexChanged, this, changed);
        if (combo->isEditable()) connect(combo->lineEdit(), &QLineEdit::editingFinished, this, changed);
    }
}

void PeriodForm::tell() {
    const auto add = [this](QWidget* field, const char* name, const char* objectName, const QString& tip) {
        field->setObjectName(QString::fromLatin1(objectName));
        field->setToolTip(tip);
        follow(field, name);
    };
    add(start_, "start date", "startDate", tr("First day of the period, local date in the time zone"));
    add(from_, "start time", "from", tr("Wall-clock time at which each day's window begins, hours:minutes"));
    for (const auto& [flag, step] : {std::pair{"--hours", 0.5}, std::pair{"--step", 1.0}})
        qobject_cast<QDoubleSpinBox*>(rows_.widget(flag))->setSingleStep(step);
    connect(&rows_, &FieldRows::edited, this, &PeriodForm::edited);
    add(zone_, "time zone", "zone",
        tr("IANA time zone of the wall clock, daylight saving included.\nSet to that of the nearest city "
           "when a file is opened: check it near borders."));
    add(window_, "solar window", "solarWindow", tr("Use sunrise and sunset instead of clock times"));
    add(afterSunrise_, "after sunrise", "afterSunrise",
        tr("The window begins this many hours after sunrise"));
    add(beforeSunset_, "before sunset", "beforeSunset", tr("The window ends this many hours before sunset"));
    add(rule_, "sunrise rule", "sunriseRule",
        tr("Which moment counts as sunrise and sunset: the altitude of the sun's centre"));
    add(refraction_, "refraction", "refraction",
        tr("On: the air lifts the sun a little near the horizon (refraction).\nOff: the sun's geometric "
           "position, as some rules require"));
}

void PeriodForm::enableFields() {
    const bool solar = window_->isChecked();
    auto* form = static_cast<QFormLayout*>(layout());
    const auto setShown = [form](QWidget* field, bool shown) {
        field->setVisible(shown);
        form->labelForField(field)->setVisible(shown);
    };
    setShown(from_, !solar);
    setShown(rows_.widget("--hours"), !solar);
    setShown(afterSunrise_, solar);
    setShown(beforeSunset_, solar);
    rule_->setEnabled(solar);
}

Period PeriodForm::period() const {
    Period period;
    rows_.take(periodFields().of(period));
    period.start = civilOf(start_->date());
    period.from = std::chrono::minutes(from_->time().hour() * 60 + from_->time().minute());
    period.zone = zone_->currentText().trimmed().toStdString();
    period.refraction = refraction_->isChecked();
    if (window_->isChecked())
        period.window = SolarHours{minutesOf(afterSunrise_->value()), minutesOf(beforeSunset_->value()),
                                   SunriseRule(rule_->currentIndex())};
    return period;
}

void PeriodForm::show(const Period& period) {
    showing_ = true;
    start_->setDate(dateOf(period.start));
    rows_.show(periodFields().of(period));
    from_->setTime(
        QTime(0, 0).addSecs(int(std::chrono::seconds(period.from % std::chrono::days{1}).count())));
    zone_->setCurrentText(QString::fromStdString(period.zone));
    window_->setChecked(period.window.has_value());
    const SolarHours window = period.window.value_or(SolarHours{});
    afterSunrise_->setValue(hoursOf(window.afterSunrise));
    beforeSunset_->setValue(hoursOf(window.beforeSunset));
    rule_->setCurrentIndex(int(window.rule));
    refraction_->setChecked(period.refraction);
    showing_ = false;
    enableFields();
}

}  // namespace noonmark
