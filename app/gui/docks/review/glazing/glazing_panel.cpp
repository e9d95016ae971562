#include "app/gui/docks/review/glazing/glazing_panel.h"

#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>

#include "app/gui/base/widgets/error_text.h"
#include "app/gui/base/widgets/name_text.h"
#include "app/gui/base/widgets/number_text.h"
#include "app/gui/docks/review/verdict_table.h"
#include "app/gui/docks/study_form/element_form.h"
#include "core/study/glazing/glazing_text.h"

namespace noonmark {

GlazingForm::GlazingForm(QWidget* parent)
    : QWidget(parent), source_(new QComboBox), form_(new ElementForm(ElementForm::Use::rule)) {
    source_->setObjectName(QStringLiteral("windowSource"));
    source_->addItem(tr("Facades, bay by bay"), int(ElementPlaces::facades));
    source_->addItem(tr("From a file"), int(ElementPlaces::windows));
    source_->setToolTip(tr("A file of points or polygons with heights gives the real windows"));
    source_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    auto* row = new QFormLayout;
    row->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    row->addRow(tr("Windows"), source_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addLayout(row);
    column->addWidget(form_);
    column->addStretch();
    connect(source_, &QComboBox::activated, this, [this] {
        ElementSettings windows = form_->settings();
        windows.places = ElementPlaces(source_->currentData().toInt());
        form_->show(windows);
        Q_EMIT edited(windows);
    });
    connect(form_, &ElementForm::edited, this,
            [this](const ElementSettings& windows) { Q_EMIT edited(windows); });
}

void GlazingForm::show(const ElementSettings& windows) {
    source_->setCurrentIndex(source_->findData(int(windows.places)));
    form_->show(windows);
}

void GlazingForm::setBuilding(const QString& id) { form_->setBuilding(id); }

GlazingPanel::GlazingPanel(QWidget* parent)
    : QWidget(parent), choice_(new QComboBox), table_(new GlazingTable) {
    choice_->setObjectName(QStringLiteral("verdictsInView"));
    choice_->addItem(tr("Verdicts after"), int(ShownVerdicts::after));
    choice_->addItem(tr("Verdicts before"), int(ShownVerdicts::before));
    choice_->addItem(tr("Changed verdicts"), int(ShownVerdicts::change));
    choice_->addItem(tr("No verdicts"), int(ShownVerdicts::none));
    choice_->setToolTip(
        tr("What the 3D view shows on the walls: a tile for each window in the colour of its verdict.\n"
           "A click on a tile selects its row, a click on a row frames its window."));
    auto* label = new QLabel(tr("In the view"));
    label->setBuddy(choice_);
    auto* row = new QHBoxLayout;
    row->addWidget(label);
    row->addWidget(choice_);
    row->addStretch(1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addLayout(row);
    column->addWidget(table_, 1);
    connect(choice_, &QComboBox::activated, this, [this] {
        away_.reset();
        Q_EMIT shownChanged();
    });
}

ShownVerdicts GlazingPanel::shown() const { return ShownVerdicts(choice_->currentData().toInt()); }

void GlazingPanel::setShown(ShownVerdicts shown) {
    choice_->setCurrentIndex(choice_->findData(int(shown)));
    away_.reset();
    Q_EMIT shownChanged();
}

void GlazingPanel::suspend() {
    if (shown() == ShownVerdicts::none) return;
    const ShownVerdicts before = shown();
    setShown(ShownVerdicts::none);
    away_ = before;
}

void GlazingPanel::resumeShown() {
    if (away_) setShown(*away_);
}

namespace {

constexpr int rowRole = Qt::UserRole, valueRole = Qt::UserRole + 1;
enum GlazingColumn {
    windowColumn,
    formerColumn,
    verdictColumn,
    floorColumn,
    facingColumn,
    buildingColumn,
    firstValueColumn
};
constexpr int widestColumn = 190;  // pixels: ids may be long, and end with what tells them apart

/// Sorts by number where a column has numbers.
class Item final : public QTreeWidgetItem {
public:
    using QTreeWidgetItem::QTreeWidgetItem;
    bool operator<(const QTreeWidgetItem& other) const override {
        const int column = treeWidget()->sortColumn();
        const QVariant own = data(column, valueRole), others = other.data(column, valueRole);
        if (own.isValid() && others.isValid()) return own.toDouble() < others.toDouble();
        return QTreeWidgetItem::operator<(other);
    }
};

void setNumber(QTreeWidgetItem& item, int column, double value, const QString& text) {
    item.setText(column, text);
    item.setData(column, valueRole, value);
    item.setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
}

void setVerdict(QTreeWidgetItem& item, int column, Verdict verdict) {
    item.setText(column, describeVerdict(verdict));
    item.setForeground(column, verdictColour(verdict));
}

void setValue(QTreeWidgetItem& item, int column, const Criterion& criterion,
              const std::optional<Measured>& value) {
    if (value)
        setNumber(item, column, value->value,
                  localiseNumbers(QString::fromStdString(valueText(criterion, value))));
}

}  // namespace

GlazingTable::GlazingTable(QWidget* parent) : QTreeWidget(parent) {
    setObjectName(QStringLiteral("windowVerdicts"));
    setUniformRowHeights(true);
    setTextElideMode(Qt::ElideLeft);
    setAllColumnsShowFocus(true);
    setRootIsDecorated(false);
    setHeaderHidden(true);
    connect(this, &QTreeWidget::currentItemChanged, this, [this](const QTreeWidgetItem* item) {
        describe(item);
        if (const auto window = windowOf(item)) Q_EMIT highlighted(*window);
    });
    for (auto signal : {&QTreeWidget::itemClicked, &QTreeWidget::itemActivated})
        connect(this, signal, this, [this](const QTreeWidgetItem* item) {
            if (const auto window = windowOf(item)) Q_EMIT goToRequested(*window);
        });
}

std::optional<std::size_t> GlazingTable::windowOf(const QTreeWidgetItem* item) const {
    if (item == nullptr || !answer_) return std::nullopt;
    return std::size_t(rows_[item->data(0, rowRole).toULongLong()] - answer_->study.windows.data());
}

std::optional<std::size_t> GlazingTable::chosen() const { return windowOf(currentItem()); }

void GlazingTable::choose(std::size_t window) {
    for (int row = 0; row < topLevelItemCount(); ++row) {
        if (windowOf(topLevelItem(row)) != window) continue;
        setCurrentItem(topLevelItem(row));
        return scrollToItem(topLevelItem(row));
    }
}

void GlazingTable::showColumns() {
    QStringList titles{tr("Window"), tr("Before"), tr("After"), tr("Floor"), tr("Faces"), tr("Building")};
    for (const Criterion& criterion : answer_->study.rule.criteria) {
        const QString name = ruleName(criterion.name);
        titles << tr("%1, before").arg(name) << tr("%1, after").arg(name);
    }
    setColumnCount(int(titles.size()));
    setHeaderLabels(titles);
}

void GlazingTable::show(const std::shared_ptr<const GlazingAnswer>& answer) {
    setSortingEnabled(false);
    setHeaderHidden(answer == nullptr);
    clear();
    rows_.clear();
    answer_ = answer;
    if (!answer_) return describe(nullptr);
    showColumns();
    rows_ = sortWorstFirst(answer_->study.windows);
    QList<QTreeWidgetItem*> items;
    for (std::size_t row = 0; row < rows_.size(); ++row) {
        const GlazingReview& review = *rows_[row];
        auto* item = new Item;
        item->setData(0, rowRole, qulonglong(row));
        item->setText(windowColumn, QString::fromStdString(review.window.id));
        const std::string& name = review.window.buildingName;
        item->setText(buildingColumn, QString::fromStdString(name.empty() ? review.window.building : name));
        setNumber(*item, floorColumn, review.window.floor, QString::number(review.window.floor));
        if (review.window.azimuthDeg)
            setNumber(*item, facingColumn, *review.window.azimuthDeg,
                      QStringLiteral("%1°").arg(qRound(*review.window.azimuthDeg)));
        setVerdict(*item, formerColumn, review.formerVerdict);
        setVerdict(*item, verdictColumn, review.verdict);
        for (std::size_t i = 0; i < review.results.size(); ++i) {
            const Criterion& criterion = answer_->study.rule.criteria[i];
            setValue(*item, firstValueColumn + int(2 * i), criterion, review.results[i].former);
            setValue(*item, firstValueColumn + int(2 * i) + 1, criterion, review.results[i].value);
        }
        items << item;
    }
    addTopLevelItems(items);
    header()->setSortIndicator(-1, Qt::AscendingOrder);
    setSortingEnabled(true);
    for (int column = 0; column < columnCount(); ++column) {
        resizeColumnToContents(column);
        setColumnWidth(column, std::min(columnWidth(column), widestColumn));
    }
    if (!items.isEmpty()) setCurrentItem(topLevelItem(0));
}

void GlazingTable::describe(const QTreeWidgetItem* item) {
    if (item == nullptr || !answer_) return Q_EMIT described({});
    const GlazingReview& review = *rows_[item->data(0, rowRole).toULongLong()];
    const GlazingStudy& study = answer_->study;
    QString words =
        tr("%1: %2.").arg(QString::fromStdString(review.window.id),
                          inWindowWords([&] { return describeReason(study.rule, review, writeDay); }));
    if (review.day) {
        const auto bands = [&](const std::vector<SunBand>& of) {
            const std::string text = bandsText(study, *review.day, of);
            return text.empty() ? tr("none") : QString::fromStdString(text);
        };
        words += ' ' + tr("Sun on %1: %2; before: %3.")
                           .arg(QLocale().toString(dateOf(*review.day), dayOfYear()), bands(review.bands),
                                bands(review.formerBands));
    }
    Q_EMIT described(words);
}

QString GlazingTable::text() const {
    QStringList lines;
    const auto line = [this](const auto& cell) {
        QStringList cells;
        for (int column = 0; column < columnCount(); ++column) cells << cell(column);
        return cells.join(u'\t');
    };
    lines << line([this](int column) { return headerItem()->text(column); });
    for (int row = 0; row < topLevelItemCount(); ++row)
        lines << line([this, row](int column) { return topLevelItem(row)->text(column); });
    return lines.join(u'\n');
}

QString describeGlazingVerdicts(const GlazingStudy& study) {
    const VerdictChanges& changes = study.windowChanges;
    const QString now = QObject::tr("%1 window(s): %2.", "", pluralNumber(study.windows.size()))
                            .arg(formatCount(study.windows.size()), describeCounts(changes.after));
    return now + QLatin1Char(' ') +
           QObject::tr("Compared with before, %1 get(s) worse and %2 better", "", pluralNumber(changes.worse))
               .arg(formatCount(changes.worse), formatCount(changes.better));
}

}  // namespace noonmark
