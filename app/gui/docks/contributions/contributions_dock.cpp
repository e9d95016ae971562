#include "app/gui/docks/contributions/contributions_dock.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCompleter>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSortFilterProxyModel>
#include <QStyledItemDelegate>
#include <QTableView>
#include <QVBoxLayout>
#include <algorithm>

#include "app/gui/base/looks/units.h"
#include "app/gui/base/widgets/buttons.h"
#include "app/gui/base/widgets/number_text.h"
#include "app/gui/base/widgets/status_bars.h"
#include "app/gui/session/answers/bar_charts.h"
#include "app/report/maps/style.h"

namespace noonmark {

namespace {

QString textOf(double value, const ContributionColumn& column) {
    if (column.unit == FigureUnit::squareMetreHours)
        return localiseNumbers(QString::fromStdString(formatAreaHours(value, unitsInUse())));
    return groupDigits(column.unit == FigureUnit::share ? 100 * value : value, column.decimals);
}

}  // namespace

void ContributionModel::show(ContributionSheet sheet) {
    beginResetModel();
    sheet_ = std::move(sheet);
    largestShare_ = 0;
    for (const ContributionRow& row : sheet_.rows) largestShare_ = std::max(largestShare_, row.share);
    endResetModel();
}

int ContributionModel::rowOf(const Building* building) const {
    const auto found = std::ranges::find(sheet_.rows, building,
                                         [](const ContributionRow& row) { return row.building.get(); });
    return building == nullptr || found == sheet_.rows.end() ? -1 : int(found - sheet_.rows.begin());
}

int ContributionModel::rowOfTree(const std::string& id) const {
    const auto found = std::ranges::find(sheet_.rows, id, &ContributionRow::tree);
    return id.empty() || found == sheet_.rows.end() ? -1 : int(found - sheet_.rows.begin());
}

int ContributionModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : int(sheet_.rows.size());
}

int ContributionModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() || sheet_.columns.empty() ? 0 : 1 + int(sheet_.columns.size());
}

QVariant ContributionModel::data(const QModelIndex& index, int role) const {
    const ContributionRow& row = sheet_.rows[std::size_t(index.row())];
    const bool isName = index.column() == 0;
    if (role == Qt::TextAlignmentRole)
        return int(Qt::AlignVCenter | (isName ? Qt::AlignLeft : Qt::AlignRight));
    if (role == Qt::DecorationRole && isName && row.building)
        return toColour(contributionClasses[classOf(row.share)].colour);
    if (role == Qt::ToolTipRole && isName && row.building) {
        const QString id = QString::fromStdString(row.building->sourceId);
        return id == row.name ? row.name : QStringLiteral("%1 (%2)").arg(row.name, id);
    }
    if (role == barRole) return largestShare_ > 0 ? row.share / largestShare_ : 0;
    if (role != Qt::DisplayRole && role != valueRole) return {};
    if (isName) return row.name;
    const std::size_t column = std::size_t(index.column()) - 1;
    return role == valueRole ? QVariant(row.values[column])
                             : textOf(row.values[column], sheet_.columns[column]);
}

QVariant ContributionModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal) return {};
    if (section == 0)
        return role == Qt::DisplayRole
                   ? QVariant(sheet_.areTreesListed ? tr("Building or tree") : tr("Building"))
                   : QVariant();
    const ContributionColumn& column = sheet_.columns[std::size_t(section) - 1];
    if (role == Qt::DisplayRole) return column.heading;
    return role == Qt::ToolTipRole ? QVariant(column.meaning) : QVariant();
}

namespace {

constexpr int tablePx = 160;  // at least
constexpr int namePx = 150;   // of the names of buildings, at most at first
constexpr int swatchPx = 12;
constexpr int barAlpha = 60;  // of 255: the number on it stays readable

/// Draws a share as a bar behind its number, as long as it is of the largest share.
class ShareBars final : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override {
        const double share = index.data(ContributionModel::barRole).toDouble();
        QRectF bar = QRectF(option.rect).adjusted(1, 2, -1, -2);
        bar.setWidth(bar.width() * std::clamp(share, 0.0, 1.0));
        QColor colour = option.palette.color(QPalette::Highlight);
        colour.setAlpha(barAlpha);
        painter->fillRect(bar, colour);
        QStyledItemDelegate::paint(painter, option, index);
    }
};

}  // namespace

