#include "app/gui/docks/elements/elements_dock.h"

#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QTableView>
#include <QVBoxLayout>

#include "app/gui/base/widgets/number_fields.h"
#include "app/gui/base/widgets/number_words.h"

namespace noonmark {

ElementsDock::ElementsDock(QWidget* parent)
    : QWidget(parent),
      model_(new ElementModel(this)),
      filter_(new ElementFilter(this)),
      text_(new QLineEdit),
      below_(numberField(0, 24, 1, 0.5, tr(" h"))),
      count_(new QLabel),
      table_(new QTableView) {
    filter_->setSourceModel(model_);
    placeFields();
    connectFields();
    count();
}

void ElementsDock::placeFields() {
    text_->setObjectName(QStringLiteral("elementFilter"));
    text_->setPlaceholderText(tr("Part of a building or point"));
    text_->setToolTip(tr("Lists only the points whose id or building contains this text"));
    text_->setClearButtonEnabled(true);
    below_->setObjectName(QStringLiteral("elementBelow"));
    below_->setSpecialValueText(tr("any"));
    below_->setToolTip(tr("Lists only the points with less sun a day than this"));
    table_->setObjectName(QStringLiteral("elementTable"));
    table_->setModel(filter_);
    table_->setSortingEnabled(true);
    table_->sortByColumn(-1, Qt::AscendingOrder);
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setSelectionMode(QAbstractItemView::ExtendedSelection);
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->verticalHeader()->hide();
    table_->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
    table_->setToolTip(tr("Select rows to see their points in the view; double-click to go there"));
    auto* line = new QHBoxLayout;
    line->addWidget(text_, 1);
    line->addWidget(new QLabel(tr("Sun below")));
    line->addWidget(below_);
    line->addWidget(count_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(4, 4, 4, 4);
    column->addLayout(line);
    column->addWidget(table_, 1);
}

void ElementsDock::connectFields() {
    connect(text_, &QLineEdit::textChanged, this, [this](const QString& text) {
        filter_->setText(text);
        count();
    });
    connect(below_, &QDoubleSpinBox::valueChanged, this, [this](double hours) {
        filter_->setBelowHours(hours);
        count();
    });
    connect(table_->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            [this] { Q_EMIT pointedAt(selected()); });
    connect(table_, &QTableView::activated, this,
            [this](const QModelIndex& index) { Q_EMIT wanted(elementOf(index)); });
}

void ElementsDock::show(std::shared_ptr<const ElementMap> map) {
    if (map == model_->map()) return;
    const bool first = model_->map() == nullptr;
    model_->show(std::move(map));
    if (first && model_->map()) table_->resizeColumnsToContents();
    count();
}

void ElementsDock::count() {
    const int all = model_->rowCount(), shown = filter_->rowCount();
    const QString number = formatCount(quint64(all));
    count_->setText(all == 0 ? tr("No points measured")
                    : shown == all
                        ? tr("%1 point(s)", "", all).arg(number)
                        : tr("%1 of %2 point(s)", "", all).arg(formatCount(quint64(shown)), number));
}

std::size_t ElementsDock::elementOf(const QModelIndex& index) const {
    return std::size_t(filter_->mapToSource(index).row());
}

std::vector<std::size_t> ElementsDock::selected() const {
    std::vector<std::size_t> elements;
    for (const QModelIndex& index : table_->selectionModel()->selectedRows())
        elements.push_back(elementOf(index));
    return elements;
}

void ElementsDock::select(std::size_t element) {
    const QModelIndex source = model_->index(int(element), 0);
    if (!source.isValid()) return;
    if (!filter_->mapFromSource(source).isValid()) {
        text_->clear();
        below_->setValue(0);
    }
    const QModelIndex row = filter_->mapFromSource(source);
    table_->selectRow(row.row());
    table_->scrollTo(row);
}

}  // namespace noonmark
