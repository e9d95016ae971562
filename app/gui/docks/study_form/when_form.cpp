#include "app/gui/docks/study_form/when_form.h"

#include <QComboBox>
#include <QDate>
#include <QHBoxLayout>
#include <QLocale>
#include <QMenu>
#include <QPushButton>
#include <QSignalBlocker>
#include <algorithm>

#include "app/gui/base/widgets/qt_dates.h"
#include "app/gui/docks/study_form/period_form.h"
#include "app/gui/docks/study_form/period_preset.h"
#include "app/gui/docks/study_form/rule_period.h"

namespace noonmark {

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
        Q_EMIT edited(applied(preset, period_->period(), today(), latitudeDeg_), tr("days"));
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
    QMenu* days = menu.addMenu(QString::fromStdString(rule.name));
    for (const auto& [text, period] : offers)
        connect(days->addAction(text), &QAction::triggered, this,
                [this, period = period] { Q_EMIT edited(period, tr("period")); });
}

}  // namespace noonmark
