#include "app/gui/tools/editing/tree_editing.h"

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
#include <glm/geometric.hpp>
#include <utility>

#include "app/gui/base/widgets/buttons.h"
#include "app/gui/base/widgets/cursor_label.h"
#include "app/gui/base/widgets/error_text.h"
#include "app/gui/base/widgets/field_rows.h"
#include "app/gui/base/widgets/number_fields.h"
#include "app/gui/base/widgets/number_text.h"
#include "app/gui/session/study/region_text.h"
#include "core/engines/api/tree_shade.h"
#include "render/scene/crown_bodies.h"
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

TreeEditing::TreeEditing(EditContext& context, TreePanel& panel, QObject* parent)
    : QObject(parent),
      context_(context),
      panel_(panel),
      claim_(context.panel.view(), [this](int key) { return key == Qt::Key_Delete && !ids_.empty(); }) {
    context_.panel.navigator().addTarget(*this);
    connect(&context_.panel.navigator(), &ViewNavigator::doubleClicked, this, [this] { finishRow(); });
    connect(&live_, &LiveTrees::changed, this, &TreeEditing::showLive);
    connect(&live_, &LiveTrees::failed, this, [this](const Error& error) {
        if (!isCancelled(error)) Q_EMIT hinted(describeError(error));
    });
    connect(&panel_, &TreePanel::plantingChosen, this, &TreeEditing::plant);
    connect(&panel_, &TreePanel::replaceRequested, this, &TreeEditing::replace);
    connect(&panel_, &TreePanel::fellRequested, this, &TreeEditing::fell);
    connect(&panel_, &TreePanel::growRequested, this, &TreeEditing::grow);
}

TreeEditing::~TreeEditing() { context_.panel.navigator().removeTarget(*this); }

const Trees* TreeEditing::trees() const {
    return context_.city ? context_.city->city().trees.get() : nullptr;
}

void TreeEditing::cityChanged() {
    std::set<std::string> there;
    for (const Tree& tree : chosenTrees()) there.insert(tree.sourceId);
    ids_ = std::move(there);
    if (std::exchange(grabbed_, std::nullopt)) endDrag();
    endPlanting();
    movedM_ = {0, 0};
    show();
}

void TreeEditing::plant(TreePanel::Planting planting) {
    planting_ = context_.city ? planting : TreePanel::Planting::none;
    corners_.clear();
    cursor_.reset();
    endPlanting();
    if (isPlanting()) {
        ids_.clear();
        context_.panel.view().requestActivate();  // the view receives the keys that end it
        Q_EMIT chosen();
    }
    show();
}

std::optional<std::size_t> TreeEditing::treeAt(QPointF pixel) const {
    const CityView& view = context_.panel.view();
    if (!trees() || !view.showsTrees()) return std::nullopt;
    const ViewRay ray = makeRayThrough(view.pose(), view.lens(), {pixel.x(), pixel.y()});
    const auto hit = pickTree(trees()->trees, ray);
    const auto behind = context_.panel.navigator().pickAt(pixel);
    if (!hit || (behind && glm::distance(behind->position, ray.origin) < hit->distanceM)) return std::nullopt;
    return hit->tree;
}

std::optional<glm::dvec2> TreeEditing::groundAt(QPointF pixel) const {
    const auto ground = context_.panel.navigator().groundAt(pixel);
    return ground ? std::optional(glm::dvec2(*ground)) : std::nullopt;
}

bool TreeEditing::click(QPointF pixel) {
    if (isPlanting()) {
        if (const auto ground = groundAt(pixel)) addCorner(*ground);
        return true;
    }
    const bool adds = context_.panel.navigator().clickModifiers().testFlag(Qt::ControlModifier);
    const auto tree = treeAt(pixel);
    if (!adds) ids_.clear();
    if (tree)
        if (const std::string& id = trees()->trees[*tree].sourceId; !ids_.insert(id).second) ids_.erase(id);
    show();
    if (tree) Q_EMIT chosen();
    return tree.has_value();
}

void TreeEditing::addCorner(glm::dvec2 ground) {
    if (planting_ == TreePanel::Planting::single) return plantAt({ground});
    corners_.push_back(ground);
    show();
}

// The second click of a double click is no corner of its own.
void TreeEditing::finishRow() {
    if (planting_ != TreePanel::Planting::row || corners_.empty()) return;
    const auto places = placeTreesAlong(std::exchange(corners_, {}), panel_.spacingM());
    if (!places) return Q_EMIT failed(places.error());
    plantAt(*places);
}

void TreeEditing::plantAt(const std::vector<glm::dvec2>& places) {
    const auto tree = panel_.facts().and_then(designTree);
    if (!tree) return Q_EMIT failed(tree.error());
    Q_EMIT editsMade(makePlantings(context_.city->city(), *tree, places),
                     tr("plant %1 tree(s)", "", int(places.size())).arg(formatCount(places.size())));
}