ContributionsDock::ContributionsDock(QWidget* parent)
    : QWidget(parent),
      model_(new ContributionModel(this)),
      sorted_(new QSortFilterProxyModel(this)),
      place_(new QComboBox),
      headline_(wrappedLabel("contributionHeadline")),
      note_(wrappedLabel("contributionNote")),
      attribute_(pushButton(tr("Attribute the shadow"), "attribute",
                            tr("Finds what each building takes, by month, with the engine and the steps of "
                               "the study"))),
      progress_(new ProgressStrip(QBoxLayout::TopToBottom)),
      months_(new BarCharts),
      table_(new QTableView),
      colours_(new QCheckBox(tr("Colour the buildings"))),
      legend_(makeLegend()),
      export_(pushButton(tr("Export..."), "exportContributions",
                         tr("Writes this list with the answer, as CSV and JSON"))) {
    makeFields();
    makeTable();
    placeFields();
    connectFields();
    setPlaces({});
    explain({});
}

void ContributionsDock::makeFields() {
    place_->setObjectName(QStringLiteral("contributionPlace"));
    place_->setToolTip(tr("Whose shadow is attributed to buildings. Or click a place in the view"));
    place_->setEditable(true);
    place_->setInsertPolicy(QComboBox::NoInsert);
    place_->completer()->setFilterMode(Qt::MatchContains);
    place_->completer()->setCompletionMode(QCompleter::PopupCompletion);
    place_->lineEdit()->setToolTip(place_->toolTip());
    place_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    place_->setMinimumContentsLength(14);
    QFont bold = headline_->font();
    bold.setBold(true);
    headline_->setFont(bold);
    note_->setForegroundRole(QPalette::PlaceholderText);
    months_->setObjectName(QStringLiteral("contributionMonths"));
    colours_->setObjectName(QStringLiteral("colourBuildings"));
    colours_->setChecked(true);
    colours_->setToolTip(tr("Colours the buildings in the view by their share of the shadow"));
}

void ContributionsDock::makeTable() {
    sorted_->setSourceModel(model_);
    sorted_->setSortRole(ContributionModel::valueRole);
    sorted_->setSortCaseSensitivity(Qt::CaseInsensitive);
    table_->setTextElideMode(Qt::ElideMiddle);  // numbers of buildings differ at their ends
    table_->setObjectName(QStringLiteral("contributionTable"));
    table_->setModel(sorted_);
    table_->setSortingEnabled(true);
    table_->sortByColumn(-1, Qt::DescendingOrder);
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setSelectionMode(QAbstractItemView::SingleSelection);
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->setItemDelegateForColumn(1, new ShareBars(table_));
    table_->setMinimumHeight(tablePx);
    table_->verticalHeader()->hide();
    table_->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
    table_->setToolTip(tr("A row selects its building in the view; double-click to go there"));
}

QWidget* ContributionsDock::makeLegend() {
    constexpr int inRow = 3;  // so that a narrow panel need not scroll
    auto* legend = new QWidget;
    auto* cells = new QGridLayout(legend);
    cells->setContentsMargins(0, 0, 0, 0);
    cells->setSpacing(3);
    for (std::size_t i = 0; i < contributionClasses.size(); ++i) {
        QPixmap swatch(swatchPx, swatchPx);
        swatch.fill(toColour(contributionClasses[i].colour));
        auto* colour = new QLabel;
        colour->setPixmap(swatch);
        const int row = int(i) / inRow, column = 2 * (int(i) % inRow);
        cells->addWidget(colour, row, column);
        cells->addWidget(new QLabel(describeClass(i)), row, column + 1);
        cells->setColumnStretch(column + 1, 1);
    }
    legend->setToolTip(tr("Share of the shadow that a building is charged with"));
    return legend;
}

