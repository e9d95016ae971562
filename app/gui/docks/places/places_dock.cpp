#include "app/gui/docks/places/places_dock.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QTimer>
#include <QTreeView>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "app/gui/base/layers/field_picture.h"
#include "app/gui/base/widgets/buttons.h"
#include "app/gui/base/widgets/error_text.h"
#include "app/gui/base/widgets/number_fields.h"
#include "app/gui/base/widgets/number_text.h"
#include "app/gui/session/answers/result_rows.h"
#include "app/gui/session/study/region_text.h"
#include "app/report/maps/style.h"
#include "core/describe/field_json.h"
#include "core/describe/field_values.h"
#include "core/describe/shown_as.h"
#include "core/describe/text.h"
#include "core/engines/api/tree_shade.h"
#include "core/measures/shadow_figures.h"
#include "core/study/by_place/sun_by_place.h"

namespace noonmark {

namespace {

constexpr double maxThreshold = 12;  // hours
constexpr int ticksOfHour = 10;
constexpr double maxShade = 24;
constexpr int thresholdRestMs = 250;

constexpr int fittedRows = 200;  // that columns are made wide enough for
constexpr int nameLetters = 14;  // of a name at least: the number beside it is seen whole

// From them the shares for another threshold follow. A saved answer holds none, nor how many there were.
bool knowsCells(const SunByPlace& sun) {
    return std::ranges::any_of(sun.sun, [](const SunOfPlace& of) { return !of.ofCells.empty(); });
}

QString longNameOf(const CivilDate& date) { return QLocale().toString(dateOf(date), longDate()); }

QComboBox* listField(const char* name, const QString& tip) {
    auto* list = new QComboBox;
    list->setObjectName(QString::fromLatin1(name));
    list->setToolTip(tip);
    list->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    list->setMinimumContentsLength(8);
    return list;
}

// Each with its stretch.
QHBoxLayout* lowRow(std::initializer_list<std::pair<QWidget*, int>> widgets) {
    auto* row = new QHBoxLayout;
    for (const auto& [widget, stretch] : widgets) row->addWidget(widget, stretch);
    return row;
}

// Grey without a cell.
QColor colourOf(const ColourScale& scale, double hours) {
    constexpr QColor withoutCell{0xa8, 0xa8, 0xa8};
    if (std::isnan(hours)) return withoutCell;
    const bool ofChange = scale.of == ColourScale::Of::change;
    return toColour(scale.colourOf(ofChange ? hours * minutesPerHour : hours));
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

}  // namespace

PlacesDock::PlacesDock(QWidget* parent)
    : QWidget(parent),
      aside_(new QLabel),
      return_(pushButton(tr("Show it"), "placesReturn",
                         tr("Shows this answer in the view and in the results again"))),
      model_(new PlaceSunModel(this)),
      filter_(new PlaceSunFilter(this)),
      count_(new QLabel),
      shown_(listField("placesShown", tr("What colours the places: the whole period, one of the dates, or "
                                         "the change against the baseline"))),
      trees_(listField("placesTrees", tr("Which trees count in the table, the map and the headline"))),
      slider_(new QSlider(Qt::Horizontal)),
      threshold_(numberField(0, maxThreshold, 1, 0.5, tr(" h"))),
      shade_(numberField(0, maxShade, 1, 0.5, tr(" h of shade"))),
      text_(new QLineEdit),
      kinds_(listField("placesKind", tr("Lists only places of this kind"))),
      grouped_(new QCheckBox(tr("By kind"))),
      onlyBelow_(new QCheckBox(tr("Only these"))),
      table_(new QTreeView),
      listed_(new QLabel),
      contributors_(pushButton(tr("Who shades it"), "placeContributors",
                               tr("Shows which buildings take sun from the chosen place, and how much. Or "
                                  "double-click its row"))),
      rest_(new QTimer(this)) {
    filter_->setSourceModel(model_);
    makeTable();
    placeFields();
    connectFields();
    connectTable();
    describeCount();
}

void PlacesDock::placeFields() {
    count_->setObjectName(QStringLiteral("placesBelow"));
    count_->setWordWrap(true);
    QFont bold = count_->font();
    bold.setBold(true);
    count_->setFont(bold);
    onlyBelow_->setObjectName(QStringLiteral("placesOnlyBelow"));
    onlyBelow_->setToolTip(tr("Lists only the places that this sentence counts"));
    listed_->setObjectName(QStringLiteral("placesListed"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(4, 4, 4, 4);
    column->addWidget(makeAside());
    column->addLayout(lowRow({{count_, 1}, {onlyBelow_, 0}}));
    column->addLayout(lowRow({{shown_, 1}, {makeThreshold(), 1}}));
    column->addWidget(trees_);
    trees_->hide();
    column->addWidget(makeFilters());
    column->addWidget(table_, 1);
    column->addLayout(lowRow({{listed_, 1}, {contributors_, 0}}));
    contributors_->setEnabled(false);
}

QWidget* PlacesDock::makeAside() {
    aside_->setObjectName(QStringLiteral("placesAside"));
    aside_->setWordWrap(true);
    connect(return_, &QPushButton::clicked, this, &PlacesDock::returnRequested);
    auto* row = new QWidget;
    auto* line = new QHBoxLayout(row);
    line->setContentsMargins(0, 0, 0, 0);
    line->addWidget(aside_, 1);
    line->addWidget(return_);
    row->hide();
    return row;
}

void PlacesDock::setAside(const QString& name) {
    aside_->setText(name.isEmpty() ? QString() : tr("The view shows another result than %1").arg(name));
    aside_->parentWidget()->setHidden(name.isEmpty());
    enableThreshold();
}

QWidget* PlacesDock::makeThreshold() {
    threshold_->setObjectName(QStringLiteral("placesThreshold"));
    slider_->setObjectName(QStringLiteral("placesSlider"));
    slider_->setRange(0, int(maxThreshold * ticksOfHour));
    slider_->setPageStep(ticksOfHour);
    const QString tip =
        tr("Places with less sun a day than this are violet, others orange, unless the legend has other "
           "colours");
    slider_->setToolTip(tip);
    threshold_->setToolTip(tip);
    shade_->setObjectName(QStringLiteral("placesShade"));
    shade_->setPrefix(tr("< "));
    shade_->setSpecialValueText(tr("any shade"));
    shade_->setToolTip(
        tr("Counts and lists the places with less shade than this, instead of those with too "
           "little sun"));
    shade_->hide();
    auto* row = new QWidget;
    auto* line = new QHBoxLayout(row);
    line->setContentsMargins(0, 0, 0, 0);
    line->addWidget(slider_, 1);
    line->addWidget(threshold_);
    line->addWidget(shade_);
    return row;
}

QWidget* PlacesDock::makeFilters() {
    text_->setObjectName(QStringLiteral("placesFilter"));
    text_->setPlaceholderText(tr("Part of a name"));
    text_->setToolTip(tr("Lists only the places whose name contains this text"));
    text_->setClearButtonEnabled(true);
    grouped_->setObjectName(QStringLiteral("placesGrouped"));
    grouped_->setToolTip(tr("Places stand below a row of their kind with its means"));
    auto* row = new QWidget;
    auto* line = new QHBoxLayout(row);
    line->setContentsMargins(0, 0, 0, 0);
    line->addWidget(text_, 1);
    line->addWidget(kinds_, 1);
    line->addWidget(grouped_);
    return row;
}

void PlacesDock::makeTable() {
    table_->setObjectName(QStringLiteral("placesTable"));
    table_->setModel(filter_);
    table_->setSortingEnabled(true);
    table_->sortByColumn(-1, Qt::AscendingOrder);
    table_->setUniformRowHeights(true);
    table_->setTextElideMode(Qt::ElideMiddle);  // parts of one street differ at the end of their names
    table_->setAllColumnsShowFocus(true);
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->header()->setStretchLastSection(false);
    table_->viewport()->installEventFilter(this);
    table_->setToolTip(
        tr("Click a row to see its place in the view; a click on a place in the view selects "
           "its row"));
}

void PlacesDock::connectFields() {
    connect(shown_, &QComboBox::currentIndexChanged, this, [this] {
        showNextToNames();
        shade_->setVisible(offersShade(shown()));
        colour();
        limitRows();
        emitDate();
    });
    connect(trees_, &QComboBox::currentIndexChanged, this, &PlacesDock::chooseTrees);
    connect(onlyBelow_, &QCheckBox::toggled, this, &PlacesDock::limitRows);
    connect(slider_, &QSlider::valueChanged, this, [this](int tick) { follow(double(tick) / ticksOfHour); });
    connect(threshold_, &QDoubleSpinBox::valueChanged, this, &PlacesDock::follow);
    connect(shade_, &QDoubleSpinBox::valueChanged, this, [this] {
        describeCount();
        limitRows();
    });
    rest_->setSingleShot(true);
    rest_->setInterval(thresholdRestMs);
    connect(rest_, &QTimer::timeout, this, [this] { Q_EMIT thresholdChosen(threshold_->value()); });
    connect(text_, &QLineEdit::textChanged, this, [this](const QString& text) {
        filter_->setText(text);
        listed();
    });
    connect(kinds_, &QComboBox::currentIndexChanged, this, [this] {
        const QVariant kind = kinds_->currentData();
        filter_->setKind(kind.isValid() ? std::optional(PlaceKind(kind.toInt())) : std::nullopt);
        listed();
        describeCount();
    });
    connect(grouped_, &QCheckBox::toggled, this, [this](bool on) {
        model_->setGrouped(on);
        if (on) table_->expandToDepth(0);
    });
}

void PlacesDock::connectTable() {
    const auto placeOf = [this](const QModelIndex& index) {
        return model_->placeOf(filter_->mapToSource(index.siblingAtColumn(0)));
    };
    connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this, placeOf](const QModelIndex& index) {
                if (const auto place = placeOf(index)) Q_EMIT highlighted(*place);
            });
    connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this, placeOf](const QModelIndex& index) { contributors_->setEnabled(hasSun(placeOf(index))); });
    const auto askFor = [this, placeOf](const QModelIndex& index) {
        if (const auto place = placeOf(index); hasSun(place)) Q_EMIT contributorsRequested(*place);
    };
    connect(table_, &QTreeView::doubleClicked, this, askFor);
    connect(contributors_, &QPushButton::clicked, this, [this, askFor] { askFor(table_->currentIndex()); });
    for (auto signal : {&QTreeView::clicked, &QTreeView::activated})
        connect(table_, signal, this, [this, placeOf](const QModelIndex& index) {
            if (const auto place = placeOf(index)) Q_EMIT goToRequested(*place);
        });
}

