#include "app/gui/docks/places/places_dock.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QTimer>
#include <QTreeView>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/gui/base/widgets/buttons.h"
#include "app/gui/base/widgets/error_text.h"
#include "app/gui/base/widgets/number_fields.h"
#include "app/gui/base/widgets/number_text.h"
#include "app/gui/session/study/region_text.h"
#include "core/describe/shown_as.h"
#include "core/engines/api/tree_shade.h"
#include "core/study/by_place/sun_by_place.h"

namespace noonmark {

namespace {

constexpr int ticksOfHour = 10;
constexpr int thresholdRestMs = 250;

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

void PlacesDock::enableThreshold() {
    const bool ofHours = shown().what != ShownSun::What::change;
    for (QWidget* field : {static_cast<QWidget*>(slider_), static_cast<QWidget*>(threshold_)})
        field->setEnabled(model_->sun() && ofHours && aside_->text().isEmpty());
}

}  // namespace noonmark