void ContributionsDock::placeFields() {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(4, 4, 4, 4);
    for (QWidget* widget :
         std::initializer_list<QWidget*>{place_, headline_, note_, attribute_, progress_, months_})
        column->addWidget(widget);
    column->addWidget(table_, 100);
    column->addWidget(colours_);
    column->addWidget(legend_);
    column->addWidget(export_);
    column->addStretch();  // below what little there is without a table
}

void ContributionsDock::connectFields() {
    connect(place_, &QComboBox::activated, this,
            [this](int index) { chooseSubject(index == 0 ? QString() : place_->itemText(index)); });
    connect(export_, &QPushButton::clicked, this, &ContributionsDock::exportRequested);
    connect(attribute_, &QPushButton::clicked, this, &ContributionsDock::attributionRequested);
    connect(colours_, &QCheckBox::toggled, this, [this](bool on) {
        legend_->setVisible(on);
        Q_EMIT coloursChanged();
    });
    const auto rowAt = [this](const QModelIndex& index) {
        return model_->sheet().rows[std::size_t(sorted_->mapToSource(index).row())];
    };
    connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this, rowAt](const QModelIndex& index) {
                if (index.isValid()) Q_EMIT highlighted(rowAt(index));
            });
    connect(table_, &QTableView::activated, this,
            [this, rowAt](const QModelIndex& index) { Q_EMIT goToRequested(rowAt(index)); });
}

void ContributionsDock::chooseSubject(const QString& text) {
    subject_ = text.toStdString();
    Q_EMIT subjectChosen(subject_);
}

void ContributionsDock::setPlaces(const QStringList& names) {
    const QSignalBlocker quiet(place_);
    place_->clear();
    place_->addItem(tr("Whole region"));
    place_->addItems(names);
    setSubject(subject_);
}

void ContributionsDock::setSubject(const std::string& place) {
    subject_ = place;
    const QSignalBlocker quiet(place_);
    const int index = place.empty() ? 0 : place_->findText(QString::fromStdString(place), Qt::MatchExactly);
    place_->setCurrentIndex(index);
    if (index < 0) place_->setEditText(QString::fromStdString(place));
    place_->lineEdit()->setCursorPosition(0);
}

void ContributionsDock::show(ContributionSheet sheet) {
    const bool first = model_->columnCount() == 0;
    headline_->setText(sheet.headline);
    headline_->setVisible(!sheet.headline.isEmpty());
    note_->setText(sheet.note);
    note_->setVisible(!sheet.note.isEmpty());
    for (QLabel* label : {headline_, note_}) label->setToolTip(sheet.method);
    attribute_->hide();
    months_->show({sheet.months});
    const bool any = !sheet.rows.empty();
    model_->show(std::move(sheet));
    for (QWidget* widget : std::initializer_list<QWidget*>{table_, colours_, export_})
        widget->setVisible(any);
    legend_->setVisible(any && colours());
    if (first && any) {
        table_->resizeColumnsToContents();
        table_->setColumnWidth(0, std::min(namePx, table_->columnWidth(0)));
    }
    Q_EMIT coloursChanged();
}

void ContributionsDock::explain(const QString& why, bool offer, const Bars& months) {
    show({.note = why, .months = months});
    attribute_->setVisible(offer);
}

void ContributionsDock::select(const Building* building) { selectRow(model_->rowOf(building)); }

void ContributionsDock::selectTree(const std::string& id) { selectRow(model_->rowOfTree(id)); }

void ContributionsDock::selectRow(int row) {
    const QSignalBlocker quiet(this);
    if (row < 0) return table_->clearSelection();
    const QModelIndex index = sorted_->mapFromSource(model_->index(row, 0));
    table_->selectRow(index.row());
    table_->scrollTo(index);
}

bool ContributionsDock::colours() const { return colours_->isChecked(); }

void ContributionsDock::setInFront(bool inFront) {
    inFront_ = inFront;
    Q_EMIT shownChanged();
}

void ContributionsDock::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    Q_EMIT shownChanged();
}

void ContributionsDock::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    Q_EMIT shownChanged();
}

}  // namespace noonmark
