#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QSignalBlocker>
#include <QTreeView>
#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "app/gui/base/widgets/error_text.h"
#include "app/gui/base/widgets/number_text.h"
#include "app/gui/docks/places/places_dock.h"
#include "app/gui/session/study/region_text.h"
#include "core/describe/field_json.h"
#include "core/describe/field_values.h"
#include "core/describe/shown_as.h"
#include "core/engines/api/tree_shade.h"
#include "core/receivers/place_names.h"
#include "core/study/by_place/sun_by_place.h"

// Which places the table lists, in which order, how many of them are counted, and how that is saved.
namespace noonmark {

namespace {

QString longNameOf(const CivilDate& date) { return QLocale().toString(dateOf(date), longDate()); }

constexpr int fittedRows = 200;  // that columns are made wide enough for
constexpr int nameLetters = 14;  // of a name at least: the number beside it is seen whole

// From them the shares for another threshold follow. A saved answer holds none, nor how many there were.
bool knowsCells(const SunByPlace& sun) {
    return std::ranges::any_of(sun.sun, [](const SunOfPlace& of) { return !of.ofCells.empty(); });
}

// Also before the table is shown: a view measures only the rows that it shows.
int widthOfNames(const QTreeView& table, const QModelIndex& parent = {}) {
    constexpr int iconAndMargins = 30;
    const QAbstractItemModel& model = *table.model();
    int widest = 0;
    for (int row = 0; row < model.rowCount(parent); ++row) {
        const QModelIndex name = model.index(row, 0, parent);
        const int own = table.fontMetrics().horizontalAdvance(name.data().toString()) + iconAndMargins;
        widest = std::max({widest, own, widthOfNames(table, name)});
    }
    return widest + table.indentation();
}

constexpr const char *wholePeriod = "period", *changeOfSun = "change";

/// What the table lists, and in which order, as projects hold it.
struct PlaceListing {
    std::string of = wholePeriod;  ///< or changeOfSun, or one of the dates
    std::string kind;              ///< nameOf(PlaceKind); empty: all
    bool onlyBelow = false;
    bool byKind = false;
    int sortedBy = -1;  ///< column; -1: in the order of the project
    bool isDescending = false;
    std::optional<double> thresholdHours;
    double shadeHours = 0;
};

const Fields<PlaceListing>& listingFields() {
    static const Fields<PlaceListing> fields{
        field(&PlaceListing::of, {.key = "of"}),
        field(&PlaceListing::kind, {.key = "kind"}),
        field(&PlaceListing::onlyBelow, {.key = "only_below"}),
        field(&PlaceListing::byKind, {.key = "by_kind"}),
        field(&PlaceListing::sortedBy, {.key = "sorted_by"}),
        field(&PlaceListing::isDescending, {.key = "descending"}),
        field(&PlaceListing::thresholdHours,
              {.key = "threshold_h", .range = ValueRange{0, PlacesDock::maxThreshold}}),
        field(&PlaceListing::shadeHours, {.key = "shade_h", .range = ValueRange{0, PlacesDock::maxShade}})};
    return fields;
}

}  // namespace

void PlacesDock::fillLists() {
    const QSignalBlocker quietShown(shown_);
    shown_->clear();
    kinds_->clear();
    kinds_->addItem(tr("All kinds"));
    const auto& sun = model_->sun();
    if (!sun) return;
    shown_->addItem(tr("Whole period"));
    for (const CivilDate& date : sun->baseline.settings.dates) shown_->addItem(longNameOf(date));
    if (!sun->compared.empty()) shown_->addItem(tr("Change"));
    std::set<PlaceKind> kinds;
    for (const Place& place : sun->baseline.places) kinds.insert(place.kind);
    for (const PlaceKind kind : kinds) kinds_->addItem(describeKinds(kind), int(kind));
    showThreshold();
    fitColumns();
    showWordsLast();
    nextToNames_ = model_->columnOf({});
    applyRestored();
    showNextToNames();
    limitRows();
    emitDate();
    if (grouped_->isChecked()) table_->expandToDepth(0);
}

std::string PlacesDock::choice() const {
    const bool isForNext = !model_->sun() && !restored_.empty();  // an answer that is not there yet
    return isForNext ? restored_ : describeListing(threshold_->value());
}

// Another answer has a threshold of its own.
std::string PlacesDock::describeListing(std::optional<double> thresholdHours) const {
    const ShownSun what = shown();
    PlaceListing listing{.onlyBelow = onlyBelow_->isChecked(),
                         .byKind = grouped_->isChecked(),
                         .sortedBy = filter_->sortColumn(),
                         .isDescending = filter_->sortOrder() == Qt::DescendingOrder,
                         .thresholdHours = thresholdHours,
                         .shadeHours = shade_->value()};
    if (what.what == ShownSun::What::date)
        listing.of = formatText(model_->sun()->baseline.settings.dates[what.date]);
    if (what.what == ShownSun::What::change) listing.of = changeOfSun;
    if (const auto kind = filter_->kind()) listing.kind = nameOf(*kind);
    return fieldsJson(listingFields().of(listing)).dump();
}

// Another project lists all places until its answer is there.
void PlacesDock::restore(const std::string& choice) {
    restored_ = choice;
    for (QCheckBox* box : {onlyBelow_, grouped_}) box->setChecked(false);
    shade_->setValue(0);
}

void PlacesDock::applyRestored() {
    const auto json = nlohmann::ordered_json::parse(std::exchange(restored_, {}), nullptr, false);
    PlaceListing listing;
    if (!json.is_object() || !readFieldsJson(listingFields().of(listing), json) ||
        !checkRanges(listingFields().of(listing)))
        return;
    // Cells decide the shares of a new answer; of a saved one the colours follow the threshold alone.
    if (listing.thresholdHours && !knowsCells(model_->sun()->baseline)) follow(*listing.thresholdHours);
    const auto& sun = *model_->sun();
    const auto& dates = sun.baseline.settings.dates;
    for (std::size_t date = 0; date < dates.size(); ++date)
        if (listing.of == formatText(dates[date])) shown_->setCurrentIndex(int(date) + 1);
    if (listing.of == changeOfSun && !sun.compared.empty()) shown_->setCurrentIndex(shown_->count() - 1);
    if (const auto kind = parsePlaceKind(listing.kind))
        kinds_->setCurrentIndex(std::max(0, kinds_->findData(int(*kind))));
    onlyBelow_->setChecked(listing.onlyBelow);
    shade_->setValue(listing.shadeHours);
    grouped_->setChecked(listing.byKind);
    if (listing.sortedBy < filter_->columnCount())
        table_->sortByColumn(std::max(-1, listing.sortedBy),
                             listing.isDescending ? Qt::DescendingOrder : Qt::AscendingOrder);
}

void PlacesDock::fitColumns() {
    table_->header()->setResizeContentsPrecision(fittedRows);
    for (int column = 0; column < filter_->columnCount(); ++column) table_->resizeColumnToContents(column);
    namesPx_ = widthOfNames(*table_);
    fitNames();
}

// Names take what the first number leaves of the table's width, but some letters at least.
void PlacesDock::fitNames() {
    const QHeaderView& header = *table_->header();
    const int number = header.count() > 1 ? header.sectionSize(header.logicalIndex(1)) : 0;
    const int minimum = std::min(namesPx_, nameLetters * fontMetrics().averageCharWidth());
    table_->setColumnWidth(0, std::clamp(table_->viewport()->width() - number, minimum, namesPx_));
}

bool PlacesDock::eventFilter(QObject* watched, QEvent* event) {
    if (watched == table_->viewport() && event->type() == QEvent::Resize && namesPx_ > 0) fitNames();
    return QWidget::eventFilter(watched, event);
}

// Name and sun are read first.
void PlacesDock::showWordsLast() {
    QHeaderView& header = *table_->header();
    for (const int column : {PlaceSunModel::kind, PlaceSunModel::remarks})
        header.moveSection(header.visualIndex(column), header.count() - 1);
}

// What colours the view is the first number of a row; a list in its order stays in the order of that number.
void PlacesDock::showNextToNames() {
    if (!model_->sun()) return;
    QHeaderView& header = *table_->header();
    const int column = model_->columnOf(shown());
    header.moveSection(header.visualIndex(column), 1);
    fitNames();
    if (filter_->sortColumn() == nextToNames_) table_->sortByColumn(column, filter_->sortOrder());
    nextToNames_ = column;
}

void PlacesDock::limitRows() {
    const bool on = onlyBelow_->isChecked() && model_->sun();
    filter_->setLimit(on ? std::optional(limitOf(shown())) : std::nullopt);
    listed();
}

// A change has its own threshold.
bool PlacesDock::offersShade(const ShownSun& shown) const {
    return shown.what != ShownSun::What::change && !model_->showsSun(shown);
}

bool PlacesDock::asksForShade(const ShownSun& shown) const {
    return offersShade(shown) && shade_->value() > 0;
}

// Of which a place is counted. Less shade is more sun.
PlaceSunFilter::Limit PlacesDock::limitOf(const ShownSun& shown) const {
    constexpr double aMinute = 1 / minutesPerHour;
    if (shown.what == ShownSun::What::change) return {shown, -aMinute};
    if (!asksForShade(shown)) return {shown, threshold_->value()};
    const double possibleHours = model_->shownOf(0, shown) / minutesPerHour;
    return {shown, possibleHours - shade_->value(), true};
}

// `counts`: "61 of 532 places".
QString PlacesDock::describeLimit(const QString& counts, const ShownSun& shown) const {
    const bool isSun = model_->showsSun(shown);
    if (shown.what == ShownSun::What::change)
        return (isSun ? tr("%1 lose more than a minute of sun a day")
                      : tr("%1 get more than a minute of shadow a day more"))
            .arg(counts);
    if (asksForShade(shown) && shown.what == ShownSun::What::period)
        return tr("%1 have less than %2 h of shade a day").arg(counts, groupDigits(shade_->value(), 1));
    if (asksForShade(shown))
        return tr("%1 have less than %2 h of shade on %3")
            .arg(counts, groupDigits(shade_->value(), 1),
                 longNameOf(model_->sun()->baseline.settings.dates[shown.date]));
    const double hours = threshold_->value();
    const QString limit = isSun ? groupDigits(hours, 1) : groupDigits(model_->shownOf(hours, shown));
    if (shown.what == ShownSun::What::period)
        return (isSun ? tr("%1 have less than %2 h of sun a day")
                      : tr("%1 have more than %2 min of shadow a day"))
            .arg(counts, limit);
    return (isSun ? tr("%1 have less than %2 h of sun on %3")
                  : tr("%1 have more than %2 min of shadow on %3"))
        .arg(counts, limit, longNameOf(model_->sun()->baseline.settings.dates[shown.date]));
}

void PlacesDock::describeCount() {
    const auto& sun = model_->sun();
    onlyBelow_->setVisible(sun != nullptr);
    if (!sun) return count_->setText(tr("No places measured: choose \"Sun by place\" in the panel Study"));
    const ShownSun what = shown();
    const PlaceSunFilter::Limit limit = limitOf(what);
    std::size_t below = 0, measured = 0;
    for (std::size_t i = 0; i < sun->baseline.places.size(); ++i) {
        const double hours = model_->hoursOf(i, what);
        if (std::isnan(hours) || !isCounted(i)) continue;
        ++measured;
        if (limit.holds(hours)) ++below;
    }
    QString counts =
        tr("%1 of %2 place(s)", "", pluralNumber(measured)).arg(formatCount(below), formatCount(measured));
    if (const auto kind = filter_->kind())
        counts = tr("%1: %2 of %3").arg(describeKinds(*kind), formatCount(below), formatCount(measured));
    QString counted = describeLimit(counts, what);
    if (model_->showsSunOnly(what)) counted = tr("%1. A saved answer states its dates as sun").arg(counted);
    if (trees_->count() > 1)
        counted =
            tr("%1, %2").arg(counted, translated(describeTrees(TreeColumns(trees_->currentData().toInt()))));
    const double enough = sun->baseline.settings.enoughHours;
    const bool isOfAnother =
        what.what != ShownSun::What::change && !knowsCells(sun->baseline) && threshold_->value() != enough;
    count_->setText(isOfAnother ? tr("%1. Headline and shares of the area are for %2 h, as they were saved")
                                      .arg(counted, groupDigits(enough, 1))
                                : counted);
}

bool PlacesDock::isCounted(std::size_t place) const {
    const auto kind = filter_->kind();
    return !kind || model_->sun()->baseline.places[place].kind == *kind;
}

void PlacesDock::listed() {
    const std::size_t all = model_->sun() ? model_->sun()->baseline.places.size() : 0;
    std::size_t shown = 0, withoutFigures = 0;
    for (std::size_t i = 0; i < all; ++i) {
        if (!filter_->accepts(i)) continue;
        ++shown;
        if (std::isnan(model_->hoursOf(i, {}))) ++withoutFigures;
    }
    const QString places =
        shown == all
            ? tr("%1 place(s)", "", pluralNumber(all)).arg(formatCount(all))
            : tr("%1 of %2 place(s) listed", "", pluralNumber(all)).arg(formatCount(shown), formatCount(all));
    listed_->setVisible(all > 0);
    listed_->setText(
        withoutFigures == 0 ? places : tr("%1, %2 without figures").arg(places, formatCount(withoutFigures)));
}

void PlacesDock::select(std::size_t place) {
    const QModelIndex source = model_->indexOf(place);
    if (!source.isValid()) return;
    if (!filter_->mapFromSource(source).isValid()) {
        text_->clear();
        kinds_->setCurrentIndex(0);
        onlyBelow_->setChecked(false);
    }
    const QModelIndex row = filter_->mapFromSource(source);
    table_->setCurrentIndex(row);
    table_->scrollTo(row);
}

PlaceSunFilter::PlaceSunFilter(QObject* parent) : QSortFilterProxyModel(parent) {
    setRecursiveFilteringEnabled(true);
}

const PlaceSunModel& PlaceSunFilter::model() const {
    return *static_cast<const PlaceSunModel*>(sourceModel());
}

void PlaceSunFilter::setText(const QString& text) {
    text_ = text;
    invalidateFilter();
}

void PlaceSunFilter::setKind(std::optional<PlaceKind> kind) {
    kind_ = kind;
    invalidateFilter();
}

void PlaceSunFilter::setLimit(std::optional<Limit> limit) {
    if (limit == limit_) return;
    limit_ = limit;
    invalidateFilter();
}

// A place without figures has not less.
bool PlaceSunFilter::accepts(std::size_t place) const {
    const Place& of = model().sun()->baseline.places[place];
    if (kind_ && of.kind != *kind_) return false;
    if (limit_ && !limit_->holds(model().hoursOf(place, limit_->of))) return false;
    return text_.isEmpty() || placeName(of.name).contains(text_, Qt::CaseInsensitive);
}

// Without a QVariant for each value: thousands of rows are sorted at a click. Rows without a number come last
// in both orders.
bool PlaceSunFilter::lessThan(const QModelIndex& left, const QModelIndex& right) const {
    if (left.column() < PlaceSunModel::firstFigure)
        return QString::localeAwareCompare(left.data().toString(), right.data().toString()) < 0;
    const double a = model().valueAt(left), b = model().valueAt(right);
    if (std::isnan(a) || std::isnan(b))
        return std::isnan(a) != std::isnan(b) && std::isnan(a) == (sortOrder() == Qt::DescendingOrder);
    return a < b;
}

bool PlaceSunFilter::filterAcceptsRow(int row, const QModelIndex& parent) const {
    const auto place = model().placeOf(model().index(row, 0, parent));
    return place && accepts(*place);  // a row above places stays for those below it
}

}  // namespace noonmark