bool PlacesDock::hasSun(std::optional<std::size_t> place) const {
    return place && model_->sun() && !std::isnan(model_->hoursOf(*place, {}));
}

void PlacesDock::show(std::shared_ptr<const SunOfCities> sun, const QString& note, bool outdated) {
    if (sun == answer_ && note == note_ && outdated == outdated_) return;
    note_ = note;
    outdated_ = outdated;
    if (sun != answer_) {
        answer_ = std::move(sun);
        fillTrees();
        take(inChosenColumn(), true);
    }
    colour();
    listed();
}

namespace {

bool changesAny(const std::vector<SunChange>& changes) {
    return std::ranges::any_of(changes,
                               [](const SunChange& one) { return one.maxLossMin > 0 || one.maxGainMin > 0; });
}

// Where a scenario changes trees alone, without them nothing has changed.
bool changesTreesAlone(const SunOfCities& sun) {
    return std::ranges::none_of(sun.compared, changesAny, &ComparedSun::changes) &&
           std::ranges::any_of(sun.compared, [](const ComparedSun& one) {
               return std::ranges::any_of(one.changesWithTrees, changesAny);
           });
}

// A saved answer has no cities.
bool changesTrees(const SunOfCities& sun) {
    return changesTreesAlone(sun) || std::ranges::any_of(sun.compared, [&](const ComparedSun& one) {
               return !one.changesWithTrees.empty() && one.sun.city.trees != sun.baseline.city.trees;
           });
}

}  // namespace

