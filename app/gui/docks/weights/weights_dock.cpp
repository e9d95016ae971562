#include "app/gui/docks/weights/weights_dock.h"

#include <QComboBox>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QPainter>
#include <QPushButton>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QTableView>
#include <QVBoxLayout>

#include "app/gui/base/looks/theme.h"
#include "app/gui/base/widgets/buttons.h"
#include "app/gui/base/widgets/error_text.h"
#include "app/gui/base/widgets/name_text.h"
#include "app/gui/docks/weights/weights_model.h"
#include "app/gui/session/project/project_session.h"
#include "app/report/maps/style.h"
#include "core/city/city.h"
#include "scenarios/weights/edit_weights.h"

namespace noonmark {

void WeightBar::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
    QStyledItemDelegate::paint(painter, option, index);
    const double weight = index.data(Qt::UserRole).toDouble();
    const QRectF cell = QRectF(option.rect).adjusted(3, 0, -3, -2);
    const double half = cell.width() / 2 * std::abs(weight);
    const double left = weight < 0 ? cell.center().x() - half : cell.center().x();
    painter->fillRect(QRectF(left, cell.bottom() - 4, half, 4), impactColour(-weight));
}

WeightsDock::WeightsDock(ProjectSession& session, QWidget* parent)
    : QWidget(parent),
      session_(session),
      model_(new WeightsModel(session, this)),
      tables_(new QComboBox),
      view_(new QTableView),
      refusal_(new QLabel),
      score_(pushButton(tr("Compute score"), "score",
                        tr("Shadow of the displayed scenario over the study's region and period, weighted by "
                           "this table: by month and as a map"))),
      note_(new QLabel(tr("Cutting an interval in two changes the score, but not the weighted shade."))) {
    tables_->setObjectName(QStringLiteral("weightTables"));
    tables_->setToolTip(
        tr("The weight table to edit and to compute scores with; rename it with F2 in the project tree"));
    refusal_->setObjectName(QStringLiteral("refusal"));
    refusal_->setWordWrap(true);
    note_->setWordWrap(true);
    note_->setEnabled(false);  // in the quiet colour of the theme
    showAsError(*refusal_);
    makeView();
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(4, 4, 4, 4);
    column->addWidget(tables_);
    column->addWidget(new WeightCalendar(*model_));
    column->addWidget(view_, 1);
    column->addWidget(refusal_);
    column->addWidget(note_);
    column->addWidget(makeButtons());
    column->addWidget(score_);
    connect(tables_, &QComboBox::currentIndexChanged, this,
            [this] { choose(tables_->currentData().toString().toStdString()); });
    connect(score_, &QPushButton::clicked, this, &WeightsDock::score);
    connect(model_, &WeightsModel::refused, this,
            [this](const Error& error) { report(describeError(error)); });
    connect(model_, &WeightsModel::edited, this, [this] { report({}); });
    connect(&session_, &ProjectSession::changed, this, &WeightsDock::follow);
    report({});
    follow();
}

void WeightsDock::score() { Q_EMIT scoreRequested(model_->table().name); }

void WeightsDock::makeView() {
    view_->setObjectName(QStringLiteral("weights"));
    view_->setModel(model_);
    view_->setItemDelegateForColumn(WeightsModel::intervalWeight, new WeightBar(view_));
    view_->setSelectionBehavior(QAbstractItemView::SelectRows);
    view_->setSelectionMode(QAbstractItemView::SingleSelection);
    view_->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed |
                           QAbstractItemView::AnyKeyPressed);
    view_->setShowGrid(false);
    view_->verticalHeader()->hide();
    view_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    view_->setTextElideMode(Qt::ElideRight);
    view_->horizontalHeader()->setTextElideMode(Qt::ElideRight);
    fitColumns();
    view_->horizontalHeader()->moveSection(WeightsModel::intervalWeight, 1);  // visible in a narrow dock
    view_->verticalHeader()->setDefaultSectionSize(view_->fontMetrics().height() + 10);
}

// Keeps all columns visible in the narrowest dock: each is as wide as its longest content, and names take the
// rest.
void WeightsDock::fitColumns() {
    constexpr int padding = 8, minName = 60;
    const QString day = QStringLiteral("30 May"), hour = QStringLiteral("00:00");
    const std::pair<int, QString> widest[] = {{WeightsModel::firstDay, day},
                                              {WeightsModel::lastDay, day},
                                              {WeightsModel::fromHour, hour},
                                              {WeightsModel::toHour, hour},
                                              {WeightsModel::intervalWeight, tr("Weight")}};
    QHeaderView* header = view_->horizontalHeader();
    header->setMinimumSectionSize(24);
    header->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    header->setSectionResizeMode(QHeaderView::Fixed);
    header->setSectionResizeMode(WeightsModel::intervalName, QHeaderView::Stretch);
    int sum = minName + view_->verticalScrollBar()->sizeHint().width() + 2 * view_->frameWidth();
    for (const auto& [column, text] : widest) {
        header->resizeSection(column, view_->fontMetrics().horizontalAdvance(text) + padding);
        sum += header->sectionSize(column);
    }
    view_->setMinimumWidth(sum);
}