void TreeEditing::hover(QPointF pixel) {
    if (!isPlanting()) return;
    cursor_ = groundAt(pixel);
    show();
    followPlanting();
}

// Where the map of a study is shown. Another species or height in the panel is another tree.
void TreeEditing::followPlanting() {
    const std::vector<Tree> planned = plannedTrees();
    if (planned.empty() || planned.size() > LiveTreeShade::maxMoved) return endPlanting();
    Tree tree = planned.front();
    tree.place = {};
    if (tree != plantedAs_) {
        endPlanting();
        if (!isStudyShown()) return;
        plantedAs_ = tree;
        live_.begin(context_.study, {.moved = {}, .planted = tree}, context_.preview.places());
    }
    HandledPlaces places;
    for (const Tree& one : planned) places.planted.push_back(one.place);
    live_.follow(std::move(places));
}

void TreeEditing::endPlanting() {
    if (std::exchange(plantedAs_, std::nullopt)) stopLive();
}

bool TreeEditing::key(int key) {
    const bool enter = key == Qt::Key_Return || key == Qt::Key_Enter;
    if (enter && !corners_.empty()) return finishRow(), true;
    if (key != Qt::Key_Delete || ids_.empty()) return false;
    fell();
    return true;
}

std::optional<Tree> TreeEditing::findTree(const std::string& id) const {
    if (!trees()) return std::nullopt;
    const auto found = std::ranges::find(trees()->trees, id, &Tree::sourceId);
    return found == trees()->trees.end() ? std::nullopt : std::optional(*found);
}

void TreeEditing::choose(const std::string& id) {
    if (!findTree(id)) return;
    ids_ = {id};
    plant(TreePanel::Planting::none);
}

void TreeEditing::chooseNone() {
    ids_.clear();
    show();
}

bool TreeEditing::cancel() {
    if (!isPlanting() && ids_.empty()) return false;
    if (!isPlanting()) ids_.clear();
    plant(TreePanel::Planting::none);
    return true;
}

bool TreeEditing::grab(QPointF pixel) {
    if (isPlanting() || ids_.empty()) return false;
    const auto tree = treeAt(pixel);
    if (!tree || !ids_.contains(trees()->trees[*tree].sourceId)) return false;
    grabbed_ = groundAt(pixel);
    if (grabbed_) beginDrag();
    return grabbed_.has_value();
}

bool TreeEditing::isStudyShown() const {
    return context_.study && context_.panel.results().showsAnswer() &&
           context_.study->settings.trees != TreeColumns::without;
}

// A map of minutes follows where that of a study is shown, the shade of a moment where rays draw the view.
void TreeEditing::beginDrag() {
    if (isStudyShown())
        live_.begin(context_.study, {.moved = ids_, .planted = {}}, context_.preview.places());
    if (!context_.city->crowns) return;
    Trees others = *trees();
    std::erase_if(others.trees, [this](const Tree& tree) { return ids_.contains(tree.sourceId); });
    finding_.start<std::shared_ptr<const CrownRays>>(
        tr("Crowns of the other trees"),
        [others = std::make_shared<const Trees>(std::move(others))](Progress&, const std::stop_token& stop) {
            return makeCrownRays(others, stop);
        },
        [this](Result<std::shared_ptr<const CrownRays>> rays) {
            others_ = rays.value_or(nullptr);
            showDraggedShade();
        });
}

void TreeEditing::showDraggedShade() {
    if (!others_ || !grabbed_) return;
    Trees dragged{.trees = chosenTrees(), .leafDays = trees()->leafDays};
    for (Tree& tree : dragged.trees) {
        tree.place += movedM_;
        tree.groundM = float(noonmark::groundAt(context_.city->city(), tree.place));
    }
    const auto rays = makeCrownRays(std::make_shared<const Trees>(std::move(dragged)), {});
    if (!rays) return;
    CrownRays all = *others_;
    all.scenes.insert(all.scenes.end(), (*rays)->scenes.begin(), (*rays)->scenes.end());
    context_.panel.view().showTrees(others_->trees, std::make_shared<const CrownRays>(std::move(all)));
}

void TreeEditing::showLive() {
    if (!(grabbed_ || plantedAs_) || !live_.field()) return;
    const std::shared_ptr<const Study> study = live_.study();
    const QString columns = live_.isSeasonal() ? tr("With trees and their seasons, while they move")
                                               : tr("With trees as evergreens, while they move");
    context_.panel.results().setLive(
        GroundAnswer{.map = live_.field(),
                     .receivers = std::shared_ptr<const Receivers>(study, &study->receivers),
                     .note = columns,
                     .grossOnly = true});
    panel_.showFigures(live_.figures(), context_.panel.legend().choice().show,
                       study->field.sunlitMinutesPerDay);
}