// The same choice as before, if the answer has that column. Where trees differ, that without them shows a
// part of what has changed, or nothing.
void PlacesDock::fillTrees() {
    const QSignalBlocker quiet(trees_);
    QVariant before = trees_->currentData();
    const bool isWithout = !before.isValid() || before.toInt() == int(TreeColumns::without);
    if (isWithout && answer_ && changesTrees(*answer_)) before = int(TreeColumns::seasonal);
    trees_->clear();
    if (answer_)
        for (const TreeColumns column : listSunColumns(*answer_))
            trees_->addItem(translatedSentence(describeTrees(column)), int(column));
    trees_->setCurrentIndex(std::max(0, trees_->findData(before)));
    trees_->setVisible(trees_->count() > 1);
}

std::shared_ptr<const SunOfCities> PlacesDock::inChosenColumn() const {
    if (!answer_) return nullptr;
    auto made = inColumn(*answer_, TreeColumns(trees_->currentData().toInt()));
    return made ? std::make_shared<const SunOfCities>(*std::move(made)) : answer_;
}

void PlacesDock::chooseTrees() {
    if (!answer_) return;
    take(inChosenColumn(), false);
    colour();
    listed();
}

// `mayRestate`: an answer of the same shadow keeps its rows.
void PlacesDock::take(std::shared_ptr<const SunOfCities> sun, bool mayRestate) {
    if (mayRestate && sun && model_->sun() && haveSameShadow(*sun, *model_->sun())) {
        model_->restate(std::move(sun));
        showThreshold();
        if (!restored_.empty()) applyRestored();
        return;
    }
    rest_->stop();
    if (model_->sun() && restored_.empty()) restored_ = describeListing({});
    picture_ = sun ? PlacePicture(sun->baseline.places) : PlacePicture();
    model_->show(std::move(sun));
    fillLists();
}