QWidget* WeightsDock::makeButtons() {
    auto* add = pushButton(tr("Add"), "addInterval",
                           tr("Adds an interval after the selected one: over days without a weight, else "
                              "over half of its days"));
    auto* remove = pushButton(tr("Remove"), "removeInterval",
                              tr("Removes the selected interval; its time then has no weight"));
    auto* table = pushButton(tr("New table"), "newTable",
                             tr("Adds a table that starts with the twelve months of the paper"));
    connect(add, &QPushButton::clicked, this, &WeightsDock::addInterval);
    connect(remove, &QPushButton::clicked, this, &WeightsDock::removeInterval);
    connect(table, &QPushButton::clicked, this, [this] {
        TimeWeights months = makeMonthlyWeights();
        months.name = "my weights";
        addTable(std::move(months));
    });
    auto* buttons = new QWidget;
    auto* grid = new QGridLayout(buttons);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->addWidget(add, 0, 0);
    grid->addWidget(remove, 0, 1);
    grid->addWidget(table, 1, 0);
    grid->addWidget(makeTemplates(), 1, 1);
    return buttons;
}

void WeightsDock::choose(const std::string& table) {
    if (table != model_->table().name) report({});
    model_->setTable(table);
    follow();
}

// Fills the list and selects the model's table, or the first one if that no longer exists.
void WeightsDock::follow() {
    const QSignalBlocker quiet(tables_);
    tables_->clear();
    for (const TimeWeights& table : session_.project().weights)
        tables_->addItem(weightName(table.name), QString::fromStdString(table.name));
    const int at = tables_->findData(QString::fromStdString(model_->table().name));
    tables_->setCurrentIndex(std::max(at, tables_->count() > 0 ? 0 : -1));
    if (at < 0) model_->setTable(tables_->currentData().toString().toStdString());
    score_->setEnabled(tables_->count() > 0);
}

// Under a name that is free.
void WeightsDock::addTable(TimeWeights table) {
    Project next = session_.project();
    table.name = freeName(next, ProjectPart::weights, table.name);
    const std::string name = table.name;
    next.weights.push_back(std::move(table));
    if (session_.change(std::move(next), tr("new weight table %1").arg(weightName(name)))) choose(name);
}

QWidget* WeightsDock::makeTemplates() {
    auto* button = pushButton(tr("New from template"), "weightTemplates",
                              tr("Adds a table made for the latitude of this city, or a copy of a table of "
                                 "this project"));
    auto* menu = new QMenu(button);
    menu->setToolTipsVisible(true);
    connect(menu, &QMenu::aboutToShow, this, [this, menu] { fillTemplates(*menu); });
    button->setMenu(menu);
    return button;
}

void WeightsDock::fillTemplates(QMenu& menu) {
    menu.clear();
    const double latitude = session_.city()->frame.origin().latDeg;
    const auto offer = [&](const QString& text, const QString& tip, const TimeWeights& table) {
        QAction* action = menu.addAction(text, this, [this, table] { addTable(table); });
        action->setToolTip(tip);
    };
    offer(tr("Pedestrian comfort"),
          tr("Shade wanted in summer afternoons, sun in winter: a rule of thumb by latitude"),
          makeComfortWeights(latitude));
    offer(tr("Plants"), tr("Sun wanted in the growing season: a rule of thumb by latitude"),
          makePlantWeights(latitude));
    menu.addSeparator();
    for (const TimeWeights& table : session_.project().weights)
        offer(tr("As %1").arg(weightName(table.name)), tr("A copy, to be changed"), table);
}

void WeightsDock::addInterval() {
    const int row = model_->add(view_->currentIndex().row());
    if (row >= 0) view_->setCurrentIndex(model_->index(row, WeightsModel::intervalName));
}

void WeightsDock::removeInterval() {
    if (view_->currentIndex().isValid()) model_->removeRows(view_->currentIndex().row(), 1);
}

void WeightsDock::report(const QString& text) {
    refusal_->setText(text);
    refusal_->setVisible(!text.isEmpty());
}

}  // namespace noonmark
