#include "app/gui/docks/study_form/when_form.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDate>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QMenu>
#include <QObject>
#include <QPushButton>
#include <QSignalBlocker>
#include <algorithm>
#include <cmath>

#include "app/gui/base/widgets/buttons.h"
#include "app/gui/base/widgets/name_text.h"
#include "app/gui/base/widgets/number_text.h"

namespace noonmark {

PeriodForm::PeriodForm(QWidget* parent)
    : QWidget(parent), window_(new QCheckBox(tr("From sunrise to sunset"))) {
    placeFields();
    explainFields();
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

void PeriodForm::explainFields() {
    const auto explain = [this](std::string_view flag, const QString& tip) {
        rows_.widget(flag)->setToolTip(tip);
    };
    rows_.widget("--start")->setObjectName(QStringLiteral("startDate"));
    rows_.widget("--no-refraction")->setObjectName(QStringLiteral("refraction"));
    explain("--start", tr("First day of the period, local date in the time zone"));
    explain("--from", tr("Wall-clock time at which each day's hours begin, hours:minutes"));
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

namespace {

using std::chrono::sys_days;

int daysUntil(CivilDate first, CivilDate last) { return int((sys_days(last) - sys_days(first)).count()) + 1; }

Period withDays(Period period, CivilDate first, CivilDate last) {
    period.start = first;
    period.days = daysUntil(first, last);
    return period;
}

// Of a long time all its sun is asked for, not that of some hours of the clock.
Period withSeason(Period period, CivilDate first, CivilDate last) {
    if (!period.window) period.window = SolarHours{};
    return withDays(std::move(period), first, last);
}

}  // namespace

QString nameOf(PeriodPreset preset, double latitudeDeg) {
    switch (preset) {
        case PeriodPreset::today:
            return QObject::tr("Today");
        case PeriodPreset::march:
            return QObject::tr("21 March");
        case PeriodPreset::june:
            return QObject::tr("21 June");
        case PeriodPreset::december:
            return QObject::tr("21 December");
        case PeriodPreset::growingSeason:
            return latitudeDeg < 0 ? QObject::tr("Growing season (October to April)")
                                   : QObject::tr("Growing season (April to October)");
        case PeriodPreset::year:
            return QObject::tr("Whole year");
        case PeriodPreset::own:
            return QObject::tr("Own dates");
    }
    return {};
}

Period withPresetDays(PeriodPreset preset, Period period, CivilDate today, double latitudeDeg) {
    using namespace std::chrono;
    const auto year = period.start.year();
    const auto oneDay = [&](CivilDate date) { return withDays(period, date, date); };
    switch (preset) {
        case PeriodPreset::today:
            return oneDay(today);
        case PeriodPreset::march:
            return oneDay(year / March / 21);
        case PeriodPreset::june:
            return oneDay(year / June / 21);
        case PeriodPreset::december:
            return oneDay(year / December / 21);
        case PeriodPreset::growingSeason:
            if (latitudeDeg < 0)
                return withSeason(period, year / October / 1, (year + years(1)) / April / 30);
            return withSeason(period, year / April / 1, year / October / 31);
        case PeriodPreset::year:
            return withSeason(period, year / January / 1, year / December / 31);
        case PeriodPreset::own:
            break;
    }
    return period;
}

PeriodPreset presetOf(const Period& period, CivilDate today, double latitudeDeg) {
    return *std::ranges::find_if(allPeriodPresets, [&](PeriodPreset preset) {
        const Period there = withPresetDays(preset, period, today, latitudeDeg);
        return there.start == period.start && there.days == period.days;
    });
}

namespace {

using Kind = HoursBound::Kind;

bool isWhole(double minutes) { return minutes == std::floor(minutes); }

bool takesSteps(const Rule& rule) { return rule.sampling.roundTo == 0 && rule.window.minSunDeg == 0; }

std::optional<Period> withHours(const Rule& rule, const HoursOfDay& hours, Period period) {
    if (hours.from.size() != 1 || hours.to.size() != 1) return std::nullopt;
    const HoursBound from = hours.from.front(), to = hours.to.front();
    if (!isWhole(from.minutes) || !isWhole(to.minutes)) return std::nullopt;
    if (from.kind == Kind::clock && to.kind == Kind::clock) {
        if (rule.clock.settings.kind != ClockKind::civil) return std::nullopt;
        period.window.reset();
        period.from = std::chrono::minutes(int(from.minutes));
        period.hours = (to.minutes - from.minutes) / 60;
        return period.hours > 0 ? std::optional(period) : std::nullopt;
    }
    if (from.kind != Kind::sunrise || to.kind != Kind::sunset || from.minutes < 0 || to.minutes > 0)
        return std::nullopt;
    period.window = SolarHours{std::chrono::minutes(int(from.minutes)),
                               std::chrono::minutes(-int(to.minutes)), rule.window.sunrise};
    return period;
}

}  // namespace

std::optional<Period> periodOf(const Rule& rule, std::chrono::month_day day, const Period& period) {
    Period on = period;
    on.start = period.start.year() / day.month() / day.day();
    if (!takesSteps(rule) || !on.start.ok()) return std::nullopt;
    on.days = 1;
    on.stepMinutes = rule.sampling.stepMinutes;
    const auto own = rule.window.byDay.find(day);
    return withHours(rule, own == rule.window.byDay.end() ? rule.window.hours : own->second, on);
}

std::optional<Period> periodOf(const Rule& rule, const Period& period) {
    const RuleDays& days = rule.days;
    if (!days.fixed.empty() || days.everyDays != 1 || days.mirrored || !rule.window.byDay.empty() ||
        !takesSteps(rule))
        return std::nullopt;
    const auto year = period.start.year();
    const CivilDate first = year / days.first.month() / days.first.day();
    const auto lastYear = days.last < days.first ? year + std::chrono::years(1) : year;
    const CivilDate last = lastYear / days.last.month() / days.last.day();
    if (!first.ok() || !last.ok()) return std::nullopt;
    Period over = period;
    over.start = first;
    over.days = int((std::chrono::sys_days(last) - std::chrono::sys_days(first)).count()) + 1;
    over.stepMinutes = rule.sampling.stepMinutes;
    return withHours(rule, rule.window.hours, over);
}

namespace {

CivilDate today() { return civilOf(QDate::currentDate()); }

QString dayText(std::chrono::month_day day) {
    const QDate date(2024, int(unsigned(day.month())), int(unsigned(day.day())));
    return QLocale().toString(date, longDay());
}

}  // namespace

WhenForm::WhenForm(QWidget* parent)
    : QWidget(parent),
      presets_(new QComboBox),
      ofRule_(new QPushButton),
      rulesMenu_(new QMenu(this)),
      period_(new PeriodForm) {
    presets_->setObjectName(QStringLiteral("periodPreset"));
    presets_->setToolTip(tr("The days that are measured. The hours stay as they are"));
    presets_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    presets_->setMinimumContentsLength(12);
    ofRule_->setObjectName(QStringLiteral("rulePeriod"));
    ofRule_->setText(tr("Days of a rule"));
    ofRule_->setToolTip(tr("The day and the hours of a review board's rule"));
    ofRule_->setMenu(rulesMenu_);
    fillPresets();
    auto* row = new QHBoxLayout;
    row->addWidget(presets_, 1);
    row->addWidget(ofRule_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addLayout(row);
    column->addWidget(period_);
    ofRule_->hide();
    connect(rulesMenu_, &QMenu::aboutToShow, this, &WhenForm::fillRules);
    connect(presets_, &QComboBox::activated, this, [this](int chosen) {
        const auto preset = allPeriodPresets[std::size_t(chosen)];
        Q_EMIT edited(withPresetDays(preset, period_->period(), today(), latitudeDeg_), tr("days"));
    });
    connect(period_, &PeriodForm::edited, this,
            [this](const QString& field) { Q_EMIT edited(period_->period(), field); });
    showPreset();
}

void WhenForm::fillPresets() {
    const QSignalBlocker quiet(presets_);
    presets_->clear();
    for (const PeriodPreset preset : allPeriodPresets) presets_->addItem(nameOf(preset, latitudeDeg_));
}

void WhenForm::setLatitude(double latitudeDeg) {
    latitudeDeg_ = latitudeDeg;
    fillPresets();
    showPreset();
}

void WhenForm::show(const Period& period) {
    period_->show(period);
    showPreset();
}

void WhenForm::showPreset() {
    const QSignalBlocker quiet(presets_);
    const auto preset = presetOf(period_->period(), today(), latitudeDeg_);
    presets_->setCurrentIndex(int(std::ranges::find(allPeriodPresets, preset) - allPeriodPresets.begin()));
}

void WhenForm::setRules(const std::vector<Rule>& rules) {
    rules_ = rules;
    ofRule_->setVisible(!rules_.empty());
}

// Anew each time, since the days are those of the period's year.
void WhenForm::fillRules() {
    rulesMenu_->clear();
    for (const Rule& rule : rules_) addDays(*rulesMenu_, rule);
}

void WhenForm::addDays(QMenu& menu, const Rule& rule) {
    std::vector<std::pair<QString, Period>> offers;
    for (const RuleDay& day : rule.days.fixed)
        if (const auto period = periodOf(rule, day.day, period_->period()))
            offers.emplace_back(dayText(day.day), *period);
    if (const auto period = periodOf(rule, period_->period()))
        offers.emplace_back(tr("%1 to %2").arg(dayText(rule.days.first), dayText(rule.days.last)), *period);
    if (offers.empty()) return;
    QMenu* days = menu.addMenu(ruleName(rule.name));
    for (const auto& [text, period] : offers)
        connect(days->addAction(text), &QAction::triggered, this,
                [this, period = period] { Q_EMIT edited(period, tr("period")); });
}

}  // namespace noonmark