// The hours that are enough in the answer; while the threshold moves, the answer follows later.
void PlacesDock::showThreshold() {
    if (rest_->isActive()) return;
    const QSignalBlocker quietSlider(slider_), quietThreshold(threshold_);
    const double enough = std::min(maxThreshold, model_->sun()->baseline.settings.enoughHours);
    threshold_->setValue(enough);
    slider_->setValue(int(std::lround(enough * ticksOfHour)));
}

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

namespace {

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
        field(&PlaceListing::thresholdHours, {.key = "threshold_h", .range = ValueRange{0, maxThreshold}}),
        field(&PlaceListing::shadeHours, {.key = "shade_h", .range = ValueRange{0, maxShade}})};
    return fields;
}

}  // namespace

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

// Slider and field show the same hours.
void PlacesDock::follow(double hours) {
    const QSignalBlocker quietSlider(slider_), quietThreshold(threshold_);
    threshold_->setValue(hours);
    slider_->setValue(int(std::lround(hours * ticksOfHour)));
    model_->setEnough(hours);
    if (model_->followsEnough(filter_->sortColumn())) filter_->invalidate();
    colour();
    limitRows();
    rest_->start();
}

ShownSun PlacesDock::shown() const {
    const auto& sun = model_->sun();
    const int entry = shown_->currentIndex();
    if (!sun || entry <= 0) return {};
    const auto date = std::size_t(entry - 1);
    return date < sun->baseline.settings.dates.size() ? ShownSun{ShownSun::What::date, date}
                                                      : ShownSun{ShownSun::What::change, 0};
}

void PlacesDock::emitDate() {
    const ShownSun what = shown();
    Q_EMIT dateChosen(what.what == ShownSun::What::date ? std::optional(what.date) : std::nullopt);
}

void PlacesDock::setShown(ShownAs show) {
    const QModelIndex current = filter_->mapToSource(table_->currentIndex());
    const auto place = current.isValid() ? model_->placeOf(current.siblingAtColumn(0)) : std::nullopt;
    model_->setShown(show);
    if (!model_->sun()) return;
    model_->setEnough(threshold_->value());
    threshold_->setSuffix(show == ShownAs::sun ? tr(" h") : tr(" h of sun"));
    shade_->setVisible(offersShade(shown()));
    limitRows();
    fitColumns();
    if (grouped_->isChecked()) table_->expandToDepth(0);
    colour();
    if (place) select(*place);
}

void PlacesDock::setColours(const LegendChoice& choice) {
    if (choice == colours_) return;
    colours_ = choice;
    colour();
}

ColourScale PlacesDock::scaleOf(const ShownSun& shown) const {
    if (shown.what == ShownSun::What::change) return makePlaceChangeScale(colours_);
    std::vector<double> hours;
    for (std::size_t i = 0; i < model_->sun()->baseline.places.size(); ++i)
        hours.push_back(model_->hoursOf(i, shown));
    return makeThresholdScale(colours_, threshold_->value(), hours);
}

// Of what colours the places, so that nobody takes it for exact; empty: not measured.
QString PlacesDock::describeError(const ShownSun& shown) const {
    using What = ShownSun::What;
    const std::string_view quantity = shown.what == What::period ? "place_mean"
                                      : shown.what == What::date ? "place_date"
                                                                 : "place_change";
    const SunByPlace& sun = shownCity(*model_->sun());
    const std::string of =
        shown.what == What::date ? formatText(sun.settings.dates[shown.date]) : std::string();
    for (const ShownError& error : sun.errors)
        if (error.facts.key == quantity && error.of == of)
            return tr("Measured error against rays: %1").arg(sentenceText(describe(error)));
    return {};
}

void PlacesDock::colour() {
    view_.reset();
    if (const auto& sun = model_->sun()) {
        const ShownSun what = shown();
        std::vector<QColor> colours;
        const ColourScale scale = scaleOf(what);
        for (std::size_t i = 0; i < sun->baseline.places.size(); ++i)
            colours.push_back(colourOf(scale, model_->hoursOf(i, what)));
        model_->setColours(std::move(colours));
        view_ = std::make_shared<const PlaceView>(makeView(shownCity(*sun).name));
    }
    table_->viewport()->update();
    enableThreshold();
    describeCount();
    Q_EMIT viewChanged();
}

