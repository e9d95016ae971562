#include "app/gui/base/widgets/table_columns.h"

#include <QEvent>
#include <QHeaderView>
#include <QMenu>
#include <QScrollBar>
#include <QSettings>

namespace noonmark {

ColumnMenu::ColumnMenu(QHeaderView& heading, int keyRole, QSettings& settings, const QString& setting)
    : QObject(&heading), heading_(heading), keyRole_(keyRole), settings_(settings), setting_(setting) {
    const QStringList hidden = settings_.value(setting_).toStringList();
    for (int column = 1; column < heading_.count(); ++column)
        heading_.setSectionHidden(column, hidden.contains(keyOf(column)));
    heading_.setContextMenuPolicy(Qt::CustomContextMenu);
    connect(&heading_, &QWidget::customContextMenuRequested, this, [this](const QPoint& at) {
        QMenu* menu = makeMenu();
        menu->setAttribute(Qt::WA_DeleteOnClose);
        menu->popup(heading_.mapToGlobal(at));
    });
}

QString ColumnMenu::keyOf(int column) const {
    return heading_.model()->headerData(column, Qt::Horizontal, keyRole_).toString();
}

QMenu* ColumnMenu::makeMenu() {
    auto* menu = new QMenu(&heading_);
    for (int column = 1; column < heading_.count(); ++column) {
        QString title = heading_.model()->headerData(column, Qt::Horizontal).toString();
        QAction* action = menu->addAction(title.replace(QLatin1Char('&'), QStringLiteral("&&")));
        action->setCheckable(true);
        action->setChecked(!heading_.isSectionHidden(column));
        connect(action, &QAction::toggled, this, [this, column](bool shown) { show(column, shown); });
    }
    return menu;
}

void ColumnMenu::show(int column, bool shown) {
    heading_.setSectionHidden(column, !shown);
    QStringList hidden;
    for (int i = 1; i < heading_.count(); ++i)
        if (heading_.isSectionHidden(i)) hidden << keyOf(i);
    settings_.setValue(setting_, hidden);
}

FrozenColumn::FrozenColumn(QTableView& table) : QTableView(&table), table_(table) {
    setObjectName(QStringLiteral("frozenColumn"));
    setModel(table_.model());
    setSelectionModel(table_.selectionModel());
    setSelectionBehavior(table_.selectionBehavior());
    setFocusPolicy(Qt::NoFocus);
    setFrameShape(QFrame::NoFrame);
    setShowGrid(table_.showGrid());
    setWordWrap(false);
    setVerticalScrollMode(table_.verticalScrollMode());
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    verticalHeader()->hide();
    followColumns();
    followSorting();
    followScrolling();
    connect(this, &QTableView::doubleClicked, &table_, &QTableView::doubleClicked);
    table_.installEventFilter(this);
    table_.viewport()->stackUnder(this);
    place();
    show();
}

void FrozenColumn::followColumns() {
    for (int column = 1; column < model()->columnCount(); ++column) setColumnHidden(column, true);
    horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    verticalHeader()->setDefaultSectionSize(table_.verticalHeader()->defaultSectionSize());
    connect(table_.horizontalHeader(), &QHeaderView::sectionResized, this, &FrozenColumn::place);
    connect(table_.horizontalHeader(), &QHeaderView::geometriesChanged, this, &FrozenColumn::place);
    connect(table_.verticalHeader(), &QHeaderView::sectionResized, this,
            [this](int row, int, int height) { setRowHeight(row, height); });
}

// A click on the heading of either sorts both: they share the model.
void FrozenColumn::followSorting() {
    QHeaderView *own = horizontalHeader(), *its = table_.horizontalHeader();
    own->setSectionsClickable(true);
    own->setSortIndicatorShown(true);
    own->setSortIndicatorClearable(its->isSortIndicatorClearable());
    own->setSortIndicator(its->sortIndicatorSection(), its->sortIndicatorOrder());
    connect(own, &QHeaderView::sortIndicatorChanged, its, &QHeaderView::setSortIndicator);
    connect(its, &QHeaderView::sortIndicatorChanged, own, &QHeaderView::setSortIndicator);
}

void FrozenColumn::followScrolling() {
    QScrollBar *own = verticalScrollBar(), *its = table_.verticalScrollBar();
    connect(own, &QScrollBar::valueChanged, its, &QScrollBar::setValue);
    connect(its, &QScrollBar::valueChanged, own, &QScrollBar::setValue);
}

bool FrozenColumn::eventFilter(QObject* watched, QEvent* event) {
    if (watched == &table_ && (event->type() == QEvent::Resize || event->type() == QEvent::Show)) place();
    return QTableView::eventFilter(watched, event);
}

void FrozenColumn::place() {
    const int width = table_.columnWidth(0), frame = table_.frameWidth();
    setColumnWidth(0, width);
    horizontalHeader()->setFixedHeight(table_.horizontalHeader()->height());
    const int height = table_.viewport()->height() + table_.horizontalHeader()->height();
    setGeometry(frame, frame, width, height);
}

}  // namespace noonmark
