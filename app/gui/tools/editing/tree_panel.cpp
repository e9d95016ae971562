#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/gui/base/widgets/buttons.h"
#include "app/gui/base/widgets/error_text.h"
#include "app/gui/base/widgets/field_rows.h"
#include "app/gui/base/widgets/number_fields.h"
#include "app/gui/base/widgets/number_text.h"
#include "app/gui/session/study/region_text.h"
#include "app/gui/tools/editing/tree_editing.h"
#include "scenarios/edits/tree_edits.h"

namespace noonmark {

namespace {

constexpr double defaultSpacingM = 8;
constexpr double defaultYears = 10, maxYears = 200;  // as growTree()

QString describeTree(const Tree& tree) {
    const QString species =
        tree.species.empty() ? TreePanel::tr("Species not known") : QString::fromStdString(tree.species);
    const bool hasDays = !tree.evergreen && (tree.leafOnDay || tree.leafOffDay);
    const QString leaves = tree.evergreen ? TreePanel::tr("evergreen")
                           : hasDays      ? TreePanel::tr("loses its leaves (days of its own)")
                                          : TreePanel::tr("loses its leaves");
    return TreePanel::tr("%1, %2 high, crown %3, %4")
        .arg(species, describeLength(double(tree.heightM)), describeLength(double(tree.crownDiameterM)),
             leaves);
}

// The leaf cycle where it is not that of the genus.
TreeFacts factsOf(const Tree& tree) {
    const bool isOfGenus = completeTree({.species = tree.species}).evergreen == tree.evergreen;
    return {.species = tree.species,
            .heightM = double(tree.heightM),
            .crownDiameterM = double(tree.crownDiameterM),
            .crownBaseM = double(tree.crownBaseM),
            .evergreen = isOfGenus ? std::nullopt : std::optional(tree.evergreen),
            .leafOnDay = tree.leafOnDay,
            .leafOffDay = tree.leafOffDay};
}

constexpr std::size_t maxFigures = 6;  // rows: the region and the places that change most

QTableWidget* makeFigureTable() {
    auto* table = new QTableWidget(0, 3);
    table->setObjectName(QStringLiteral("treeFigures"));
    table->setToolTip(
        TreePanel::tr("With trees, in the mean over the cells, while trees are dragged or planted: the "
                      "region of the study and the places that change most"));
    table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table->setSelectionMode(QAbstractItemView::NoSelection);
    table->setFocusPolicy(Qt::NoFocus);
    table->verticalHeader()->hide();
    table->verticalHeader()->setDefaultSectionSize(table->fontMetrics().height() + 6);
    table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
    table->hide();
    return table;
}

// Place, minutes, and their change, which may be small: a tree shades little of a region.
QStringList textsOf(const LivePlaceShade& shade, bool isSun, double sunlitMin) {
    QString name = shade.name.empty() ? TreePanel::tr("Whole region") : placeName(shade.name);
    if (!shade.whole) name += QObject::tr(" (of the part that is measured)");
    const double change = (isSun ? -1 : 1) * (shade.nowMin - shade.beforeMin);
    return {name, groupDigits(isSun ? sunlitMin - shade.nowMin : shade.nowMin, 1),
            withPlus(change, std::abs(change) < 1 ? formatShort(change, 2) : groupDigits(change, 1))};
}

// The region, and the places whose change is more than rounding.
std::vector<LivePlaceShade> listChanged(const std::vector<LivePlaceShade>& figures) {
    constexpr double roundingMin = 0.005;
    std::vector<LivePlaceShade> changed;
    for (const LivePlaceShade& one : figures)
        if (changed.size() < maxFigures &&
            (one.name.empty() || std::abs(one.nowMin - one.beforeMin) >= roundingMin))
            changed.push_back(one);
    return changed;
}

}  // namespace

TreePanel::TreePanel(QWidget* parent)
    : QWidget(parent),
      chosen_(new QLabel),
      fields_(new FieldRows(treeFactFields().rows(), this)),
      spacing_(lengthField(1, 500, 1, 1)),
      years_(numberField(1, maxYears, 0, 5, tr(" years"))),
      plant_(pushButton(tr("Plant"), "plantTree", tr("Each click on the ground plants a tree; Esc ends"))),
      row_(pushButton(tr("Plant a row"), "plantRow",
                      tr("Click the corners of a line; a double click or Enter plants trees along it"))),
      replace_(pushButton(tr("Replace"), "replaceTrees",
                          tr("Puts trees with the measures above in place of the chosen ones"))),
      fell_(pushButton(tr("Fell"), "fellTrees", tr("Removes the chosen trees (Delete)"))),
      grow_(pushButton(tr("Let grow"), "growTrees",
                       tr("The chosen trees after these years; all of the city if none is chosen"))),
      read_(pushButton(tr("Read trees of a file..."), "readTrees",
                       tr("Adds an inventory, OpenStreetMap or a raster of canopy heights to the existing "
                          "city"))),
      figures_(makeFigureTable()) {
    chosen_->setObjectName(QStringLiteral("chosenTrees"));
    chosen_->setWordWrap(true);
    for (QPushButton* button : {plant_, row_}) button->setCheckable(true);
    spacing_->setObjectName(QStringLiteral("treeSpacing"));
    spacing_->setToolTip(tr("Distance between the trees of a row"));
    spacing_->setValue(defaultSpacingM);
    years_->setObjectName(QStringLiteral("treeYears"));
    years_->setValue(defaultYears);
    years_->setToolTip(tr("Years of growth, of which crown and height are estimated"));
    placeFields();
    // Pressing the button of the tool in use does not end it; Esc does.
    const auto choose = [this](Planting planting) {
        return [this, planting] {
            showPlanting(planting);
            Q_EMIT plantingChosen(planting);
        };
    };
    connect(plant_, &QPushButton::clicked, this, choose(Planting::single));
    connect(row_, &QPushButton::clicked, this, choose(Planting::row));
    connect(replace_, &QPushButton::clicked, this, &TreePanel::replaceRequested);
    connect(fell_, &QPushButton::clicked, this, &TreePanel::fellRequested);
    connect(grow_, &QPushButton::clicked, this, &TreePanel::growRequested);
    connect(read_, &QPushButton::clicked, this, &TreePanel::inventoryRequested);
    showChosen({}, 0);
}

void TreePanel::placeFields() {
    auto* form = new QFormLayout;
    form->setRowWrapPolicy(QFormLayout::WrapLongRows);
    fields_->addRows(*form);
    form->addRow(tr("Spacing"), spacing_);
    auto* column = new QVBoxLayout(this);
    column->addWidget(chosen_);
    column->addWidget(figures_);
    column->addLayout(form);
    column->addWidget(widgetRow({plant_, row_}));
    column->addWidget(widgetRow({replace_, fell_}));
    column->addWidget(widgetRow({years_, grow_}));
    column->addWidget(read_, 0, Qt::AlignLeft);
    column->addStretch(1);
}

void TreePanel::showChosen(const std::vector<Tree>& chosen, std::size_t all) {
    const QString count =
        all == 0 ? tr("The city has no trees yet. Plant some, or read those of a file")
                 : tr("%1 tree(s) in the city. Click one to choose it, Ctrl adds more", "", pluralNumber(all))
                       .arg(formatCount(all));
    if (chosen.size() == 1) {
        const TreeFacts facts = factsOf(chosen.front());
        fields_->show(treeFactFields().of(facts));
    }
    chosen_->setText(chosen.empty()       ? count
                     : chosen.size() == 1 ? describeTree(chosen.front())
                                          : tr("%1 trees chosen").arg(formatCount(chosen.size())));
    for (QPushButton* button : {replace_, fell_}) button->setEnabled(!chosen.empty());
    grow_->setEnabled(all > 0);
}

void TreePanel::showPlanting(Planting planting) {
    plant_->setChecked(planting == Planting::single);
    row_->setChecked(planting == Planting::row);
}

void TreePanel::showFigures(const std::vector<LivePlaceShade>& all, ShownAs show, double sunlitMin) {
    const bool isSun = show != ShownAs::shadow;
    const std::vector<LivePlaceShade> figures = listChanged(all);
    figures_->setHorizontalHeaderLabels(
        {tr("Place"), isSun ? tr("Sun, min a day") : tr("Shadow, min a day"), tr("Change")});
    figures_->setRowCount(int(figures.size()));
    for (int i = 0; i < figures_->rowCount(); ++i) {
        const QStringList texts = textsOf(figures[std::size_t(i)], isSun, sunlitMin);
        for (int column = 0; column < texts.size(); ++column) {
            auto* item = new QTableWidgetItem(texts[column]);
            if (column > 0) item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
            figures_->setItem(i, column, item);
        }
    }
    figures_->setFixedHeight(figures_->horizontalHeader()->sizeHint().height() + 4 +
                             figures_->rowCount() * figures_->verticalHeader()->defaultSectionSize());
    figures_->setVisible(!figures.empty());
}

Result<TreeFacts> TreePanel::facts() const {
    TreeFacts facts;
    if (auto taken = fields_->tryTake(treeFactFields().of(facts)); !taken)
        return tl::make_unexpected(taken.error());
    return facts;
}

double TreePanel::spacingM() const { return spacing_->value(); }

double TreePanel::years() const { return years_->value(); }

}  // namespace noonmark