void TreeEditing::stopLive() {
    live_.end();
    context_.panel.results().setLive(std::nullopt);
    panel_.showFigures({}, ShownAs::shadow, 0);
}

// The city with the trees where they were dropped follows; where it does not, they are where they were.
void TreeEditing::endDrag() {
    stopLive();
    finding_.drop();
    if (std::exchange(others_, nullptr))
        context_.panel.view().showTrees(context_.city->city().trees, context_.city->crowns);
}

void TreeEditing::dragTo(QPointF pixel) {
    const auto ground = groundAt(pixel);
    if (!grabbed_ || !ground) return;
    movedM_ = *ground - *grabbed_;
    show();
    live_.follow({.byM = movedM_, .planted = {}});
    showDraggedShade();
}

void TreeEditing::drop() {
    endDrag();
    grabbed_.reset();
    const glm::dvec2 by = std::exchange(movedM_, {0, 0});
    if (by == glm::dvec2(0)) return;
    std::vector<Edit> edits;
    for (const std::string& id : ids_) edits.emplace_back(MoveTree{id, by});
    Q_EMIT editsMade(std::move(edits),
                     tr("move %1 tree(s)", "", int(ids_.size())).arg(formatCount(ids_.size())));
}

void TreeEditing::fell() {
    std::vector<Edit> edits;
    for (const std::string& id : ids_) edits.emplace_back(FellTree{id});
    Q_EMIT editsMade(std::move(edits),
                     tr("fell %1 tree(s)", "", int(ids_.size())).arg(formatCount(ids_.size())));
}

void TreeEditing::replace() {
    const auto tree = panel_.facts().and_then(designTree);
    if (!tree) return Q_EMIT failed(tree.error());
    std::vector<Edit> edits;
    for (const std::string& id : ids_) edits.emplace_back(ReplaceTree{id, *tree});
    Q_EMIT editsMade(std::move(edits),
                     tr("replace %1 tree(s)", "", int(ids_.size())).arg(formatCount(ids_.size())));
}

void TreeEditing::grow() {
    std::vector<Edit> edits;
    const std::vector<Tree> some = ids_.empty() ? trees()->trees : chosenTrees();
    for (const Tree& tree : some)
        if (auto growth = makeGrowth(tree, panel_.years())) edits.push_back(*std::move(growth));
    if (edits.empty())
        return Q_EMIT failed({"None of these trees grows",
                              {},
                              "Trees of 35 m or more and cells of a canopy raster stay as they are"});
    Q_EMIT editsMade(std::move(edits), tr("let trees grow by %1 years").arg(panel_.years()));
}

std::vector<Tree> TreeEditing::chosenTrees() const {
    std::vector<Tree> chosen;
    if (trees() && !ids_.empty())
        std::ranges::copy_if(trees()->trees, std::back_inserter(chosen),
                             [this](const Tree& tree) { return ids_.contains(tree.sourceId); });
    return chosen;
}

// Those of a row so far, or the one under the cursor.
std::vector<Tree> TreeEditing::plannedTrees() const {
    std::vector<glm::dvec2> line = corners_;
    if (cursor_) line.push_back(*cursor_);
    const auto tree = panel_.facts().and_then(designTree);
    if (!tree || line.empty()) return {};
    const auto row = placeTreesAlong(line, panel_.spacingM());
    std::vector<Tree> planned;
    for (const glm::dvec2 place :
         row&& planting_ == TreePanel::Planting::row ? *row : std::vector{line.back()}) {
        planned.push_back(*tree);
        planned.back().place = place;
    }
    return planned;
}

void TreeEditing::show() {
    const std::vector<Tree> chosen = chosenTrees();
    panel_.showChosen(chosen, trees() ? trees()->trees.size() : 0);
    panel_.showPlanting(planting_);
    mark(isPlanting() ? plannedTrees() : chosen);
}

// A little larger than the trees themselves, so that they cover them.
void TreeEditing::mark(std::vector<Tree> trees) {
    constexpr float largerTimes = 1.04F;
    CrownBodies& marked = context_.panel.view().markedTrees();
    if (trees.empty()) return marked.show(nullptr);
    for (Tree& tree : trees) {
        tree.evergreen = true;
        tree.place += movedM_;
        tree.groundM = float(noonmark::groundAt(context_.city->city(), tree.place));
        tree.crownDiameterM *= largerTimes;
        tree.heightM *= largerTimes;
    }
    marked.show(std::make_shared<const Trees>(Trees{.trees = std::move(trees)}));
}

}  // namespace noonmark
