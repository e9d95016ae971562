#include "app/gui/docks/study_form/places_form.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QRegularExpression>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <array>

#include "app/gui/base/looks/theme.h"
#include "app/gui/base/widgets/buttons.h"
#include "app/gui/base/widgets/error_text.h"
#include "app/gui/base/widgets/number_fields.h"
#include "app/gui/base/widgets/number_text.h"
#include "app/gui/session/study/region_text.h"
#include "core/describe/field_json.h"
#include "core/describe/field_values.h"
#include "core/receivers/place_names.h"

namespace noonmark {

namespace {

constexpr int kindRole = Qt::UserRole;
constexpr int ownRegions = -1;    // in place of a kind
constexpr int textMarginPx = 16;  // of a line of text

// The shortest day, an equinox and the longest day, as planners state them.
QString defaultDates(std::chrono::year year) {
    using namespace std::chrono;
    QStringList texts;
    for (const CivilDate date : {year / December / 21, year / March / 21, year / June / 21})
        texts << QString::fromStdString(formatText(date));
    return texts.join(QStringLiteral(", "));
}

}  // namespace

PlacesForm::PlacesForm(QWidget* parent)
    : QWidget(parent),
      kinds_(new QListWidget),
      none_(new QLabel(tr("The project has no places. Read some (Study > Read places...) or draw one."))),
      streets_(pushButton(
          tr("Read streets"), "readStreets",
          tr("Adds the streets of the city's OpenStreetMap file, cut at their junctions, carriageway and "
             "sidewalks apart"))),
      enough_(numberField(0, SunByPlaceSettings::maxHours, 1, 0.5, tr(" h"))),
      dates_(new QLineEdit(defaultDates(year_))),
      all_(new QCheckBox(tr("All scenarios"))),
      refusal_(new QLabel) {
    kinds_->setObjectName(QStringLiteral("placeKinds"));
    kinds_->setToolTip(tr("Places of the ticked kinds are measured, all in one run"));
    kinds_->setUniformItemSizes(true);
    none_->setWordWrap(true);
    enough_->setObjectName(QStringLiteral("enoughHours"));
    enough_->setToolTip(tr("The share of each place with so many hours of sun a day is stated"));
    enough_->setValue(SunByPlaceSettings().enoughHours);
    dates_->setObjectName(QStringLiteral("placeDates"));
    dates_->setCursorPosition(0);
    dates_->setMinimumWidth(dates_->fontMetrics().horizontalAdvance(defaultDates(year_)) + textMarginPx);
    dates_->setToolTip(
        tr("Days on which the hours of sun of each place are stated, too, with commas between"));
    all_->setObjectName(QStringLiteral("placesAllScenarios"));
    all_->setToolTip(
        tr("Measures the places in all scenarios and compares each with the baseline, which is "
           "chosen at the top"));
    refusal_->setWordWrap(true);
    showAsError(*refusal_);
    auto* form = new QFormLayout;
    form->setContentsMargins(0, 0, 0, 0);
    form->setRowWrapPolicy(QFormLayout::WrapLongRows);
    form->addRow(tr("Enough sun"), enough_);
    form->addRow(tr("Dates"), dates_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    for (QWidget* widget :
         {static_cast<QWidget*>(kinds_), static_cast<QWidget*>(none_), static_cast<QWidget*>(streets_)})
        column->addWidget(widget);
    column->addLayout(form);
    column->addWidget(all_);
    column->addWidget(refusal_);
    connect(streets_, &QPushButton::clicked, this, &PlacesForm::streetsRequested);
    connect(kinds_, &QListWidget::itemChanged, this, &PlacesForm::follow);
    connect(enough_, &QDoubleSpinBox::valueChanged, this, &PlacesForm::edited);
    connect(dates_, &QLineEdit::textChanged, this, &PlacesForm::follow);
    connect(all_, &QCheckBox::toggled, this, &PlacesForm::edited);
    fill();
    follow();
    enable();
}

void PlacesForm::setComparing(bool comparing) {
    comparing_ = comparing;
    enable();
}

void PlacesForm::setEnough(double hours) { enough_->setValue(hours); }

void PlacesForm::setScenarioCount(std::size_t scenarios) {
    if (scenarios == scenarios_) return;
    scenarios_ = scenarios;
    enable();
    Q_EMIT edited();
}

// Two are compared without it.
void PlacesForm::enable() {
    all_->setVisible(scenarios_ > 2);
    all_->setEnabled(comparing_);
}

bool PlacesForm::allScenarios() const { return comparing_ && scenarios_ > 2 && all_->isChecked(); }

void PlacesForm::setPlaces(const std::vector<Place>& places, const std::vector<Region>& regions) {
    if (places == places_ && regions == regions_) return;
    places_ = places;
    regions_ = regions;
    fill();
    Q_EMIT edited();
}

void PlacesForm::setYear(std::chrono::year year) {
    if (year == year_) return;
    const bool untouched = dates_->text() == defaultDates(year_);
    year_ = year;
    if (untouched) dates_->setText(defaultDates(year));
    dates_->setCursorPosition(0);
}

// One line for each kind that there is, with the number of its places.
void PlacesForm::fill() {
    const QSignalBlocker quiet(kinds_);
    kinds_->clear();
    for (const PlaceKind kind : placeKinds) {
        const auto count = std::size_t(std::ranges::count(places_, kind, &Place::kind));
        if (count == 0) continue;
        addLine(QStringLiteral("%1 %2").arg(describeKinds(kind), formatCount(count)), int(kind),
                !unticked_.contains(kind));
    }
    if (!regions_.empty())
        addLine(tr("Own regions %1").arg(formatCount(regions_.size())), ownRegions, regionsTicked_);
    kinds_->setVisible(kinds_->count() > 0);
    none_->setVisible(kinds_->count() == 0);
    const bool hadFocus = streets_->hasFocus();
    streets_->setVisible(std::ranges::find(places_, PlaceKind::street, &Place::kind) == places_.end());
    if (hadFocus && streets_->isHidden()) kinds_->setFocus();  // the form stays where it is scrolled to
    kinds_->setFixedHeight(kinds_->sizeHintForRow(0) * std::max(1, kinds_->count()) +
                           2 * kinds_->frameWidth() + 2);
}

void PlacesForm::addLine(const QString& text, int kind, bool ticked) {
    auto* item = new QListWidgetItem(text, kinds_);
    item->setData(kindRole, kind);
    item->setFlags(item->flags() | Qt::ItemIsUserCheckable);
    item->setCheckState(ticked ? Qt::Checked : Qt::Unchecked);
}

void PlacesForm::follow() {
    for (int i = 0; i < kinds_->count(); ++i) {
        const int kind = kinds_->item(i)->data(kindRole).toInt();
        const bool ticked = kinds_->item(i)->checkState() == Qt::Checked;
        if (kind == ownRegions)
            regionsTicked_ = ticked;
        else if (ticked)
            unticked_.erase(PlaceKind(kind));
        else
            unticked_.insert(PlaceKind(kind));
    }
    const auto valid = settings();
    refusal_->setVisible(!valid);
    if (!valid) refusal_->setText(describeError(valid.error()));
    Q_EMIT edited();
}

std::vector<Place> PlacesForm::chosen() const {
    std::vector<Place> chosen;
    std::ranges::copy_if(places_, std::back_inserter(chosen),
                         [this](const Place& place) { return !unticked_.contains(place.kind); });
    if (!regionsTicked_) return chosen;
    for (const Region& region : regions_) chosen.push_back(makePlace(region));
    makeNamesUnique(chosen);
    return chosen;
}

namespace {

/// What is ticked and typed, as projects hold it.
struct PlacesChoice {
    std::vector<std::string> unticked;  ///< nameOf(PlaceKind)
    bool ownRegions = false;
    bool allScenarios = false;
    double enoughHours = SunByPlaceSettings().enoughHours;
    std::string dates;  ///< as typed
};

const Fields<PlacesChoice>& placesChoiceFields() {
    static const Fields<PlacesChoice> fields{
        field(&PlacesChoice::unticked, {.key = "unticked"}),
        field(&PlacesChoice::ownRegions, {.key = "own_regions"}),
        field(&PlacesChoice::allScenarios, {.key = "all_scenarios"}),
        field(&PlacesChoice::enoughHours, fieldWithKey(sunByPlaceFields().rows(), "enough_hours")),
        field(&PlacesChoice::dates, {.key = "dates"})};
    return fields;
}

}  // namespace

std::string PlacesForm::choice() const {
    PlacesChoice asked{.ownRegions = regionsTicked_,
                       .allScenarios = all_->isChecked(),
                       .enoughHours = enough_->value(),
                       .dates = dates_->text().toStdString()};
    for (const PlaceKind kind : unticked_) asked.unticked.emplace_back(nameOf(kind));
    return fieldsJson(placesChoiceFields().of(asked)).dump();
}

void PlacesForm::restore(const std::string& choice) {
    const PlacesChoice atFirst{.dates = defaultDates(year_).toStdString()};
    PlacesChoice asked = atFirst;
    for (const PlaceKind kind : untickedAtFirst) asked.unticked.emplace_back(nameOf(kind));
    const auto json = nlohmann::ordered_json::parse(choice, nullptr, false);
    if (PlacesChoice read = atFirst; json.is_object() &&
                                     readFieldsJson(placesChoiceFields().of(read), json) &&
                                     checkRanges(placesChoiceFields().of(read)))
        asked = std::move(read);
    unticked_.clear();
    for (const std::string& name : asked.unticked)
        if (const auto kind = parsePlaceKind(name)) unticked_.insert(*kind);
    regionsTicked_ = asked.ownRegions;
    all_->setChecked(asked.allScenarios);
    enough_->setValue(asked.enoughHours);
    dates_->setText(QString::fromStdString(asked.dates));
    dates_->setCursorPosition(0);
    fill();
    Q_EMIT edited();
}

Result<SunByPlaceSettings> PlacesForm::settings() const {
    SunByPlaceSettings settings;
    settings.enoughHours = enough_->value();
    static const QRegularExpression between(QStringLiteral("[,;\\s]+"));
    for (const QString& text : dates_->text().split(between, Qt::SkipEmptyParts)) {
        const auto date = parseDate(text.toStdString());
        if (!date) return tl::make_unexpected(date.error());
        settings.dates.push_back(*date);
    }
    return settings;
}

}  // namespace noonmark