// The places of one of the cities that were measured.
PlaceView PlacesDock::makeView(const std::string& scenario) const {
    const auto& sun = model_->sun();
    const ShownSun what = shown();
    const ColourScale scale = scaleOf(what);
    std::vector<GroundPicture::Pixel> pixels;
    for (std::size_t i = 0; i < sun->baseline.places.size(); ++i)
        pixels.push_back(pixelOf(colourOf(scale, hoursOf(*sun, scenario, i, what))));
    return {picture_.coloured(pixels),
            legendOf(scaleAsShown(scale, what), what),
            note_.isEmpty() ? describeError(what) : note_,
            outdated_,
            threshold_->value(),
            model_->showsSun(what) ? ShownAs::sun : ShownAs::shadow,
            TreeColumns(trees_->currentData().toInt()),
            [this, what, scenario](glm::dvec2 point) { return describeAt(point, what, scenario); },
            [this, what](const std::string& other) -> std::shared_ptr<const PlaceView> {
                if (!model_->sun() || !isMeasured(*model_->sun(), other, what)) return nullptr;
                return std::make_shared<const PlaceView>(makeView(other));
            }};
}

void PlacesDock::enableThreshold() {
    const bool ofHours = shown().what != ShownSun::What::change;
    for (QWidget* field : {static_cast<QWidget*>(slider_), static_cast<QWidget*>(threshold_)})
        field->setEnabled(model_->sun() && ofHours && aside_->text().isEmpty());
}

// The same colours for the same places: less sun is more shadow.
ColourScale PlacesDock::scaleAsShown(ColourScale scale, const ShownSun& shown) const {
    if (model_->showsSun(shown)) return scale;
    const bool ofChange = shown.what == ShownSun::What::change;
    const auto asShown = [&](double one) {
        return ofChange ? -one : std::max(0.0, std::round(model_->shownOf(one, shown)));
    };
    std::swap(scale.low, scale.high);
    for (double* end : {&scale.low, &scale.high}) *end = asShown(*end);
    std::ranges::reverse(scale.breaks);
    for (double& one : scale.breaks) one = asShown(one);
    scale.reversed = !scale.reversed;
    scale.tick = (scale.high - scale.low) / 4;
    return scale;
}

Legend PlacesDock::legendOf(const ColourScale& scale, const ShownSun& shown) const {
    const bool isSun = model_->showsSun(shown);
    Legend legend{
        isSun ? QStringLiteral(NM_TEXT("Sun by place")) : QStringLiteral(NM_TEXT("Shadow by place")),
        isSun ? QStringLiteral(NM_TEXT("hours of sun a day"))
              : QStringLiteral(NM_TEXT("minutes of shadow a day"))};
    if (scale.of == ColourScale::Of::change) {
        legend.title = isSun ? QStringLiteral(NM_TEXT("Change of sun by place"))
                             : QStringLiteral(NM_TEXT("Change of shadow by place"));
        legend.unit = isSun ? QStringLiteral(NM_TEXT("minutes of sun a day"))
                            : QStringLiteral(NM_TEXT("minutes of shadow a day"));
    }
    legend.scale = {scale.high, scale.tick};
    legend.colours = scale;
    return legend;
}

QString PlacesDock::describeAt(glm::dvec2 point, const ShownSun& shown, const std::string& scenario) const {
    const auto place = picture_.placeAt(point);
    if (!place || !model_->sun()) return {};
    const QString name = placeName(model_->sun()->baseline.places[*place].name);
    const double hours = hoursOf(*model_->sun(), scenario, *place, shown);
    if (std::isnan(hours)) return tr("%1: no cell on open ground").arg(name);
    if (!model_->showsSun(shown)) {
        const QString minutes = groupDigits(std::abs(model_->shownOf(hours, shown)));
        if (shown.what != ShownSun::What::change) return tr("%1: %2 min of shadow a day").arg(name, minutes);
        return hours < 0 ? tr("%1: %2 min of shadow a day more").arg(name, minutes)
                         : tr("%1: %2 min of shadow a day less").arg(name, minutes);
    }
    if (shown.what == ShownSun::What::change)
        return hours < 0 ? tr("%1: %2 min of sun a day less").arg(name, groupDigits(-hours * 60))
                         : tr("%1: %2 min of sun a day more").arg(name, groupDigits(hours * 60));
    return tr("%1: %2 h of sun a day").arg(name, groupDigits(hours, 2));
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

}  // namespace noonmark
